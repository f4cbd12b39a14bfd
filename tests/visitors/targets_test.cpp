// Visitors follow the outline of a museum's pot with the kiosk's assistance: every offered pot can be thrown.
#include <gtest/gtest.h>

#include <cmath>

#include "game/app/kiosk/presentation/exhibits.h"
#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/heritage/jar.h"
#include "game/heritage/target.h"
#include "tests/support/places.h"
#include "tests/visitors/population.h"

namespace onggi::visitors {
namespace {

// The fraction of an outline's height that leans more than a pot may: see judge.h.
double steep_fraction(const std::vector<vec2>& outline) {
    constexpr float kSteepest = 2.0F;
    const auto steps = static_cast<std::ptrdiff_t>(outline.size()) - 1;
    std::ptrdiff_t steep = 0;
    for (std::size_t i = 1; i < outline.size(); ++i) {
        const vec2 step = outline[i] - outline[i - 1];
        if (std::fabs(step.x) > kSteepest * step.y) ++steep;
    }
    return static_cast<double>(steep) / static_cast<double>(steps);
}

TEST(TargetFollowers, ThrowEveryPotThatTheKioskOffers) {
    constexpr int kEach = 6;
    constexpr double kMostSteep = 0.1;
    int followed = 0;
    const std::string folder = test::in_checkout("assets/heritage");
    const auto targets = heritage::load_targets(folder);
    ASSERT_TRUE(targets) << targets.error().message;
    const auto shelf = heritage::load_shelf(folder, *targets);
    ASSERT_TRUE(shelf) << shelf.error().message;
    std::vector<std::size_t> places;
    const auto exhibits = app::exhibits_of(*targets, {.shelf = *shelf, .cards = {}, .languages = {}}, places);
    ASSERT_GE(exhibits.size(), 4U);
    std::vector<std::vector<Left>> sheet;
    for (const std::size_t place : places) {
        const heritage::Target& target = (*targets)[place];
        if (heritage::is_of_two_bowls(target)) continue;  // moon_jar_test.cpp
        const std::vector<vec2> outline = heritage::wet_outline(target);
        const auto all = throw_pots({.kind = Kind::kFollowsOutline,
                                     .count = kEach,
                                     .first_seed = 41,
                                     .shown_mm = {outline.begin(), outline.end()}});
        EXPECT_LE(median_rms_mm(all), 4.0) << target.id;
        EXPECT_GE(fraction_within_mm(all, 8.0), 0.8) << target.id;
        // A wide bowl leans more than a pot that is judged without an outline may.
        if (steep_fraction(outline) <= kMostSteep) {
            EXPECT_EQ(fraction_of_pots(all), 1.0) << target.id << "\n" << words_for(all);
            ++followed;
        }
        RecordProperty(target.id + "_median_rms_um", static_cast<int>(1000.0 * median_rms_mm(all)));
        sheet.push_back(all);
    }
    EXPECT_GE(followed, 3) << "a bowl, a vase and a jar";
    write_sheet(test::in_build("targets.png"), sheet);
}

}  // namespace
}  // namespace onggi::visitors
