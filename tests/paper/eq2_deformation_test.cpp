// Eq. (2): radius_t = radius_(t-1) - |proximity| / (c1 r1), while the wheel turns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"
#include "tests/support/paper_reference.h"

namespace onggi::clay {
namespace {

// The element whose centre is nearest 100 mm, and its proximity for a tool 1 mm deep there.
constexpr std::size_t kMiddle = 1000;

double middle_depth_mm(const PaperClay& clay, const ToolInput& tool) {
    const double dy = 100.05 - tool.position_mm.y;
    const double rc = std::sqrt(tool.radius_mm * tool.radius_mm - dy * dy);
    return rc + static_cast<double>(clay.radii_mm()[kMiddle]) - tool.position_mm.x;
}

double rms_difference_mm(std::span<const float> a, std::span<const float> b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        squares += difference * difference;
    }
    return std::sqrt(squares / static_cast<double>(a.size()));
}

TEST(Eq2Deformation, TakesTheProximityOverC1R1InOneTick) {
    PaperClay clay;
    const ToolInput tool = tool_in_wall(1.0, true);
    const double before_mm = middle_depth_mm(clay, tool);
    clay.tick(tool, {});
    // c1 r1 = 100. To half a unit in the last place of a float near 60.
    EXPECT_NEAR(static_cast<double>(clay.radii_mm()[kMiddle]), 60.0 - before_mm / 100.0, 1.95e-6);
}

TEST(Eq2Deformation, FollowsC1AndTheToolsRadius) {
    for (const double c1 : {0.6, 1.0, 10.0, 55.0}) {
        for (const double r1 : {2.0, 10.0, 40.0}) {
            PaperClay clay;
            const ToolInput tool = tool_in_wall(1.0, true, r1);
            const double before_mm = middle_depth_mm(clay, tool);
            clay.tick(tool, {.softness_c1_per_mm = c1});
            EXPECT_NEAR(static_cast<double>(clay.radii_mm()[kMiddle]), 60.0 - before_mm / (c1 * r1), 1e-5);
        }
    }
}

TEST(Eq2Deformation, LeavesAStillTool36Point6PercentAfter100TicksAndHalfAfter69) {
    PaperClay clay;
    const ToolInput tool = tool_in_wall(1.0, true);
    const double start_mm = middle_depth_mm(clay, tool);
    for (int tick = 1; tick <= 100; ++tick) {
        clay.tick(tool, {});
        if (tick == 68) {
            EXPECT_GT(middle_depth_mm(clay, tool) / start_mm, 0.5);
        }
        if (tick == 69) {
            EXPECT_LT(middle_depth_mm(clay, tool) / start_mm, 0.5);
        }
    }
    EXPECT_NEAR(middle_depth_mm(clay, tool) / start_mm, 0.36603, 1e-5);  // (1 - 1/100)^100
}

TEST(Eq2Deformation, DoesNotHappenWhileTheWheelStands) {
    PaperClay clay;
    for (int tick = 0; tick < 1000; ++tick) {
        const ContactForces forces = clay.tick(tool_in_wall(3.0, false), {});
        ASSERT_GT(forces.contacts, 0);
        ASSERT_EQ(forces.touched_count, 0);
    }
    for (const float radius : clay.radii_mm())
        ASSERT_EQ(radius, 60.0F);
}

TEST(Eq2Deformation, StopsAtTheFloor) {
    PaperClay clay;
    const ToolInput at_axis{.position_mm = {0.0, 100.0, 0.0}, .radius_mm = 10.0, .wheel_turning = true};
    for (int tick = 0; tick < 2000; ++tick)
        clay.tick(at_axis, {});
    EXPECT_EQ(*std::min_element(clay.radii_mm().begin(), clay.radii_mm().end()), 2.0F);
    EXPECT_EQ(clay.radii_mm()[kMiddle], 2.0F);
    EXPECT_EQ(clay.radii_mm()[800], 60.0F);

    // A floor that comes up later stops the clay, but does not make it grow.
    const std::vector<float> before(clay.radii_mm().begin(), clay.radii_mm().end());
    clay.tick(at_axis, {.minimum_radius_mm = 5.0});
    EXPECT_TRUE(std::equal(before.begin(), before.end(), clay.radii_mm().begin()));
}

TEST(Eq2Deformation, OnlyEverMakesTheClaySmaller) {
    PaperClay clay;
    std::vector<float> before(clay.radii_mm().begin(), clay.radii_mm().end());
    for (const ToolInput& tool : random_gesture(7, 20000)) {
        const ContactForces forces = clay.tick(tool, {});
        for (std::size_t i = 0; i < before.size(); ++i) {
            const bool touched = static_cast<int>(i) >= forces.first_touched &&
                                 static_cast<int>(i) < forces.first_touched + forces.touched_count;
            if (touched) {
                ASSERT_LE(clay.radii_mm()[i], before[i]);
            } else {
                ASSERT_EQ(clay.radii_mm()[i], before[i]) << "changed, but not said to be";
            }
            ASSERT_GE(clay.radii_mm()[i], 2.0F);
            before[i] = clay.radii_mm()[i];
        }
    }
}

TEST(Eq2Deformation, MakesTheSamePotAt500HzAndAt8kHz) {
    const auto thrown_at = [](double rate_hz) {
        PaperClay clay;
        for (const ToolInput& tool : vase_gesture(rate_hz))
            clay.tick(tool, {.rate_hz = rate_hz});
        return clay;
    };
    const PaperClay slow = thrown_at(500.0);
    const PaperClay paper = thrown_at(1000.0);
    const PaperClay fast = thrown_at(8000.0);
    EXPECT_LT(rms_difference_mm(slow.radii_mm(), fast.radii_mm()), 0.1);
    EXPECT_LT(rms_difference_mm(paper.radii_mm(), fast.radii_mm()), 0.1);
    EXPECT_GT(rms_difference_mm(PaperClay().radii_mm(), fast.radii_mm()),
              5.0);  // the gesture did throw a pot
}

// With plain floats this stops as soon as a step is below half a unit in the last place, 0.008 mm too early.
TEST(Eq2Deformation, AddsUpStepsThatAFloatAloneWouldLose) {
    const PaperParameters fast{.rate_hz = 10000.0};
    PaperClay clay;
    PaperReference reference;
    const ToolInput tool = tool_in_wall(0.5, true, 40.0);
    for (int tick = 0; tick < 100000; ++tick) {
        clay.tick(tool, fast);
        reference.tick(tool, fast);
    }
    for (std::size_t i = 0; i < clay.radii_mm().size(); ++i) {
        ASSERT_NEAR(static_cast<double>(clay.radii_mm()[i]), reference.elements()[i].radius_mm, 1e-5) << i;
    }
}

}  // namespace
}  // namespace onggi::clay
