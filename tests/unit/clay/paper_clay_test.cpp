#include "game/clay/paper_clay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <vector>

#include "tests/support/allocation_count.h"
#include "tests/support/paper_gestures.h"

namespace onggi::clay {
namespace {

TEST(PaperClay, StartsAsTheCylinderOfThePaper) {
    const PaperClay clay;
    EXPECT_EQ(clay.element_count(), 2000);
    EXPECT_EQ(clay.height_mm(), 200.0);
    EXPECT_EQ(clay.element_height_mm(), 0.1);
    ASSERT_EQ(clay.radii_mm().size(), 2000U);
    for (const float radius : clay.radii_mm())
        ASSERT_EQ(radius, 60.0F);
    EXPECT_NEAR(clay.volume_mm3(), std::numbers::pi * 60.0 * 60.0 * 200.0, 1e-6);
}

TEST(PaperClay, HasTheVolumeOfItsElements) {
    PaperClay clay({.element_count = 100, .height_mm = 50.0});
    std::vector<float> radii(100);
    std::iota(radii.begin(), radii.end(), 1.0F);
    clay.set_radii_mm(radii);
    // Sum of i^2 for i = 1 to 100: 338350.
    EXPECT_NEAR(clay.volume_mm3(), std::numbers::pi * 338350.0 * 0.5, 1e-6);
}

TEST(PaperClay, AllocatesNothingInATickOrAHash) {
    PaperClay clay;
    const std::vector<ToolInput> gesture = random_gesture(5, 5000);
    const PaperParameters parameters{.rate_hz = 2000.0};
    std::uint64_t hash = 0;
    std::vector<float> snapshot(2000);
    const int before = test::allocation_count();
    for (const ToolInput& tool : gesture)
        clay.tick(tool, parameters);
    hash ^= clay.state_hash();
    clay.copy_radii_mm(snapshot);
    EXPECT_EQ(test::allocation_count(), before);
    EXPECT_NE(hash, PaperClay().state_hash());
    // The count counts.
    const PaperClay copy = clay;
    EXPECT_GT(test::allocation_count(), before);
    EXPECT_EQ(copy.state_hash(), clay.state_hash());
}

TEST(PaperClay, IsCopiedWhole) {
    PaperClay clay;
    for (const ToolInput& tool : random_gesture(6, 500))
        clay.tick(tool, {});
    PaperClay copy = clay;
    const std::uint64_t before = clay.state_hash();
    const ToolInput tool = tool_in_wall(5.0, true);
    const ContactForces of_copy = copy.tick(tool, {});
    EXPECT_EQ(clay.state_hash(), before) << "the copy has its own radii";
    const ContactForces of_clay = clay.tick(tool, {});
    EXPECT_EQ(of_clay.total_n(), of_copy.total_n());
    EXPECT_EQ(clay.state_hash(), copy.state_hash());
}

TEST(PaperClay, CopiesItsRadiiForASnapshot) {
    PaperClay clay;
    for (int tick = 0; tick < 100; ++tick)
        clay.tick(tool_in_wall(3.0, true), {});
    std::vector<float> out(2000);
    clay.copy_radii_mm(out);
    EXPECT_TRUE(std::equal(out.begin(), out.end(), clay.radii_mm().begin()));
    EXPECT_LT(out[1000], 59.0F);
}

TEST(PaperClay, TakesTheNearestToolItKnows) {
    const auto force_of = [](double tool_radius_mm) {
        PaperClay clay;
        return clay.tick({.position_mm = {50.0, 100.0, 0.0}, .radius_mm = tool_radius_mm}, {}).total_n();
    };
    EXPECT_EQ(force_of(0.0), force_of(2.0));
    EXPECT_EQ(force_of(-5.0), force_of(2.0));
    EXPECT_EQ(force_of(1e6), force_of(40.0));
    EXPECT_NE(force_of(2.0), force_of(40.0));
}

}  // namespace
}  // namespace onggi::clay
