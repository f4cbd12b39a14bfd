// How many frames a second suit a display. Any thread; pure.
#pragma once

#include <algorithm>
#include <cmath>

namespace onggi::jobs {

constexpr double kUsualFrameRateHz = 60.0;

// The display's own rate, or the largest whole fraction of it that is not above most_hz: every frame is then
// shown for as many refreshes as the next. A display that says nothing (0), or what none does, is a usual
// one. most_hz: from kUsualFrameRateHz on.
[[nodiscard]] inline double frame_rate_hz(double refresh_hz, double most_hz) {
    constexpr double kLeastHz = 20.0;
    constexpr double kMostHz = 1000.0;
    constexpr double kRounding = 1.01;  // drivers say 75 of 74.97, and 61 of 60.6
    if (!(refresh_hz >= kLeastHz && refresh_hz <= kMostHz)) return kUsualFrameRateHz;
    return refresh_hz / std::max(1.0, std::ceil(refresh_hz / (kRounding * most_hz)));
}

}  // namespace onggi::jobs
