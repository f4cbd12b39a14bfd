// The kiosk's camera against the design's boxes, with the real workshop's cameras.
#include "game/app/kiosk/presentation/kiosk_camera.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/files/asset_folder.h"
#include "game/screens/page/layout.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::app {
namespace {

using kiosk::Screen;

class CameraTest : public ::testing::TestWithParam<std::pair<int, int>> {
  protected:
    void SetUp() override {
        const auto folder = files::find_asset("workshop");
        ASSERT_TRUE(folder) << folder.error().message;
        auto workshop = wheel::load_workshop(*folder);
        ASSERT_TRUE(workshop) << workshop.error().message;
        scene_ = std::make_unique<wheel::WheelScene>(
            std::make_shared<const wheel::Workshop>(std::move(*workshop)));
        sight_ = {.width_px = GetParam().first,
                  .height_px = GetParam().second,
                  .project = [this](wheel::View view, const wheel::Framing& framing, const dvec3& place_mm) {
                      return scene_->project_framed(view, framing, sight_.width_px, sight_.height_px,
                                                    place_mm);
                  }};
        u_px_ = double{screens::px_per_u_of(sight_.width_px, sight_.height_px)};
    }
    static kiosk::State on(Screen screen) {
        kiosk::State state;
        state.screen = screen;
        return state;
    }
    // The position of a point in the requested view, u.
    dvec2 seen(const CameraRequest& request, const dvec3& place_mm) const {
        return *sight_.project(request.view, request.framing, place_mm) / u_px_;
    }
    double ledge_u(const kiosk::State& state) const {
        const auto shape = screens::shape_of(sight_.width_px, sight_.height_px);
        return double{screens::ledge_y(shape, static_cast<float>(sight_.height_px / u_px_), state.comfort)};
    }
    std::unique_ptr<wheel::WheelScene> scene_;
    BackgroundSight sight_;
    double u_px_ = 1.0;
    KioskCamera camera_;
};

TEST_P(CameraTest, ClearsTheLedgeWithTheWheelHead) {
    kiosk::State state = on(Screen::kThrow);
    for (int text_size = 1; text_size <= kiosk::kMostTextSize; ++text_size) {
        state.comfort.text_size = text_size;
        const CameraRequest request = camera_.request(state, true, 60.0, sight_);
        EXPECT_LT(seen(request, {0.0, -22.0, 150.0}).y, ledge_u(state)) << text_size;
        EXPECT_FALSE(request.sways);
    }
}

TEST_P(CameraTest, KeepsAPotOfAnyHeightBetweenTheTopAndTheLedge) {
    kiosk::State state = on(Screen::kThrow);
    for (double pot_mm = 50.0; pot_mm <= 350.0; pot_mm += 10.0) {
        const CameraRequest request = camera_.request(state, true, pot_mm, sight_);
        EXPECT_GT(seen(request, {0.0, pot_mm, -60.0}).y, 30.0) << pot_mm;
        EXPECT_LT(seen(request, {0.0, 0.0, 60.0}).y, ledge_u(state)) << pot_mm;
        EXPECT_GE(request.framing.zoom, 0.64);
    }
}

TEST_P(CameraTest, DoesNotMoveForEveryMillimetre) {
    const kiosk::State state = on(Screen::kThrow);
    int moves = 0;
    CameraRequest before;
    for (double pot_mm = 50.0; pot_mm <= 350.0; pot_mm += 0.5) {
        const CameraRequest request = camera_.request(state, true, pot_mm, sight_);
        moves += request == before ? 0 : 1;
        before = request;
        EXPECT_EQ(camera_.request(state, true, pot_mm - 20.0, sight_), request)
            << "a pot that sinks keeps its room";
    }
    EXPECT_LE(moves, 12);
}

TEST_P(CameraTest, IsLowerForASeatedVisitor) {
    kiosk::State state = on(Screen::kThrow);
    const CameraRequest usual = camera_.request(state, true, 120.0, sight_);
    state.comfort.reach = true;
    const CameraRequest low = camera_.request(state, true, 120.0, sight_);
    EXPECT_LT(low.framing.zoom, usual.framing.zoom);
    const double rim = seen(low, {0.0, 150.0, 0.0}).y;
    EXPECT_GT(rim, 0.30 * sight_.height_px / u_px_) << "a usual pot is within reach";
    EXPECT_LT(seen(low, {0.0, 0.0, 60.0}).y, ledge_u(state));
}

TEST_P(CameraTest, LooksIntoThePotOverTheLedge) {
    kiosk::State state = on(Screen::kThrow);
    state.throwing.looks_in = true;
    const CameraRequest request = camera_.request(state, true, 100.0, sight_);
    EXPECT_EQ(request.view, wheel::View::kLookingIn);
    const dvec2 rim = seen(request, {0.0, 100.0, 0.0});
    EXPECT_GT(rim.y, 60.0);
    EXPECT_LT(rim.y, ledge_u(state) - 100.0);
    state.screen = Screen::kFailure;
    EXPECT_EQ(camera_.request(state, true, 100.0, sight_).view, wheel::View::kThrowing);
}

TEST_P(CameraTest, SwaysOnlyWhileTheRoomIsSeenAndMotionIsWanted) {
    kiosk::State state = on(Screen::kAttract);
    EXPECT_TRUE(camera_.request(state, true, 100.0, sight_).sways);
    EXPECT_FALSE(camera_.request(state, false, 100.0, sight_).sways) << "a museum's pot covers it";
    state.comfort.still = true;
    EXPECT_FALSE(camera_.request(state, true, 100.0, sight_).sways);
}

INSTANTIATE_TEST_SUITE_P(Pictures, CameraTest,
                         ::testing::Values(std::pair(1280, 720), std::pair(720, 1280), std::pair(1024, 768),
                                           std::pair(3840, 2160)),
                         [](const auto& picture) {
                             return fmt::format("{}x{}", picture.param.first, picture.param.second);
                         });

TEST(Evening, ComesOverTheLastHourAndStaysUntilTheMuseumOpens) {
    kiosk::Config config;
    EXPECT_EQ(evening_at(config, 23 * 60), 0.0) << "always open is always day";
    config.hours.opens_min = 9 * 60;
    config.hours.closes_min = 18 * 60;
    EXPECT_EQ(evening_at(config, 12 * 60), 0.0);
    EXPECT_EQ(evening_at(config, 17 * 60), 0.0);
    EXPECT_NEAR(evening_at(config, 17 * 60 + 30), 0.5, 1e-9);
    EXPECT_EQ(evening_at(config, 17 * 60 + 32), evening_at(config, 17 * 60 + 33)) << "in steps";
    EXPECT_EQ(evening_at(config, 18 * 60), 1.0);
    EXPECT_EQ(evening_at(config, 3 * 60), 1.0);
    config.hours.closes_min = 30;  // after midnight
    EXPECT_GT(evening_at(config, 10), 0.5);
}

}  // namespace
}  // namespace onggi::app
