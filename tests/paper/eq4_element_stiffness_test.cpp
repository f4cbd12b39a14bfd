// Eq. (4): Fs_i = K |d1| (p2 - p1)/|p2 - p1|, with d1 the proximity after the deformation.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"

namespace onggi::clay {
namespace {

// Clay with one ring that protrudes so far that a tool touches only this ring.
constexpr int kRing = 1000;
constexpr double kRingHeightMm = 100.05;

PaperClay one_ring() {
    PaperClay clay;
    std::vector<float> radii(clay.radii_mm().size(), 5.0F);
    radii[kRing] = 60.0F;
    clay.set_radii_mm(radii);
    return clay;
}

ToolInput beside_ring(double depth_mm, double above_mm, bool turning) {
    const double rc = std::sqrt(100.0 - above_mm * above_mm);
    return {.position_mm = {60.0 + rc - depth_mm, kRingHeightMm + above_mm, 0.0}, .wheel_turning = turning};
}

TEST(Eq4ElementStiffness, IsKTimesTheDepthOfTheElement) {
    PaperClay clay = one_ring();
    const ContactForces forces = clay.tick(beside_ring(0.75, 0.0, false), {});
    ASSERT_EQ(forces.contacts, 1);
    EXPECT_NEAR(forces.stiffness_n.x, 0.5 * 0.75, 1e-6);
    EXPECT_NEAR(forces.stiffness_n.y, 0.0, 1e-6);
    EXPECT_EQ(forces.stiffness_n.z, 0.0);
}

TEST(Eq4ElementStiffness, PointsFromTheToolsSurfaceToItsCentre) {
    for (const double above_mm : {-9.0, -6.0, 0.0, 3.0, 8.0}) {
        PaperClay clay = one_ring();
        const ContactForces forces = clay.tick(beside_ring(0.5, above_mm, false), {});
        ASSERT_EQ(forces.contacts, 1);
        const double rc = std::sqrt(100.0 - above_mm * above_mm);
        EXPECT_NEAR(forces.stiffness_n.x, 0.5 * 0.5 * rc / 10.0, 1e-6);
        EXPECT_NEAR(forces.stiffness_n.y, 0.5 * 0.5 * above_mm / 10.0, 1e-6);
    }
}

TEST(Eq4ElementStiffness, TakesTheDepthAfterTheDeformation) {
    PaperClay clay = one_ring();
    const ContactForces forces = clay.tick(beside_ring(0.75, 0.0, true), {});
    ASSERT_EQ(forces.contacts, 1);
    EXPECT_NEAR(forces.stiffness_n.x, 0.1 * 0.75 * 0.99, 1e-6);

    // At the floor the element gives way no further, and pushes back with all its depth.
    PaperClay thin;
    thin.set_radii_mm(std::vector<float>(thin.radii_mm().size(), 2.0F));
    const ToolInput deep{.position_mm = {9.0, 100.0, 0.0}, .wheel_turning = true};
    const ContactForces floor = thin.tick(deep, {});
    const ContactForces again = thin.tick(deep, {});
    EXPECT_GT(floor.stiffness_n.x, 0.1);
    EXPECT_EQ(floor.stiffness_n, again.stiffness_n);
}

TEST(Eq4ElementStiffness, HasItsOwnKForTheStandingWheel) {
    const PaperParameters parameters{.stiffness_turning_n_per_mm = 0.2, .stiffness_standing_n_per_mm = 0.7};
    PaperClay standing = one_ring();
    EXPECT_NEAR(standing.tick(beside_ring(0.5, 0.0, false), parameters).stiffness_n.x, 0.7 * 0.5, 1e-6);
    PaperClay turning = one_ring();
    EXPECT_NEAR(turning.tick(beside_ring(0.5, 0.0, true), parameters).stiffness_n.x, 0.2 * 0.5 * 0.99, 1e-6);
}

// With p1 on the element the force would divide by zero where the tool's centre crosses the wall.
TEST(Eq4ElementStiffness, NeverFlipsHoweverDeepTheToolIs) {
    double before_n = 0.0;
    for (double x = 69.99; x > 0.0; x -= 0.01) {
        PaperClay clay = one_ring();
        const ContactForces forces = clay.tick(
            {.position_mm = {x, kRingHeightMm, 0.0}, .radius_mm = 10.0, .wheel_turning = false}, {});
        ASSERT_GE(forces.contacts, 1);
        if (x < 16.0) break;  // from here the other rings join in
        ASSERT_EQ(forces.contacts, 1);
        ASSERT_GT(forces.stiffness_n.x, before_n) << "at " << x;
        before_n = forces.stiffness_n.x;
    }
    EXPECT_NEAR(before_n, 0.5 * 54.0, 0.02);
}

TEST(Eq4ElementStiffness, IsANumberOnTheAxisAndKeepsItsDirectionThere) {
    // No direction yet: +X.
    PaperClay clay;
    const ContactForces at_first = clay.tick({.position_mm = {0.0, 100.03, 0.0}, .wheel_turning = true}, {});
    EXPECT_GT(at_first.contacts, 0);
    EXPECT_GT(at_first.stiffness_n.x, 1.0);
    EXPECT_EQ(at_first.stiffness_n.z, 0.0);
    EXPECT_EQ(at_first.friction_n, dvec3(0.0));  // r3 = 0

    // Through the axis along Z: on it, the direction of the tick before.
    for (int step = -50; step <= 50; ++step) {
        const double z = step * 0.1;
        const ContactForces forces = clay.tick({.position_mm = {0.0, 100.03, z}, .wheel_turning = true}, {});
        for (const dvec3& force : {forces.stiffness_n, forces.viscosity_n, forces.friction_n}) {
            ASSERT_TRUE(std::isfinite(force.x) && std::isfinite(force.y) && std::isfinite(force.z)) << z;
        }
        ASSERT_EQ(forces.stiffness_n.z > 0.0, step > 0) << "keeps pointing to -Z until it is beyond";
    }
    // So close that the square of the distance underflows.
    const ContactForces close =
        clay.tick({.position_mm = {1e-200, 100.03, -1e-200}, .wheel_turning = true}, {});
    EXPECT_GT(close.stiffness_n.z, 1.0);
    EXPECT_EQ(close.stiffness_n.x, 0.0);
}

}  // namespace
}  // namespace onggi::clay
