#include "game/wheel/wheel_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "game/wheel/components.h"
#include "tests/support/places.h"

namespace onggi::wheel {
namespace {

class TheWheelScene : public testing::Test {
  protected:
    const render::Scene& show(const haptic::Snapshot& shown, int width = 1280, int height = 720) {
        return scene_.apply(shown, width, height);
    }

    pot::Pot pot_{.outer_mm = {60.0F, 55.0F, 50.0F, 58.0F}, .height_mm = 200.0};
    haptic::Snapshot shown_{.tool = {.position_mm = {70.0, 90.0, 5.0}, .radius_mm = 12.0}, .pot = &pot_};
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
    scene_.show_hands(false);
    EXPECT_TRUE(show(shown_).spheres.empty());
    EXPECT_TRUE(show(shown_).props.empty());
}

TEST_F(TheWheelScene, HasNoHandBesideAPotThatIsNoLongerWet) {
    shown_.result.has_second = true;
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

TEST_F(TheWheelScene, IsDrawnOnlyFromItsEntities) {
    ecs::Registry& registry = scene_.registry();
    registry.get<Clay>(scene_.clay()).edge_rounding_mm = 0.9F;
    EXPECT_EQ(show(shown_).lathe->edge_rounding_mm, 0.9F);
    registry.destroy(scene_.hand());
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

TEST_F(TheWheelScene, ShowsNoPotWithoutElements) {
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
        shown_.tool.position_mm = *place;
        const auto seen = render::project(show(shown_).camera, 1280, 720, *place);
        EXPECT_NEAR(seen->pixel.x, pixel.x, 1e-3);
        EXPECT_NEAR(seen->pixel.y, pixel.y, 1e-3);
    }
}

class APotApart : public TheWheelScene {
  protected:
    APotApart() {
        shown_.wheel_direction = {0.6, 0.8};
        shown_.tool.wire = tool::Wire::kCutOff;
        scene_.set_tools(load_tool_models(test::in_checkout("assets/tools")).value());
    }
    bool shows_wire() {
        const std::vector<render::Prop>& props = show(shown_).props;
        return std::any_of(props.begin(), props.end(), [](const render::Prop& prop) {
            return prop.model == library_place(ToolModel::kWire, false);
        });
    }

    pot::Pot dry_{.outer_mm = {40.0F, 45.0F}, .height_mm = 90.0, .stage = clay::Firing::kDry};
    render::LatheMaterial material_{.albedo = vec3(0.1F, 0.2F, 0.3F)};
    render::LatheMarks marks_;
    ecs::Entity entity_;
};

TEST_F(APotApart, IsSeenOnTheWheelUntilItIsTakenDown) {
    scene_.put_on_wheel(entity_, {.pot = &dry_, .material = &material_, .marks = &marks_},
                        {.direction = dvec2(1.0, 0.0)});
    const render::Lathe lathe = *show(shown_).lathe;
    EXPECT_EQ(lathe.radii_mm.data(), dry_.outer_mm.data());
    EXPECT_EQ(lathe.material, material_);
    EXPECT_EQ(lathe.marks, &marks_);
    EXPECT_EQ(lathe.turn, vec2(1.0F, 0.0F));
    EXPECT_FALSE(shows_wire()) << "it cuts another pot";
    scene_.put_on_wheel(entity_, {.pot = &dry_});
    EXPECT_EQ(show(shown_).lathe->turn, vec2(0.6F, 0.8F)) << "with the wheel";
    scene_.registry().destroy(entity_);
    EXPECT_EQ(show(shown_).lathe->radii_mm.data(), pot_.outer_mm.data());
    EXPECT_TRUE(shows_wire());
}

TEST_F(APotApart, IsNotSeenWhileItStandsBesideTheWheel) {
    entity_ = scene_.registry().create();
    scene_.registry().add(entity_, PotApart{.pot = &dry_});
    EXPECT_EQ(show(shown_).lathe->radii_mm.data(), pot_.outer_mm.data());
}

TEST_F(APotApart, IsHeldOverTheClay) {
    pot_.top_mm = {50.0F, 100.0F, 150.0F, 200.0F};
    dry_.top_mm = {45.0F, 90.0F};
    for (pot::Pot* pot : {&pot_, &dry_}) {
        pot->centre_mm.assign(pot->outer_mm.size(), vec2(0.0F));
        pot->film.assign(pot->outer_mm.size(), 0.0F);
        pot->liquidity.assign(pot->outer_mm.size(), 0.0F);
        pot->load_index.assign(pot->outer_mm.size(), 0.0F);
    }
    entity_ = scene_.registry().create();
    scene_.registry().add(entity_, PotApart{.pot = &dry_});
    scene_.registry().add(entity_, HeldOver{});
    static_cast<void>(show(shown_));
    EXPECT_DOUBLE_EQ(scene_.seen().pot->height_mm, pot_.height_mm + dry_.height_mm);
}

TEST_F(TheWheelScene, HoldsTheWireInsteadOfTheHands) {
    scene_.set_tools(load_tool_models(test::in_checkout("assets/tools")).value());
    pot_.top_mm = {50.0F, 100.0F, 150.0F, 200.0F};
    scene_.hold_wire(120.0);
    const std::vector<render::Prop>& props = show(shown_).props;
    ASSERT_EQ(props.size(), 2U) << "slip and wire";
    EXPECT_EQ(props[1].model, library_place(ToolModel::kWire, false));
    EXPECT_EQ(props[1].place[3].y, 120.0F);
}

TEST_F(TheWheelScene, HasSlipThatTurnsWithTheHeadUnderWetClay) {
    scene_.set_tools(load_tool_models(test::in_checkout("assets/tools")).value());
    scene_.show_hands(false);
    shown_.wheel_direction = {0.0, 1.0};  // a quarter turn, counter-clockwise from above
    const std::vector<render::Prop>& props = show(shown_).props;
    ASSERT_EQ(props.size(), 1U);
    EXPECT_EQ(props[0].model, library_place(ToolModel::kSlip, false));
    EXPECT_EQ(props[0].place * vec4(1.0F, 0.0F, 0.0F, 1.0F), vec4(0.0F, 0.0F, -1.0F, 1.0F));
    pot_.stage = clay::Firing::kDry;
    EXPECT_TRUE(show(shown_).props.empty()) << "the wheel is clean when the pot has dried";
}

TEST_F(TheWheelScene, ThrowsDropsOffAWetHandAtWork) {
    scene_.set_tools(load_tool_models(test::in_checkout("assets/tools")).value());
    shown_.hand_film = 1.0;
    shown_.wheel_speed_rad_s = 12.0;
    const auto drops = [&] {
        std::size_t most = 0;
        for (int frame = 0; frame < 60; ++frame) {
            const auto& props = scene_.apply(shown_, 1280, 720, 1.0 / 60.0).props;
            most = std::max(most, static_cast<std::size_t>(std::ranges::count(
                                      props, library_place(ToolModel::kDrop, false), &render::Prop::model)));
        }
        return most;
    };
    EXPECT_EQ(drops(), 0U) << "it does not touch";
    shown_.result.forces.contacts = 1;
    EXPECT_GT(drops(), 2U);
    EXPECT_LT(drops(), 20U);
}

TEST_F(TheWheelScene, FollowsTheProgramsHandsInsteadOfTheLoops) {
    scene_.lead_hands(std::array{DrawnHand{.position_mm = {10.0, 20.0, 30.0}}, DrawnHand{.shown = false}});
    ASSERT_EQ(show(shown_).spheres.size(), 1U);
    EXPECT_EQ(show(shown_).spheres[0].centre_mm, vec3(10.0F, 20.0F, 30.0F));
    scene_.lead_hands(std::nullopt);
    EXPECT_EQ(show(shown_).spheres[0].centre_mm, vec3(70.0F, 90.0F, 5.0F));
}

}  // namespace
}  // namespace onggi::wheel
