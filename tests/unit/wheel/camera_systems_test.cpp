// The transition of the photographed room's camera to another view.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/wheel/wheel_scene.h"

namespace onggi::wheel {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;

class CameraOfARoom : public testing::Test {
  protected:
    CameraOfARoom() {
        EXPECT_EQ(opened_.lack, "");
        place_ = frame(0.0).camera;
    }
    const render::Scene& frame(double dt_s = 1.0 / 60.0) {
        return opened_.scene->apply({.pot = &pot_}, kWidth, kHeight, dt_s);
    }
    WheelScene& scene() { return *opened_.scene; }
    // As if its picture had been made at once.
    void cut_to(View view) {
        scene().look_at(view);
        EXPECT_TRUE(frame().next_view.has_value());
        scene().next_view_is_ready();
    }

    pot::Pot pot_{.outer_mm = std::vector<float>(100, 60.0F), .height_mm = 200.0};
    OpenedScene opened_ = open_scene({}, kWidth, kHeight);
    render::Camera place_;  // where it began
};

TEST_F(CameraOfARoom, StaysUntilTheNextViewIsReadyThenCutsToIt) {
    scene().look_at(View::kLookingIn);
    render::Camera next;
    for (int i = 0; i < 20; ++i) {
        const render::Scene& seen = frame();
        EXPECT_EQ(seen.camera, place_);
        ASSERT_TRUE(seen.next_view.has_value());
        next = seen.next_view->camera;
    }
    EXPECT_FALSE(next == place_);
    scene().next_view_is_ready();
    const render::Scene& seen = frame();
    EXPECT_EQ(seen.camera, next);
    EXPECT_FALSE(seen.next_view.has_value());
    EXPECT_TRUE(seen.fade_in.has_value());
    EXPECT_EQ(scene().camera_now(kWidth, kHeight), next) << "and so for touches";
}

TEST_F(CameraOfARoom, FadesForAQuarterOfASecondAtAnyFrameRate) {
    View view = View::kThrowing;
    for (const int rate_hz : {20, 60, 144}) {
        view = view == View::kThrowing ? View::kLookingIn : View::kThrowing;
        cut_to(view);
        int frames = 0;
        float before = 0.0F;
        for (; frames < 100; ++frames) {
            const std::optional<float> fraction = frame(1.0 / rate_hz).fade_in;
            if (!fraction) break;
            EXPECT_NEAR(*fraction - before, 4.0F / static_cast<float>(rate_hz), 1e-5F);
            before = *fraction;
        }
        EXPECT_NEAR(frames, rate_hz / 4 - 1, 1) << rate_hz;
    }
}

TEST_F(CameraOfARoom, ForgetsAViewThatIsNotWantedAnyMore) {
    scene().look_at(View::kLookingIn);
    EXPECT_TRUE(frame().next_view.has_value());
    scene().look_at(View::kThrowing);
    scene().next_view_is_ready();
    EXPECT_FALSE(frame().next_view.has_value());
    EXPECT_EQ(frame().camera, place_);
}

// The finished view is the one requested before.
TEST_F(CameraOfARoom, WaitsAgainForAnotherFraming) {
    scene().look_at(View::kLookingIn);
    frame();
    scene().next_view_is_ready();
    scene().set_framing({.shift = {0.0, 0.1}});
    EXPECT_EQ(frame().camera, place_);
    EXPECT_TRUE(frame().next_view.has_value());
    scene().next_view_is_ready();
    EXPECT_EQ(frame().camera.lens_shift, vec2(0.0F, 0.1F));
}

TEST_F(CameraOfARoom, IsCutWithoutAFadeForLessMotion) {
    scene().move_less(true);
    cut_to(View::kLookingIn);
    const render::Scene& seen = frame();
    EXPECT_FALSE(seen.camera == place_);
    EXPECT_FALSE(seen.fade_in.has_value());
}

TEST_F(CameraOfARoom, SwaysALittleAndNeverPastThePhotograph) {
    scene().sway(true);
    float most = 0.0F;
    for (int i = 0; i < 60 * 60; ++i) {
        const render::Scene& seen = frame();
        const double nearer = std::tan(0.5 * static_cast<double>(place_.vertical_fov_rad)) /
                              std::tan(0.5 * static_cast<double>(seen.camera.vertical_fov_rad));
        const float aside = std::abs(seen.camera.lens_shift.x - place_.lens_shift.x);
        EXPECT_LE(1.0 + static_cast<double>(aside), nearer + 1e-6) << i;
        most = std::max(most, aside);
    }
    EXPECT_GT(most, 0.03F);
    scene().sway(false);
    for (int i = 0; i < 600; ++i)
        frame();
    EXPECT_EQ(frame().camera, place_);
}

}  // namespace
}  // namespace onggi::wheel
