// Eq. (6): Fv = -c2 v1, while in contact.
#include <gtest/gtest.h>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"

namespace onggi::clay {
namespace {

TEST(Eq6Viscosity, IsMinusC2TimesTheVelocityOfTheTool) {
    for (const double rate_hz : {1000.0, 4000.0}) {
        PaperClay clay;
        ToolInput tool = tool_in_wall(1.0, false);
        clay.tick(tool, {.rate_hz = rate_hz});
        tool.position_mm += dvec3(-0.01, 0.02, 0.03);
        const ContactForces forces = clay.tick(tool, {.rate_hz = rate_hz, .viscosity_c2_n_s_per_mm = 0.003});
        EXPECT_NEAR(forces.viscosity_n.x, 0.003 * 0.01 * rate_hz, 1e-9);
        EXPECT_NEAR(forces.viscosity_n.y, -0.003 * 0.02 * rate_hz, 1e-9);
        EXPECT_NEAR(forces.viscosity_n.z, -0.003 * 0.03 * rate_hz, 1e-9);
    }
}

TEST(Eq6Viscosity, IsZeroOnTheFirstTick) {
    PaperClay clay;
    const ContactForces forces = clay.tick(tool_in_wall(1.0, false), {});
    EXPECT_GT(forces.contacts, 0);
    EXPECT_EQ(forces.viscosity_n, dvec3(0.0));
}

TEST(Eq6Viscosity, RemembersTheToolWhileItIsOffTheClay) {
    PaperClay clay;
    clay.tick(tool_in_wall(-1.0, false), {});
    const ContactForces forces = clay.tick(tool_in_wall(1.0, false), {});
    EXPECT_NEAR(forces.viscosity_n.x, 0.002 * 2.0 * 1000.0, 1e-9);
    EXPECT_EQ(clay.tick(tool_in_wall(-1.0, false), {}).viscosity_n, dvec3(0.0));
}

TEST(Eq6Viscosity, NeverHelpsTheMovement) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        PaperClay clay;
        int felt = 0;
        dvec3 before(0.0);
        for (const ToolInput& tool : random_gesture(seed, 10000)) {
            const ContactForces forces = clay.tick(tool, {});
            const dvec3 v1 = (tool.position_mm - before) * 1000.0;
            ASSERT_LE(glm::dot(forces.viscosity_n, v1), 0.0);
            if (glm::length(forces.viscosity_n) > 0.0) ++felt;
            before = tool.position_mm;
        }
        EXPECT_GT(felt, 1000);
    }
}

}  // namespace
}  // namespace onggi::clay
