// Throwing without a finger: the effect of keys and of a single switch on the clay; both can throw a pot.
// Simulated time.
#include <gtest/gtest.h>

#include <cmath>

#include "game/app/kiosk/hand/kiosk_hand.h"
#include "game/haptic/pot_copy.h"
#include "game/haptic/tick.h"

namespace onggi::app {
namespace {

constexpr double kRateHz = 1000.0;
constexpr double kFrameS = 1.0 / 60.0;

class HandOnClay : public ::testing::Test {
  protected:
    explicit HandOnClay(double mass_g = 1000.0) { put(mass_g); }

    void put(double mass_g) {
        parameters_.set_rate_hz(kRateHz);
        parameters_.studio.forgiving = true;
        state_ = haptic::HapticState(clay::StudioClay(clay::StudioLump{.mass_g = mass_g, .rings = 800}));
        hand_ = {};
        shape_ = haptic::pot_of(state_);
        waits(1.0);
    }
    void frame() {
        const haptics::ToolState tool = hand_.request({.water = 3}, shape_, kFrameS);
        for (ticks_due_ += kRateHz * kFrameS; ticks_due_ >= 1.0; ticks_due_ -= 1.0)
            last_ = haptic::tick(state_, tool, parameters_);
        shape_ = haptic::pot_of(state_);
    }
    void waits(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / kFrameS); ++i)
            frame();
    }
    void shows(ShownStep step) {
        hand_.show(step, shape_, 1.0);
        for (int i = 0; i < 600 && hand_.shows(); ++i)
            frame();
        waits(0.3);
    }
    // Repeats the request, waiting each time until it is done.
    template <typename Ask>
    void works(int times, Ask ask) {
        for (int i = 0; i < times; ++i) {
            ask();
            waits(0.1);
            for (int more = 0; more < 600 && hand_.works(); ++more)
                frame();
        }
        waits(0.2);
    }
    void types(HandKey key, int times = 1) {
        works(times, [&] { hand_.key(key, 1.0); });
    }
    void switches(HandKey key, int times = 1) {
        works(times, [&] { hand_.button(key, 1.0); });
    }
    // Up or down until the marker is near that height.
    void walks_to(double y_mm) {
        for (int i = 0; i < 60; ++i) {
            const double now_mm = hand_.marker_mm().value_or(dvec2(0.0)).y;
            if (std::abs(now_mm - y_mm) <= 3.0) return;
            types(now_mm < y_mm ? HandKey::kUp : HandKey::kDown);
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
    KioskHand hand_;
    double ticks_due_ = 0.0;
};

TEST_F(HandOnClay, AHandThatHoversOrRestsLeavesItAlone) {
    const std::vector<float> before = shape_.outer_mm;
    for (double x = -80.0; x < 80.0; x += 2.0) {
        hand_.hover({x, 30.0});
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
        shows(ShownStep::kPress);
        EXPECT_TRUE(outer(0.3 * height()) < before_mm - 3.0 * size || height() > top_before_mm + 6.0 * size)
            << mass_g;
        shows(ShownStep::kOpen);
        const double opened_mm = height();
        EXPECT_GT(opened_mm - shape_.floor_mm, 18.0 * size) << mass_g;
        EXPECT_GT(inner(0.5 * (opened_mm + shape_.floor_mm)), 14.0 * size) << mass_g;
        shows(ShownStep::kRaise);
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
    shows(ShownStep::kPress);
    shows(ShownStep::kOpen);
    shows(ShownStep::kRaise);
    types(HandKey::kDown);
    walks_to(0.6 * height());
    for (const HandKey key : {HandKey::kLeft, HandKey::kRight}) {
        const double y_mm = hand_.marker_mm()->y;
        const double before_mm = outer(y_mm);
        types(key, 3);
        const double moved_mm = (outer(y_mm) - before_mm) / 3.0;
        EXPECT_NEAR(key == HandKey::kLeft ? -moved_mm : moved_mm, 3.0, 1.0);
    }
}

TEST_F(HandOnClay, KeysAloneOpenAndRaiseAPot) {
    types(HandKey::kLeft, 2);
    while (hand_.marker_mm()->y < height())
        types(HandKey::kUp);
    types(HandKey::kUp);
    ASSERT_EQ(hand_.marker_mm()->x, 0.0) << "over the middle";
    for (int i = 0; i < 8; ++i) {
        const double floor_mm = shape_.floor_mm;
        types(HandKey::kDown);
        if (floor_mm > 30.0) {
            EXPECT_NEAR(floor_mm - shape_.floor_mm, 8.0, 3.0) << i;
        }
    }
    EXPECT_LT(shape_.floor_mm, 16.0);
    EXPECT_GT(inner(0.5 * height()), 14.0);
    types(HandKey::kRight);
    EXPECT_GT(hand_.marker_mm()->x, 0.0);
    const double before_mm = height();
    types(HandKey::kUp, 5);
    EXPECT_NEAR(height() - before_mm, 5 * 6.0, 8.0);
    EXPECT_EQ(hand_.marker_mm()->y, height());
}

TEST_F(HandOnClay, OneSwitchAloneThrowsAPot) {
    switches(HandKey::kLeft, 2);
    switches(HandKey::kDown);
    EXPECT_GT(height() - shape_.floor_mm, 18.0);
    const double opened_mm = height();
    switches(HandKey::kUp, 4);
    EXPECT_GT(height(), opened_mm + 35.0);
    const double tall_mm = height();
    switches(HandKey::kDown);
    EXPECT_LT(height(), tall_mm - 2.0);
    EXPECT_GT(height(), tall_mm - 8.0);
}

TEST_F(HandOnClay, ASwitchThatAsksForHigherFirstOpensByItself) {
    const double before_mm = height();
    switches(HandKey::kUp, 3);
    EXPECT_GT(height() - shape_.floor_mm, 30.0);
    EXPECT_GT(height(), before_mm + 15.0);
}

TEST_F(HandOnClay, WhateverComesToThePointerTheClayStaysWhole) {
    const double volume_mm3 = state_.volume_mm3();
    hand_.press({60.0, 20.0});
    frame();
    for (const dvec2& place : {dvec2(50.0, 30.0), dvec2(-900.0, 900.0), dvec2(40.0, std::nan("")),
                               dvec2(1e300, -1e300), dvec2(0.0, 0.0)}) {
        hand_.drag(place);
        waits(0.2);
        hand_.press(place);
        waits(0.2);
    }
    hand_.release();
    waits(0.5);
    EXPECT_TRUE(is_whole());
    EXPECT_NEAR(state_.volume_mm3(), volume_mm3, 1e-6 * volume_mm3);
    EXPECT_GT(height(), 30.0);
}

}  // namespace
}  // namespace onggi::app
