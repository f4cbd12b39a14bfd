// A gamepad at the wheel: sticks, triggers and buttons.
#include "game/app/gamepad_hand.h"

#include <gtest/gtest.h>

namespace onggi::app {
namespace {

using window::Gamepad;

constexpr double kFrame = 1.0 / 60.0;

GamepadWish wish_of(const Gamepad& pad) {
    return GamepadHand().wish(std::span(&pad, 1), kFrame);
}

TEST(GamepadHand, IsStillWithinItsDeadBand) {
    const GamepadWish wish = wish_of({.left_x = 0.1F, .left_y = -0.1F, .left_trigger = 0.05F});
    EXPECT_EQ(wish.step_mm, dvec3(0.0));
    EXPECT_FALSE(wish.is_used);
    EXPECT_FALSE(wish.turns_wheel);
}

TEST(GamepadHand, MovesTheToolByTheSticksFinelyByTheRightOne) {
    const GamepadWish all = wish_of({.left_x = 1.0F, .left_y = -1.0F});
    EXPECT_GT(all.step_mm.x, 0.0);
    EXPECT_GT(all.step_mm.y, 0.0) << "up is up";
    const GamepadWish right = wish_of({.left_x = 1.0F});
    EXPECT_NEAR(right.step_mm.x, 160.0 * kFrame, 1e-9);
    EXPECT_EQ(right.step_mm.y, 0.0);
    EXPECT_TRUE(right.is_used);
    EXPECT_NEAR(wish_of({.right_x = 1.0F}).step_mm.x, 0.35 * 160.0 * kFrame, 1e-9);
    const double half = wish_of({.left_x = 0.5F}).step_mm.x;
    EXPECT_GT(half, 0.0);
    EXPECT_LT(half, 0.2 * right.step_mm.x) << "a light push moves finely";
}

TEST(GamepadHand, ForgetsNobodyAndPassesNoLimitWithTwoPads) {
    GamepadHand hand;
    const std::array<Gamepad, 2> pads{
        {{.left_x = 1.0F}, {.slot = 1, .left_x = 1.0F, .buttons = Gamepad::kA}}};
    const GamepadWish wish = hand.wish(pads, kFrame);
    EXPECT_NEAR(wish.step_mm.x, 160.0 * kFrame, 1e-9);
    EXPECT_TRUE(wish.turns_wheel);
}

TEST(GamepadHand, TurnsTheWheelByHowFarATriggerIsPulledOrByAButton) {
    EXPECT_EQ(wish_of({.right_trigger = 0.5F}).wheel_rev_min, 120.0);
    EXPECT_EQ(wish_of({.left_trigger = 1.0F}).wheel_rev_min, 240.0);
    EXPECT_TRUE(wish_of({.left_trigger = 1.0F}).turns_wheel);
    EXPECT_TRUE(wish_of({.buttons = Gamepad::kA}).turns_wheel);
    EXPECT_EQ(wish_of({.buttons = Gamepad::kA}).wheel_rev_min, 0.0);
}

TEST(GamepadHand, AsksOncePerPressOfAButton) {
    GamepadHand hand;
    Gamepad pad{.buttons = Gamepad::kStart | Gamepad::kRightBumper | Gamepad::kX};
    const GamepadWish first = hand.wish(std::span(&pad, 1), kFrame);
    EXPECT_TRUE(first.fresh_lump);
    EXPECT_TRUE(first.next_tool);
    EXPECT_EQ(first.radius_steps, 1.0);
    const GamepadWish held = hand.wish(std::span(&pad, 1), kFrame);
    EXPECT_FALSE(held.fresh_lump);
    EXPECT_FALSE(held.next_tool);
    EXPECT_EQ(held.radius_steps, 0.0);
    pad.buttons = 0;
    EXPECT_TRUE(hand.wish(std::span(&pad, 1), kFrame).is_used) << "letting go is use, too";
    pad.buttons = Gamepad::kDown;
    EXPECT_EQ(hand.wish(std::span(&pad, 1), kFrame).radius_steps, -1.0);
}

}  // namespace
}  // namespace onggi::app
