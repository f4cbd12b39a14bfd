// Jars of two bowls: which targets, the outline of each bowl, and a pot's roundness error.
#include "game/heritage/jar.h"

#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace onggi::heritage {
namespace {

TEST(JarOfTwo, IsEachPotThatTheTableMarksAsJoined) {
    const auto targets = load_targets(test::in_checkout("assets/heritage"));
    ASSERT_TRUE(targets) << targets.error().message;
    for (const Target& target : *targets)
        EXPECT_EQ(is_of_two_bowls(target), target.id.starts_with("moon-jar")) << target.id;
}

TEST(JarOfTwo, IsItsLowerHalfTwice) {
    const auto targets = load_targets(test::in_checkout("assets/heritage"));
    ASSERT_TRUE(targets);
    const auto target = find_target(*targets, "moon-jar-nmk");
    ASSERT_TRUE(target);
    const JarOfTwo jar = jar_of_two(*target, clay::ClayBody::kStoneware, {.most_g = 1000.0, .wall_mm = 8.0});
    EXPECT_EQ(jar.size.part, "1/2") << "two kilograms are half of the jar";
    const double wet = jar.size.wet_scale;
    EXPECT_NEAR(wet, 0.5 * clay::wet_scale_of_fired(clay::ClayBody::kStoneware), 1e-9);
    // Published: 120 mm across the foot, 302 at 158.6 mm, a mouth of 142.
    EXPECT_NEAR(double{jar.bowl_mm.front().x}, 60.0 * wet, 1e-3);
    EXPECT_NEAR(double{jar.bowl_mm.back().x}, 151.0 * wet, 1e-3);
    EXPECT_NEAR(double{jar.bowl_mm.back().y}, 158.6 * wet, 1e-3);
    EXPECT_NEAR(jar.mouth_mm, 142.0 * wet, 1e-9);
}

TEST(JarOfTwo, IsAsFarFromRoundAsItsBellyStandsAside) {
    clay::StudioClay pot({.mass_g = 500.0, .off_centre_mm = 0.0});
    pot.set_wall(50.0, 6.0, 10.0, 60.0, 400);
    EXPECT_NEAR(off_round_mm(pot), 0.0, 1e-6);
    pot.set_centre({3.0, 4.0});
    EXPECT_NEAR(off_round_mm(pot), 0.0, 1e-6) << "the whole bowl is set aside, including its foot";
}

}  // namespace
}  // namespace onggi::heritage
