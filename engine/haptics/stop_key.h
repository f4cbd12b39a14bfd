// The stop key: heard from the kernel itself, on a thread that does nothing else. A window hears keys on the
// thread that draws, and when that one hangs, nobody hears them. Pause and Stop are meant, on any keyboard; a
// red button on USB is a keyboard with one key.
//
// It needs leave to read /dev/input (the group input, or a udev rule for the button); without it there is no
// stop key besides the window's, and `found()` says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/io_thread.h"

namespace onggi::haptics {

// The keyboards under a folder such as /dev/input that have a stop key and may be read, opened. The caller
// closes them, or hands them to a StopKey.
[[nodiscard]] std::vector<int> open_stop_keys(const std::string& folder = "/dev/input");

class StopKey final : public jobs::IoWork {
  public:
    // `files` give struct input_event, as the kernel does; they are closed in the end. `pressed` is called on
    // this object's thread, once a press.
    StopKey(std::vector<int> files, std::function<void()> pressed);
    ~StopKey() override;
    StopKey(const StopKey&) = delete;
    StopKey& operator=(const StopKey&) = delete;

    // How many keyboards are listened to.
    [[nodiscard]] std::size_t found() const noexcept { return files_.size(); }

    // Waits for a key, 20 ms at most.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}

  private:
    void drain(int& file) noexcept;

    std::vector<int> files_;  // -1: gone
    std::function<void()> pressed_;
};

}  // namespace onggi::haptics
