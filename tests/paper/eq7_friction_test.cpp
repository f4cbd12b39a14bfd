// Eq. (7): Ff = c3 v2 r3 (p3 - p2)/|p3 - p2| x n, while in contact with turning clay.
#include <gtest/gtest.h>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"

namespace onggi::clay {
namespace {

ContactForces turning_touch(const dvec3& position_mm, const PaperParameters& parameters = {}) {
    PaperClay clay;
    return clay.tick({.position_mm = position_mm, .wheel_turning = true}, parameters);
}

TEST(Eq7Friction, DragsAlongTheTurningSurface) {
    // Counter-clockwise seen from above: the surface moves to -Z at +X, and to +X at +Z.
    const dvec3 at_x = turning_touch({69.0, 100.0, 0.0}).friction_n;
    EXPECT_EQ(at_x.x, 0.0);
    EXPECT_EQ(at_x.y, 0.0);
    EXPECT_NEAR(at_x.z, -0.0001 * 12.566370614359172 * 69.0, 1e-12);
    const dvec3 at_z = turning_touch({0.0, 100.0, 69.0}).friction_n;
    EXPECT_NEAR(at_z.x, 0.0001 * 12.566370614359172 * 69.0, 1e-12);
    EXPECT_EQ(at_z.z, 0.0);
}

TEST(Eq7Friction, StandsAcrossTheRadiusAndTheAxis) {
    const dvec3 position_mm(40.0, 100.0, -50.0);
    const dvec3 friction_n = turning_touch(position_mm).friction_n;
    EXPECT_GT(glm::length(friction_n), 0.05);
    EXPECT_NEAR(glm::dot(friction_n, dvec3(position_mm.x, 0.0, position_mm.z)), 0.0, 1e-12);
    EXPECT_EQ(friction_n.y, 0.0);
}

TEST(Eq7Friction, DoublesWithTheSpeedOfTheWheelAndWithTheRadius) {
    const double once_n = glm::length(turning_touch({30.0, 100.0, 0.0}).friction_n);
    const double fast_n = glm::length(
        turning_touch({30.0, 100.0, 0.0}, {.wheel_speed_rad_s = 2.0 * 12.566370614359172}).friction_n);
    const double far_n = glm::length(turning_touch({60.0, 100.0, 0.0}).friction_n);
    const double rough_n =
        glm::length(turning_touch({30.0, 100.0, 0.0}, {.friction_c3_n_s_per_mm = 0.0002}).friction_n);
    EXPECT_NEAR(fast_n, 2.0 * once_n, 1e-12);
    EXPECT_NEAR(far_n, 2.0 * once_n, 1e-12);
    EXPECT_NEAR(rough_n, 2.0 * once_n, 1e-12);
}

TEST(Eq7Friction, IsZeroOffTheClayOrOnAStandingWheel) {
    EXPECT_EQ(turning_touch({75.0, 100.0, 0.0}).friction_n, dvec3(0.0));
    PaperClay clay;
    const ContactForces standing = clay.tick(tool_in_wall(1.0, false), {});
    EXPECT_GT(standing.contacts, 0);
    EXPECT_EQ(standing.friction_n, dvec3(0.0));
}

}  // namespace
}  // namespace onggi::clay
