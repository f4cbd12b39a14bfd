// The machine's wall clock, which may jump: for times that people read, never to measure durations. Any
// thread but the haptic one.
#pragma once

#include <chrono>
#include <cstdint>

namespace onggi::app {

// Since 1970, UTC.
[[nodiscard]] inline std::int64_t wall_clock_s() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::seconds>(now).count();
}

}  // namespace onggi::app
