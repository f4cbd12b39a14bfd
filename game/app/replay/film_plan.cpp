#include "game/app/replay/film_plan.h"

#include <algorithm>
#include <cmath>

namespace onggi::app {

std::vector<FilmPicture> film_plan(std::uint64_t tick_count, double seconds) {
    constexpr double kPicturesPerS = 1000.0 / kFilmPictureMs;
    constexpr double kTurnsPerS = 1.0 / 3.0;
    const auto count_of = [](double film_s) {
        return static_cast<std::uint64_t>(std::lround(film_s * kPicturesPerS));
    };
    const std::uint64_t count = count_of(seconds);
    const std::uint64_t turning = tick_count == 0 ? count : std::min(count_of(kFilmTurningS), count / 4);
    const std::uint64_t steps = count - turning - 1;  // from the first picture of the making to the last
    std::vector<FilmPicture> plan;
    plan.reserve(count);
    for (std::uint64_t picture = 0; picture < count - turning; ++picture) {
        // In whole numbers, and without a product that a long session could overflow.
        plan.push_back({.ticks = tick_count / steps * picture + tick_count % steps * picture / steps});
    }
    for (std::uint64_t picture = 0; picture < turning; ++picture) {
        plan.push_back({.ticks = tick_count,
                        .is_finished = true,
                        .turned = static_cast<double>(picture) * kTurnsPerS / kPicturesPerS});
    }
    return plan;
}

}  // namespace onggi::app
