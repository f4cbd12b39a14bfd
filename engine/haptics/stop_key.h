// The stop key, read from the kernel on its own thread: a window receives keys on the thread that draws, so
// they are lost when that thread hangs. The keys are Pause and Stop on any keyboard; a red USB button is a
// keyboard with one key.
//
// It needs permission to read /dev/input (the group input, or a udev rule for the button). Without it only
// the window's stop key works, and found() is 0. A keyboard that is plugged in later is found within seconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/jobs/io_thread.h"

namespace onggi::haptics {

// A keyboard with a stop key, opened.
struct StopKeyboard {
    std::string name;  // of its file, such as "event3"
    int file = -1;     // yields the kernel's struct input_event
};

// Opens the readable keyboards with a stop key under a folder such as /dev/input, except those in `known`.
// The caller closes them or passes them to a StopKey.
[[nodiscard]] std::vector<StopKeyboard> open_stop_keys(const std::vector<std::string>& known = {},
                                                       const std::string& folder = "/dev/input");

class StopKey final : public jobs::IoWork {
  public:
    static constexpr std::int64_t kLooksEveryNs = 2'000'000'000;

    // As open_stop_keys(). Called by the constructor, and every kLooksEveryNs on this object's thread.
    using Find = std::function<std::vector<StopKeyboard>(const std::vector<std::string>& known)>;
    // `pressed` is called on this object's thread, once per press.
    StopKey(Find find, std::function<void()> pressed);
    ~StopKey() override;
    StopKey(const StopKey&) = delete;
    StopKey& operator=(const StopKey&) = delete;

    // The number of open keyboards. Before the thread is started, or on it.
    [[nodiscard]] std::size_t found() const noexcept { return keyboards_.size(); }

    // Waits for a key, 20 ms at most.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}

  private:
    void look_for_more(std::int64_t now_ns) noexcept;
    void drain(StopKeyboard& keyboard) noexcept;

    Find find_;
    std::vector<StopKeyboard> keyboards_;
    std::int64_t looked_ns_ = 0;
    std::function<void()> pressed_;
};

}  // namespace onggi::haptics
