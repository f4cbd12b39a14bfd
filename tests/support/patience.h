// How long a test waits. A bound of real time is written for the reference machine and goes through scaled():
// on a slower machine, or under a sanitizer, it grows with the time that the same work takes there.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace onggi::test {

// How many times slower this machine and this build are than the reference machine: ONGGI_SLOWNESS, which
// ctest sets. At least 1.
inline double slowness() {
    const char* measured = std::getenv("ONGGI_SLOWNESS");
    // 1 is the first argument: std::max then returns it if the other is NaN.
    return measured == nullptr ? 1.0 : std::max(1.0, std::strtod(measured, nullptr));
}

template <typename Count, typename Period>
std::chrono::milliseconds scaled(std::chrono::duration<Count, Period> on_reference_machine) {
    const std::chrono::duration<double, std::milli> ms = on_reference_machine;
    return std::chrono::milliseconds(static_cast<std::chrono::milliseconds::rep>(slowness() * ms.count()));
}

}  // namespace onggi::test
