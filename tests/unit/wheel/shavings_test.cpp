#include "game/wheel/shavings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "game/wheel/tool_models.h"
#include "game/wheel/wheel_scene.h"
#include "tests/support/places.h"

namespace onggi::wheel {
namespace {

constexpr double kEveryS = 1.0 / 60.0;
constexpr double kCutMm3 = 6'000.0;

vec3 place_of(const mat4& place) {
    return vec3(place[3]);
}

double out_mm(const mat4& place) {
    return std::hypot(place_of(place).x, place_of(place).z);
}

class AShaving : public testing::Test {
  protected:
    // Runs `frames` frames, during which cut_mm3 more are cut.
    void pass(int frames, double cut_mm3 = 0.0) {
        for (int i = 0; i < frames; ++i) {
            sight_.shaved_mm3 += cut_mm3 / frames;
            shavings_.follow(sight_, kEveryS, moves_less_);
        }
    }

    ShavingSight sight_{.from_mm = {62.0, 80.0, 0.0}, .wheel_speed_rad_s = 12.0};
    bool moves_less_ = false;
    Shavings shavings_;
};

TEST_F(AShaving, FliesFallsOnTheHeadSlidesOffItAndLiesInThePan) {
    pass(60);
    EXPECT_TRUE(shavings_.places().empty()) << "nothing was cut";
    pass(6, kCutMm3);
    const std::size_t count = shavings_.places().size();
    EXPECT_NEAR(static_cast<double>(count), kCutMm3 / Shavings::kCurlMm3, 1.0);
    pass(30);
    std::size_t on_head = 0;
    for (const mat4& place : shavings_.places())
        on_head += std::abs(place_of(place).y - 3.0F) < 0.1F && out_mm(place) < 147.0 ? 1U : 0U;
    EXPECT_GE(on_head, count / 2) << "most of them are still on their way";
    pass(180);
    ASSERT_EQ(shavings_.places().size(), count);
    for (const mat4& place : shavings_.places()) {
        EXPECT_NEAR(place_of(place).y, -52.8, 0.1) << "on the slip";
        EXPECT_GT(out_mm(place), 146.0);
        EXPECT_LE(out_mm(place), 188.1);
    }
    const auto lies = shavings_.places();
    pass(60);
    EXPECT_EQ(shavings_.places(), lies);
}

TEST_F(AShaving, StaysOnAHeadThatStandsStill) {
    sight_.wheel_speed_rad_s = 0.0;
    pass(10, kCutMm3);
    pass(120);
    const auto lies = shavings_.places();
    pass(60);
    EXPECT_EQ(shavings_.places(), lies);
}

TEST_F(AShaving, DisappearsWithAnUndoAndWithTheTrimmer) {
    pass(10, kCutMm3);
    sight_.shaved_mm3 = 0.5 * kCutMm3;
    pass(1);
    const std::size_t count = shavings_.places().size();
    pass(10, 0.25 * kCutMm3);
    EXPECT_GT(shavings_.places().size(), count) << "later cuts are shown again";
    sight_.shaved_mm3 = 0.0;
    pass(1);
    EXPECT_TRUE(shavings_.places().empty());
}

TEST_F(AShaving, IsOneOfFewHoweverMuchIsCut) {
    pass(1, 1e6);
    EXPECT_LE(shavings_.places().size(), Shavings::kMost) << "after a picture that stood still";
    pass(300, 1e6);
    EXPECT_LE(shavings_.places().size(), Shavings::kMost);
}

TEST_F(AShaving, DoesNotFlyWithReducedMotion) {
    moves_less_ = true;
    pass(1, kCutMm3);
    const auto lies = shavings_.places();
    ASSERT_FALSE(lies.empty());
    pass(30);
    EXPECT_EQ(shavings_.places(), lies);
}

TEST_F(AShaving, IsNotMadeInAStill) {
    sight_.shaved_mm3 = kCutMm3;
    shavings_.follow(sight_, 0.0);
    EXPECT_TRUE(shavings_.places().empty());
}

TEST_F(AShaving, IsSeenBesideTheTrimmerAtAPotThatHasDried) {
    pot::Pot pot{.outer_mm = {60.0F, 60.0F, 60.0F}, .top_mm = {30.0F, 60.0F, 90.0F}, .height_mm = 90.0};
    pot.stage = clay::Firing::kDry;
    const haptic::Snapshot shown{.tool = {.position_mm = {70.0, 80.0, 0.0}, .tool = tool::Tool::kTrimmer},
                                 .pot = &pot};
    WheelScene scene;
    const auto library = load_tool_models(test::in_checkout("assets/tools"));
    ASSERT_TRUE(library) << library.error().message;
    scene.set_tools(*library);
    const auto shows = [&](ToolModel model) {
        std::size_t count = 0;
        for (const render::Prop& prop : scene.apply(shown, 1280, 720, kEveryS).props)
            count += prop.model == library_place(model, false) ? 1U : 0U;
        return count;
    };
    for (int i = 0; i < 60; ++i)
        scene.apply(shown, 1280, 720, kEveryS);
    EXPECT_EQ(shows(ToolModel::kTrimmer), 1U);
    EXPECT_EQ(shows(ToolModel::kCurl), 0U);
    scene.shave(3.5 * Shavings::kCurlMm3, {60.0, 80.0, 0.0});
    EXPECT_EQ(shows(ToolModel::kCurl), 3U);
    EXPECT_EQ(shows(ToolModel::kRib), 0U);
    scene.lay_on_bench(tool::Tool::kRib, true);
    EXPECT_EQ(shows(ToolModel::kRib), 1U);
}

class ASplash : public testing::Test {
  protected:
    // Runs a second; returns the drops that were in the air, summed over its frames.
    std::size_t pass(bool moves_less = false) {
        std::size_t seen = 0;
        for (int i = 0; i < 60; ++i) {
            splash_.follow(sight_, kEveryS, moves_less);
            for (const mat4& place : splash_.places()) {
                EXPECT_GT(out_mm(place), 55.0) << "never into the wall";
                EXPECT_GT(place_of(place).y, out_mm(place) < 147.0 ? 0.0F : -56.0F)
                    << "nor through the wheel";
            }
            seen += splash_.places().size();
        }
        return seen;
    }

    SplashSight sight_{.film = 1.0, .from_mm = {62.0, 80.0, 0.0}, .wheel_speed_rad_s = 12.6};
    Splash splash_;
};

TEST_F(ASplash, IsTheWetterTheHandAndTheFasterTheWheel) {
    const std::size_t all = pass();
    EXPECT_GT(all, 100U);
    sight_.film = 0.3;
    static_cast<void>(pass());
    const std::size_t fewer = pass();
    EXPECT_LT(fewer, all / 2);
    EXPECT_GT(fewer, 0U);
    sight_.wheel_speed_rad_s = 0.0;
    static_cast<void>(pass());
    EXPECT_EQ(pass(), 0U) << "the wheel stands";
}

TEST_F(ASplash, FallsWithinASecondOfADryHand) {
    static_cast<void>(pass());
    sight_.film = 0.0;
    static_cast<void>(pass());
    EXPECT_TRUE(splash_.places().empty());
}

TEST_F(ASplash, IsNotThereWithReducedMotionNorInAStill) {
    EXPECT_EQ(pass(true), 0U);
    splash_.follow(sight_, 0.0);
    EXPECT_TRUE(splash_.places().empty());
}

}  // namespace
}  // namespace onggi::wheel
