// Whether headphones are plugged in, as the sound card's jack tells the kernel: an input device with the
// switch SW_HEADPHONE_INSERT. It needs permission to read /dev/input (the group input). USB and Bluetooth
// headphones have no such switch. One thread at a time.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace onggi::sound {

class Headphones {
  public:
    explicit Headphones(std::string folder = "/dev/input") : folder_(std::move(folder)) {}
    ~Headphones();
    Headphones(const Headphones&) = delete;
    Headphones& operator=(const Headphones&) = delete;

    // Asks the jacks, a few system calls; looks for new jacks every few seconds.
    [[nodiscard]] bool are_in(std::int64_t now_ns);

  private:
    struct Jack {
        std::string name;  // "event3"
        int file = -1;
    };
    void look_for_more();

    std::string folder_;
    std::vector<Jack> jacks_;
    // Devices without the switch. Opening one can wake it, so each is opened once while it is plugged in.
    std::set<std::string> others_;
    std::int64_t looks_ns_ = 0;  // next
};

}  // namespace onggi::sound
