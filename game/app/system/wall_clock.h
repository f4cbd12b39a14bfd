// What time the machine believes it is, which may jump: for what people read, never for how long a thing
// took. Any thread but the haptic one.
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
