// Throwing without a finger: the effect of keys and of a single switch on the clay; both can throw a pot.
// Simulated time.
#include <gtest/gtest.h>

#include <cmath>

#include "game/app/kiosk/finger/kiosk_finger.h"
#include "game/haptic/pot_copy.h"
#include "game/haptic/tick.h"

namespace onggi::app {
namespace {

constexpr double kFingerRateHz = 1000.0;
constexpr double kFrameS = 1.0 / 60.0;

class HandOnClay : public ::testing::Test {
  protected:
    explicit HandOnClay(double mass_g = 1000.0) { put(mass_g); }

    void put(double mass_g) {
        parameters_.set_rate_hz(kFingerRateHz);
        parameters_.studio.forgiving = true;
        state_ = haptic::HapticState(clay::StudioClay(clay::StudioLump{.mass_g = mass_g, .rings = 800}));
        finger_ = {};
        shape_ = haptic::pot_of(state_);
        waits(1.0);
    }
    void frame() {
        const tool::ToolState tool = finger_.request({.water = 3}, shape_, kFrameS);
        for (ticks_due_ += kFingerRateHz * kFrameS; ticks_due_ >= 1.0; ticks_due_ -= 1.0)
            last_ = haptic::tick(state_, tool, parameters_);
        shape_ = haptic::pot_of(state_);
    }
    void waits(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / kFrameS); ++i)
            frame();
    }
    void shows(kiosk::ShownStep step) {
        finger_.show(step, shape_, 1.0);
        for (int i = 0; i < 600 && finger_.shows(); ++i)
            frame();
        waits(0.3);
    }
    // Repeats the request, waiting each time until it is done.
    template <typename Ask>
    void works(int times, Ask ask) {
        for (int i = 0; i < times; ++i) {
            ask();
            waits(0.1);
            for (int more = 0; more < 600 && finger_.works(); ++more)
                frame();
        }
        waits(0.2);
    }
    void types(FingerKey key, int times = 1) {
        works(times, [&] { finger_.key(key, 1.0); });
    }
    void switches(FingerKey key, int times = 1) {
        works(times, [&] { finger_.button(key, 1.0); });
    }
    // Up or down until the marker is near that height.
    void walks_to(double y_mm) {
        for (int i = 0; i < 60; ++i) {
            const double now_mm = finger_.marker_mm().value_or(dvec2(0.0)).y;
            if (std::abs(now_mm - y_mm) <= 3.0) return;
            types(now_mm < y_mm ? FingerKey::kUp : FingerKey::kDown);
        }
    }
    [[nodiscard]] double height() const { return shape_.height_mm; }
    [[nodiscard]] double outer(double y_mm) const { return wall_at(shape_, y_mm).outer_mm; }
    [[nodiscard]] double inner(double y_mm) const { return wall_at(shape_, y_mm).inner_mm; }
    [[nodiscard]] bool is_whole() const { return last_.forces.total_n() == last_.forces.total_n(); }

    haptic::HapticState state_{clay::StudioClay(clay::StudioLump{})};
    haptic::HapticParameters parameters_;
    haptic::TickResult last_;
    pot::Pot shape_;
    KioskFinger finger_;
    double ticks_due_ = 0.0;
};

TEST_F(HandOnClay, AHandThatHoversOrRestsLeavesItAlone) {
    const std::vector<float> before = shape_.outer_mm;
    for (double x = -80.0; x < 80.0; x += 2.0) {
        finger_.hover({x, 30.0});
        frame();
    }
    waits(6.0);
    EXPECT_EQ(shape_.outer_mm, before);
}

TEST_F(HandOnClay, TheLessonThrowsAPotOfSmallAndLargeLumps) {
    for (const double mass_g : {500.0, 1000.0, 2500.0}) {
        put(mass_g);
        const double size = std::cbrt(mass_g / 1000.0);
        const double before_mm = outer(0.3 * height());
        const double top_before_mm = height();
        shows(kiosk::ShownStep::kPress);
        EXPECT_TRUE(outer(0.3 * height()) < before_mm - 3.0 * size || height() > top_before_mm + 6.0 * size)
            << mass_g;
        shows(kiosk::ShownStep::kOpen);
        const double opened_mm = height();
        EXPECT_GT(opened_mm - shape_.floor_mm, 18.0 * size) << mass_g;
        EXPECT_GT(inner(0.5 * (opened_mm + shape_.floor_mm)), 14.0 * size) << mass_g;
        shows(kiosk::ShownStep::kRaise);
        EXPECT_TRUE(height() > 1.4 * opened_mm || height() > 75.0 * size)
            << mass_g << ": " << opened_mm << " to " << height();
        EXPECT_GT(shape_.floor_mm, 4.0) << mass_g;
        EXPECT_FALSE(state_.studio()->failure().cause != clay::studio::Cause::kNone) << mass_g;
        const double rests_mm = height();
        waits(2.0);
        EXPECT_NEAR(height(), rests_mm, 0.3) << "nothing goes on when it is let go";
    }
}

TEST_F(HandOnClay, KeysMoveTheWallAsFarAsTheySay) {
    shows(kiosk::ShownStep::kPress);
    shows(kiosk::ShownStep::kOpen);
    shows(kiosk::ShownStep::kRaise);
    types(FingerKey::kDown);
    walks_to(0.6 * height());
    for (const FingerKey key : {FingerKey::kLeft, FingerKey::kRight}) {
        const double y_mm = finger_.marker_mm()->y;
        const double before_mm = outer(y_mm);
        types(key, 3);
        const double moved_mm = (outer(y_mm) - before_mm) / 3.0;
        EXPECT_NEAR(key == FingerKey::kLeft ? -moved_mm : moved_mm, 3.0, 1.0);
    }
}

TEST_F(HandOnClay, KeysAloneOpenAndRaiseAPot) {
    types(FingerKey::kLeft, 2);
    while (finger_.marker_mm()->y < height())
        types(FingerKey::kUp);
    types(FingerKey::kUp);
    ASSERT_EQ(finger_.marker_mm()->x, 0.0) << "over the middle";
    for (int i = 0; i < 8; ++i) {
        const double floor_mm = shape_.floor_mm;
        types(FingerKey::kDown);
        if (floor_mm > 30.0) {
            EXPECT_NEAR(floor_mm - shape_.floor_mm, 8.0, 3.0) << i;
        }
    }
    EXPECT_LT(shape_.floor_mm, 16.0);
    EXPECT_GT(inner(0.5 * height()), 14.0);
    types(FingerKey::kRight);
    EXPECT_GT(finger_.marker_mm()->x, 0.0);
    const double before_mm = height();
    types(FingerKey::kUp, 5);
    EXPECT_NEAR(height() - before_mm, 5 * 6.0, 8.0);
    EXPECT_EQ(finger_.marker_mm()->y, height());
}

// As a keyboard repeats it, thirty times a second, right after the opening.
TEST_F(HandOnClay, AKeyHeldUpAfterOpeningGoesOnRaisingTheWall) {
    types(FingerKey::kLeft, 2);
    while (finger_.marker_mm()->y < height())
        types(FingerKey::kUp);
    types(FingerKey::kUp);
    types(FingerKey::kDown, 8);
    ASSERT_EQ(finger_.marker_mm()->x, 0.0) << "still over the middle";
    double before_mm = height();
    for (const double least_mm : {10.0, 5.0}) {
        for (int i = 0; i < 210; ++i) {
            if (i % 2 == 0) finger_.key(FingerKey::kUp, 1.0);
            frame();
        }
        EXPECT_GT(height() - before_mm, least_mm) << "in three and a half seconds";
        before_mm = height();
    }
}

TEST_F(HandOnClay, OneSwitchAloneThrowsAPot) {
    switches(FingerKey::kLeft, 2);
    switches(FingerKey::kDown);
    EXPECT_GT(height() - shape_.floor_mm, 18.0);
    const double opened_mm = height();
    switches(FingerKey::kUp, 4);
    EXPECT_GT(height(), opened_mm + 35.0);
    const double tall_mm = height();
    switches(FingerKey::kDown);
    EXPECT_LT(height(), tall_mm - 2.0);
    EXPECT_GT(height(), tall_mm - 8.0);
}

TEST_F(HandOnClay, ASwitchThatAsksForHigherFirstOpensByItself) {
    const double before_mm = height();
    switches(FingerKey::kUp, 3);
    EXPECT_GT(height() - shape_.floor_mm, 30.0);
    EXPECT_GT(height(), before_mm + 15.0);
}

TEST_F(HandOnClay, AnyPointerInputLeavesTheClayValid) {
    const double volume_mm3 = state_.volume_mm3();
    finger_.press({60.0, 20.0});
    frame();
    for (const dvec2& place : {dvec2(50.0, 30.0), dvec2(-900.0, 900.0), dvec2(40.0, std::nan("")),
                               dvec2(1e300, -1e300), dvec2(0.0, 0.0)}) {
        finger_.drag(place);
        waits(0.2);
        finger_.press(place);
        waits(0.2);
    }
    finger_.release();
    waits(0.5);
    EXPECT_TRUE(is_whole());
    EXPECT_NEAR(state_.volume_mm3(), volume_mm3, 1e-6 * volume_mm3);
    EXPECT_GT(height(), 30.0);
}

}  // namespace
}  // namespace onggi::app
