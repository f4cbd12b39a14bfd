#include "game/wheel/wheel_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "game/wheel/components.h"

namespace onggi::wheel {
namespace {

class TheWheelScene : public testing::Test {
  protected:
    const render::Scene& show(const WheelView& shown, int width = 1280, int height = 720) {
        return scene_.apply(shown, width, height);
    }

    pot::Pot pot_{.outer_mm = {60.0F, 55.0F, 50.0F, 58.0F}, .height_mm = 200.0};
    WheelView shown_{.pot = &pot_, .hand = {.position_mm = {70.0, 90.0, 5.0}, .radius_mm = 12.0}};
    WheelScene scene_;
};

TEST_F(TheWheelScene, ShowsTheClayExactlyAsTheSnapshotHasIt) {
    const render::Scene& scene = show(shown_);
    ASSERT_TRUE(scene.lathe);
    EXPECT_TRUE(std::equal(scene.lathe->radii_mm.begin(), scene.lathe->radii_mm.end(), pot_.outer_mm.begin(),
                           pot_.outer_mm.end()));
    EXPECT_EQ(scene.lathe->element_height_mm, 50.0F);
}

TEST_F(TheWheelScene, PutsTheToolWhereTheHandIs) {
    const render::Scene& scene = show(shown_);
    ASSERT_EQ(scene.spheres.size(), 1U);
    EXPECT_EQ(scene.spheres[0].centre_mm, vec3(70.0F, 90.0F, 5.0F));
    EXPECT_EQ(scene.spheres[0].radius_mm, 12.0F);
    ASSERT_EQ(scene.props.size(), 1U);
    const render::Prop& ball = scene.props[0];
    const std::vector<render::Box>& boxes = scene.prop_library->at(ball.model).boxes_mm;
    render::Box seen = render::placed(boxes.at(0), ball.place);
    for (const render::Box& box : boxes) {
        seen.low = glm::min(seen.low, render::placed(box, ball.place).low);
        seen.high = glm::max(seen.high, render::placed(box, ball.place).high);
    }
    EXPECT_LT(glm::length(seen.low - vec3(58.0F, 78.0F, -7.0F)), 0.1F);
    EXPECT_LT(glm::length(seen.high - vec3(82.0F, 102.0F, 17.0F)), 0.1F);
    shown_.hand.shown = false;
    EXPECT_TRUE(show(shown_).spheres.empty());
    EXPECT_TRUE(show(shown_).props.empty());
}

TEST_F(TheWheelScene, HasNoHandBesideAPotThatIsNoLongerWet) {
    shown_.second_hand.shown = true;
    for (const clay::Firing stage : {clay::Firing::kDry, clay::Firing::kBisque, clay::Firing::kGlaze}) {
        pot_.stage = stage;
        EXPECT_TRUE(show(shown_).props.empty());
        EXPECT_TRUE(show(shown_).spheres.empty()) << "nor its shadow";
    }
    pot_.stage = clay::Firing::kWet;
    EXPECT_EQ(show(shown_).props.size(), 2U);
}

TEST_F(TheWheelScene, TurnsTheClayWithTheWheel) {
    shown_.wheel_direction = {0.6, 0.8};
    EXPECT_EQ(show(shown_).lathe->turn, vec2(0.6F, 0.8F));
}

TEST_F(TheWheelScene, ComesOutOfItsEntitiesAndNowhereElse) {
    ecs::Registry& registry = scene_.registry();
    registry.get<Clay>(scene_.clay()).edge_rounding_mm = 0.9F;
    EXPECT_EQ(show(shown_).lathe->edge_rounding_mm, 0.9F);
    registry.destroy(scene_.tool());
    EXPECT_TRUE(show(shown_).spheres.empty());
    registry.destroy(scene_.clay());
    EXPECT_FALSE(show(shown_).lathe);
}

TEST_F(TheWheelScene, GathersTheStillLifeOnce) {
    const auto first = show(shown_).still_life;
    ASSERT_TRUE(first);
    EXPECT_GE(first->parts.size(), 4U);
    EXPECT_EQ(show(shown_).still_life, first);
}

TEST_F(TheWheelScene, ShowsNothingForAPotWithoutElements) {
    pot_.outer_mm = {};
    EXPECT_FALSE(show(shown_).lathe);
}

TEST_F(TheWheelScene, FramesPotAndToolInEveryShapeOfPicture) {
    struct Size {
        int width;
        int height;
    };
    for (const Size shape :
         {Size{1280, 720}, Size{1920, 1080}, Size{720, 1280}, Size{1024, 768}, Size{640, 640}}) {
        const render::Camera camera = show(shown_, shape.width, shape.height).camera;
        for (const dvec3 corner :
             {dvec3(-60, 0, 0), dvec3(60, 0, 0), dvec3(-60, 200, 0), dvec3(60, 200, 60), dvec3(60, 200, -60),
              dvec3(0, 0, 60), dvec3(120, 100, 0), dvec3(-120, 100, 0)}) {
            const auto seen = render::project(camera, shape.width, shape.height, corner);
            ASSERT_TRUE(seen);
            EXPECT_GT(seen->pixel.x, 0.0);
            EXPECT_LT(seen->pixel.x, shape.width);
            EXPECT_GT(seen->pixel.y, 0.0);
            EXPECT_LT(seen->pixel.y, shape.height);
        }
    }
}

TEST_F(TheWheelScene, FillsMoreThanHalfTheHeightOfAWidePicture) {
    const render::Camera camera = show(shown_).camera;
    const double top = render::project(camera, 1280, 720, {0, 200, 0})->pixel.y;
    const double bottom = render::project(camera, 1280, 720, {0, 0, 0})->pixel.y;
    EXPECT_NEAR((bottom - top) / 720.0, 0.57, 0.04);
}

TEST_F(TheWheelScene, PutsTheToolUnderThePointer) {
    for (const dvec2 pixel : {dvec2(640, 300), dvec2(820, 120), dvec2(410, 480)}) {
        const auto place = scene_.tool_target_mm(pixel.x, pixel.y, 1280, 720);
        ASSERT_TRUE(place);
        shown_.hand.position_mm = *place;
        const auto seen = render::project(show(shown_).camera, 1280, 720, *place);
        EXPECT_NEAR(seen->pixel.x, pixel.x, 1e-3);
        EXPECT_NEAR(seen->pixel.y, pixel.y, 1e-3);
    }
}

TEST(WheelSchedule, ReceivesBeforeItExtracts) {
    const auto names = wheel_schedule().names();
    const auto place_of = [&](std::string_view name) { return std::find(names.begin(), names.end(), name); };
    for (const std::string_view received : {"receive clay", "receive wheel", "receive tools"}) {
        ASSERT_NE(place_of(received), names.end());
        EXPECT_LT(place_of(received), place_of("extract camera"));
    }
}

}  // namespace
}  // namespace onggi::wheel
