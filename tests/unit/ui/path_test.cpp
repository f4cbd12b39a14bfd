#include "engine/ui/path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace onggi::ui {
namespace {

using Kind = PathStep::Kind;

TEST(Path, ReadsLinesFromTheOriginAndFromHere) {
    const auto steps = read_path("M10 20 L30 40 l5 -5 H1 v2 Z");
    ASSERT_TRUE(steps) << steps.error().message;
    ASSERT_EQ(steps->size(), 6U);
    EXPECT_EQ((*steps)[2].to, vec2(35.0F, 35.0F));
    EXPECT_EQ((*steps)[3].to, vec2(1.0F, 35.0F));
    EXPECT_EQ((*steps)[4].to, vec2(1.0F, 37.0F));
    EXPECT_EQ((*steps)[5].kind, Kind::kClose);
}

TEST(Path, TakesMoreNumbersAsMoreLines) {
    const auto steps = read_path("M0 0 1 1 2,2");
    ASSERT_TRUE(steps);
    ASSERT_EQ(steps->size(), 3U);
    EXPECT_EQ((*steps)[2].kind, Kind::kLine);
}

TEST(Path, BendsAQuadraticCurveIntoACubicOne) {
    const auto steps = read_path("M0 0 Q3 3 6 0");
    ASSERT_TRUE(steps);
    EXPECT_EQ((*steps)[1].first_control, vec2(2.0F, 2.0F));
    EXPECT_EQ((*steps)[1].second_control, vec2(4.0F, 2.0F));
}

TEST(Path, WalksAHalfCircleInTwoQuarters) {
    const auto steps = read_path("M0 0 a5 5 0 0 1 10 0");
    ASSERT_TRUE(steps);
    ASSERT_EQ(steps->size(), 3U);
    EXPECT_NEAR((*steps)[1].to.x, 5.0F, 1e-4F);
    EXPECT_NEAR(std::abs((*steps)[1].to.y), 5.0F, 1e-4F);
    EXPECT_EQ((*steps)[2].to, vec2(10.0F, 0.0F));
}

TEST(Path, StaysFiniteForATinyArc) {
    for (const char* words : {"M0 0 A1e-30 1e30 7 1 1 3 3", "M0 0 a1e-30 1e-30 0 0 1 1e-20 0",
                              "M0 0 a5 5 0 0 1 1e-30 0", "M1e6 -1e6 A1e6 0.001 45 1 0 -1e6 1e6"}) {
        const auto steps = read_path(words);
        if (!steps) continue;  // too large for a drawing
        for (const PathStep& step : *steps)
            EXPECT_TRUE(std::isfinite(step.to.x) && std::isfinite(step.second_control.y)) << words;
    }
}

TEST(Path, RejectsInvalidText) {
    for (const char* words : {"L1 2", "M1", "M1 x", "M0 0 C1 2 3 4 5", "M0 0 S1 2 3 4", "M0 0 A1 1 0 0",
                              "12 3", "M0 0 Z 4 4", "M1e99 0", "M2e6 0"}) {
        const auto refused = read_path(words);
        ASSERT_FALSE(refused) << words;
        EXPECT_EQ(refused.error().message.rfind("path, letter ", 0), 0U) << refused.error().message;
    }
}

}  // namespace
}  // namespace onggi::ui
