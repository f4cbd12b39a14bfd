// Eq. (3): F = Fs + Fv + Ff.
#include <gtest/gtest.h>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"

namespace onggi::clay {
namespace {

TEST(Eq3TotalForce, IsTheSumOfItsThreeParts) {
    PaperClay clay;
    clay.tick(tool_in_wall(0.8, true), {});
    const ContactForces forces = clay.tick(tool_in_wall(1.0, true), {});
    // None of the three is nothing, each along its own axis: Fs and Fv outwards, Ff along the surface.
    EXPECT_GT(forces.stiffness_n.x, 0.05);
    EXPECT_GT(forces.viscosity_n.x, 0.3);
    EXPECT_LT(forces.friction_n.z, -0.08);
    EXPECT_EQ(forces.total_n(), forces.stiffness_n + forces.viscosity_n + forces.friction_n);
}

TEST(Eq3TotalForce, IsZeroWithoutContact) {
    PaperClay clay;
    clay.tick(tool_in_wall(-5.0, true), {});
    const ContactForces forces = clay.tick(tool_in_wall(-1.0, true), {});
    EXPECT_EQ(forces.contacts, 0);
    EXPECT_EQ(forces.touched_count, 0);
    EXPECT_EQ(forces.total_n(), dvec3(0.0));
}

TEST(Eq3TotalForce, TurnsWithTheHandAroundTheAxis) {
    // The model is round: the same touch from another side is the same force, turned.
    const auto touch = [](const dvec3& outwards) {
        PaperClay clay;
        clay.tick({.position_mm = outwards * 70.0 + dvec3(0.0, 98.0, 0.0), .wheel_turning = true}, {});
        return clay.tick({.position_mm = outwards * 69.0 + dvec3(0.0, 99.0, 0.0), .wheel_turning = true}, {})
            .total_n();
    };
    const dvec3 from_x = touch({1.0, 0.0, 0.0});
    const dvec3 from_side = touch({0.6, 0.0, 0.8});
    EXPECT_NEAR(from_side.y, from_x.y, 1e-6);
    EXPECT_NEAR(from_side.x, 0.6 * from_x.x - 0.8 * from_x.z, 1e-6);
    EXPECT_NEAR(from_side.z, 0.8 * from_x.x + 0.6 * from_x.z, 1e-6);
}

}  // namespace
}  // namespace onggi::clay
