// Eq. (1): proximity = -(r1 cos(theta) + r2) + r3. An element is in contact where it is negative.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"

namespace onggi::clay {
namespace {

constexpr PaperParameters kParameters;

struct Touched {
    int count = 0;
    int first = -1;
    int last = -1;
};

// Eq. (1) for every element, as printed.
Touched by_equation(const PaperClay& clay, const ToolInput& tool) {
    Touched touched;
    const double r1 = tool.radius_mm;
    const double r3 = std::hypot(tool.position_mm.x, tool.position_mm.z);
    for (int i = 0; i < clay.element_count(); ++i) {
        const double dy = (i + 0.5) * clay.element_height_mm() - tool.position_mm.y;
        if (std::fabs(dy) > r1) continue;
        const double r2 = static_cast<double>(clay.radii_mm()[static_cast<std::size_t>(i)]);
        if (-(std::sqrt(r1 * r1 - dy * dy) + r2) + r3 >= 0.0) continue;
        ++touched.count;
        if (touched.first < 0) touched.first = i;
        touched.last = i;
    }
    return touched;
}

TEST(Eq1Proximity, IsNegativeForTheElementsOfACapOfTheSphere) {
    PaperClay clay;
    const ContactForces forces = clay.tick(tool_in_wall(1.0, true), kParameters);
    // 1 mm of a 10 mm sphere: |dy| < sqrt(10^2 - 9^2) = 4.359 mm, 44 elements of 0.1 mm above and 44 below.
    EXPECT_EQ(forces.contacts, 88);
    EXPECT_EQ(forces.first_touched, 1000 - 44);
    EXPECT_EQ(forces.touched_count, 88);
}

TEST(Eq1Proximity, IsNotNegativeForASphereThatOnlyMeetsTheWall) {
    PaperClay clay;
    EXPECT_EQ(clay.tick(tool_in_wall(0.0, true), kParameters).contacts, 0);
    EXPECT_EQ(clay.tick(tool_in_wall(-1e-3, true), kParameters).contacts, 0);
    EXPECT_EQ(clay.tick(tool_in_wall(1e-3, true), kParameters).contacts, 2);
}

TEST(Eq1Proximity, FindsTheSameElementsAsALoopOverAll) {
    for (const double depth_mm : {0.003, 0.21, 1.0, 7.7, 25.0, 58.0}) {
        for (const double tool_radius_mm : {2.0, 9.97, 40.0}) {
            for (double height_mm = -45.013; height_mm < 250.0; height_mm += 3.71) {
                PaperClay clay;
                const ToolInput tool = tool_in_wall(depth_mm, true, tool_radius_mm, height_mm);
                const Touched expected = by_equation(clay, tool);
                const ContactForces forces = clay.tick(tool, kParameters);
                ASSERT_EQ(forces.contacts, expected.count)
                    << depth_mm << ' ' << tool_radius_mm << ' ' << height_mm;
                if (expected.count == 0) continue;
                ASSERT_EQ(forces.first_touched, expected.first);
                ASSERT_EQ(forces.first_touched + forces.touched_count - 1, expected.last);
            }
        }
    }
}

// The storage is padded to a multiple of eight. The padding is never clay.
TEST(Eq1Proximity, NeverCountsTheFillingOfTheLastBlock) {
    for (int count = 100; count <= 117; ++count) {
        for (const KernelVariant variant : {KernelVariant::kPlain, KernelVariant::kWide}) {
            if (!is_supported(variant)) continue;
            PaperClay clay({.element_count = count});
            clay.use_kernel(variant);
            const ToolInput above = tool_in_wall(30.0, true, 40.0, 207.03);
            const Touched expected = by_equation(clay, above);
            ASSERT_EQ(expected.last, count - 1);
            EXPECT_EQ(clay.tick(above, kParameters).contacts, expected.count)
                << count << ' ' << name(variant);
        }
    }
}

TEST(Eq1Proximity, FindsARingThatStandsOutOfTheWall) {
    PaperClay clay;
    std::vector<float> radii(clay.radii_mm().begin(), clay.radii_mm().end());
    radii[777] = 63.0F;
    clay.set_radii_mm(radii);
    const ToolInput beside = tool_in_wall(-2.0, true, 10.0, clay.element_height_mm() * 777.5);
    const ContactForces forces = clay.tick(beside, kParameters);
    EXPECT_EQ(forces.contacts, 1);
    EXPECT_EQ(forces.first_touched, 777);

    // The same when only a part of the rings is set.
    PaperClay other;
    other.set_radii_mm(std::vector<float>{63.0F}, 777);
    EXPECT_EQ(other.tick(beside, kParameters).contacts, 1);
}

TEST(Eq1Proximity, IsSafeForAToolFarAwayOrNowhere) {
    constexpr double kHuge = std::numeric_limits<double>::max();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double kNaN = std::numeric_limits<double>::quiet_NaN();
    PaperClay clay;
    const PaperClay untouched = clay;
    for (const double x : {0.0, 65.0, 1e4, 1e9, -1e200, kHuge, -kHuge, kInfinity, kNaN}) {
        for (const double y : {-1e300, -1e10, -41.0, 241.0, 1e7, 3e9, kHuge, -kHuge, -kInfinity, kNaN}) {
            for (const double z : {0.0, 1e160, kNaN}) {
                const ContactForces forces = clay.tick(
                    {.position_mm = {x, y, z}, .radius_mm = 40.0, .wheel_turning = true}, kParameters);
                EXPECT_EQ(forces.contacts, 0) << x << ' ' << y << ' ' << z;
                EXPECT_EQ(forces.total_n(), dvec3(0.0));
            }
        }
    }
    EXPECT_TRUE(std::equal(clay.radii_mm().begin(), clay.radii_mm().end(), untouched.radii_mm().begin()));

    // A tool nowhere is not remembered: the velocity of the next tick is not one from nowhere.
    PaperClay other;
    other.tick(tool_in_wall(1.0, false), kParameters);
    other.tick({.position_mm = {kNaN, 100.0, 0.0}}, kParameters);
    other.tick({.position_mm = {kHuge, 100.0, 0.0}}, kParameters);
    EXPECT_EQ(other.tick(tool_in_wall(1.0, false), kParameters).viscosity_n, dvec3(0.0));
}

}  // namespace
}  // namespace onggi::clay
