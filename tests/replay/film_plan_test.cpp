#include "game/app/replay/film.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace onggi::app {
namespace {

TEST(FilmPlan, GoesEvenlyFromTheFirstTickToTheLastAndThenTurnsThePot) {
    const auto plan = film_plan(80'000, 8.0);
    ASSERT_EQ(plan.size(), 100U);
    const auto finished =
        std::find_if(plan.begin(), plan.end(), [](const FilmPicture& one) { return one.is_finished; });
    EXPECT_EQ(finished - plan.begin(), 81);
    for (std::size_t i = 0; i < 81; ++i)
        EXPECT_EQ(plan[i].ticks, 1000 * i) << i;
    for (std::size_t i = 81; i < 100; ++i) {
        EXPECT_TRUE(plan[i].is_finished);
        EXPECT_EQ(plan[i].ticks, 80'000U);
        EXPECT_NEAR(plan[i].turned, static_cast<double>(i - 81) * 0.08 / 3.0, 1e-12);
    }
}

TEST(FilmPlan, ReachesTheLastTickForAnyNumber) {
    for (const std::uint64_t ticks : {std::uint64_t{1}, std::uint64_t{7}, std::uint64_t{79},
                                      std::uint64_t{81}, std::uint64_t{1401}, std::uint64_t{36'000'000}}) {
        for (const double seconds : {1.0, 2.5, 8.0, 60.0}) {
            const auto plan = film_plan(ticks, seconds);
            EXPECT_EQ(plan.front(), FilmPicture{});
            EXPECT_EQ(plan.back().ticks, ticks);
            EXPECT_TRUE(std::is_sorted(plan.begin(), plan.end(),
                                       [](const auto& a, const auto& b) { return a.ticks < b.ticks; }));
            const auto turning = static_cast<double>(std::count_if(
                plan.begin(), plan.end(), [](const FilmPicture& one) { return one.is_finished; }));
            EXPECT_GE(turning, 3.0);
            EXPECT_LE(turning, 19.0);
            EXPECT_LE(turning, 0.25 * static_cast<double>(plan.size()));
        }
    }
}

TEST(FilmPlan, OfNoTicksShowsThePotAlone) {
    const auto plan = film_plan(0, 2.0);
    EXPECT_EQ(plan.size(), 25U);
    for (const FilmPicture& picture : plan) {
        EXPECT_TRUE(picture.is_finished);
        EXPECT_EQ(picture.ticks, 0U);
    }
}

}  // namespace
}  // namespace onggi::app
