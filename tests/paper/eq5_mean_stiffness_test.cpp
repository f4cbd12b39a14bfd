// Eq. (5): Fs is the mean of Fs_i over the n elements in contact.
#include <gtest/gtest.h>

#include <cmath>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"
#include "tests/support/paper_reference.h"

namespace onggi::clay {
namespace {

double standing_force_n(double depth_mm, int element_count = 2000, double tool_radius_mm = 10.0) {
    PaperClay clay({.element_count = element_count});
    return clay.tick(tool_in_wall(depth_mm, false, tool_radius_mm), {}).stiffness_n.x;
}

TEST(Eq5MeanStiffness, Is0Point327NewtonForOneMillimetreInStandingClay) {
    EXPECT_NEAR(standing_force_n(1.0), 0.327, 0.0005);
}

TEST(Eq5MeanStiffness, Is0Point0654NewtonInTurningClayAnd0Point0648AfterItGaveWay) {
    // Before Eq. (2): the turning K on a wheel that stands.
    PaperClay standing;
    const ContactForces before =
        standing.tick(tool_in_wall(1.0, false), {.stiffness_standing_n_per_mm = 0.1});
    EXPECT_EQ(before.contacts, 88);
    EXPECT_NEAR(before.stiffness_n.x, 0.0654, 0.00005);

    PaperClay turning;
    const ContactForces after = turning.tick(tool_in_wall(1.0, true), {});
    EXPECT_EQ(after.contacts, 88);
    EXPECT_NEAR(after.stiffness_n.x, 0.0648, 0.00005);
    EXPECT_NEAR(after.stiffness_n.x / before.stiffness_n.x, 0.99, 1e-5);  // 1 - 1/(c1 r1)
}

TEST(Eq5MeanStiffness, TendsToTwoThirdsOfKDForShallowTouchesOfAnyTool) {
    for (const double tool_radius_mm : {2.0, 5.0, 10.0, 40.0}) {
        // Small against the tool, yet deep enough for hundreds of these thin elements.
        const double depth_mm = 0.002 * tool_radius_mm;
        const double limit_n = 2.0 / 3.0 * 0.5 * depth_mm;
        EXPECT_NEAR(standing_force_n(depth_mm, 200000, tool_radius_mm) / limit_n, 1.0, 0.005);
    }
}

TEST(Eq5MeanStiffness, HardlyDependsOnTheNumberOfElements) {
    const auto change = [](double depth_mm) {
        const double fine_n = standing_force_n(depth_mm, 4000);
        return std::fabs(fine_n - standing_force_n(depth_mm, 1000)) / fine_n;
    };
    EXPECT_LT(change(1.0), 0.02);
    EXPECT_LT(change(2.0), 0.02);
    EXPECT_LT(change(5.0), 0.02);
    // In a shallower touch there are few elements to take the mean of.
    EXPECT_NEAR(change(0.5), 0.03, 0.005);
    EXPECT_NEAR(change(0.01), 0.13, 0.005);
}

TEST(Eq5MeanStiffness, IsSummedWellWithMoreElementsThanAnyPotHas) {
    // 80 000 elements in contact: the rounding of eight float lanes must stay far below what a hand feels.
    PaperClay clay({.element_count = 200000});
    PaperReference reference({.element_count = 200000});
    const ToolInput tool = tool_in_wall(45.0, false, 40.0, 100.0003);
    const ContactForces forces = clay.tick(tool, {});
    const ContactForces expected = reference.tick(tool, {});
    EXPECT_EQ(forces.contacts, expected.contacts);
    EXPECT_GT(forces.contacts, 70000);
    EXPECT_NEAR(forces.stiffness_n.x, expected.stiffness_n.x, 0.002);
    EXPECT_NEAR(forces.stiffness_n.y, expected.stiffness_n.y, 0.002);
}

TEST(Eq5MeanStiffness, CancelsAlongTheAxisInTheMiddleOfAStraightWallAndNotAtItsEnd) {
    PaperClay clay;
    EXPECT_NEAR(clay.tick(tool_in_wall(1.0, false), {}).stiffness_n.y, 0.0, 1e-5);
    // Over the rim only the lower half of the sphere touches: it is pushed up.
    EXPECT_GT(clay.tick(tool_in_wall(1.0, false, 10.0, 200.0), {}).stiffness_n.y, 0.05);
    EXPECT_LT(clay.tick(tool_in_wall(1.0, false, 10.0, 0.0), {}).stiffness_n.y, -0.05);
}

}  // namespace
}  // namespace onggi::clay
