// A gamepad at the wheel: sticks, triggers and buttons.
#include "game/app/devices/gamepad_finger.h"

#include <gtest/gtest.h>

#include "game/app/kiosk/finger/kiosk_pointer.h"

namespace onggi::app {
namespace {

using window::Gamepad;

constexpr double kFrame = 1.0 / 60.0;

GamepadRequest request_of(const Gamepad& pad) {
    return GamepadFinger().request(std::span(&pad, 1), kFrame);
}

struct AGamepad : testing::Test {
    GamepadRequest asks(double seconds = kFrame) { return hand.request(std::span(&pad, 1), seconds); }

    GamepadFinger hand;
    Gamepad pad;
};

TEST(GamepadFinger, IsStillWithinItsDeadBand) {
    const GamepadRequest request = request_of({.left_x = 0.1F, .left_y = -0.1F, .left_trigger = 0.05F});
    EXPECT_EQ(request.step_mm, dvec2(0.0));
    EXPECT_FALSE(request.is_used);
    EXPECT_FALSE(request.presses);
}

TEST(GamepadFinger, MovesTheToolByTheSticksFinelyByTheRightOne) {
    const GamepadRequest all = request_of({.left_x = 1.0F, .left_y = -1.0F});
    EXPECT_GT(all.step_mm.x, 0.0);
    EXPECT_GT(all.step_mm.y, 0.0) << "up is up";
    const GamepadRequest right = request_of({.left_x = 1.0F});
    EXPECT_NEAR(right.step_mm.x, 160.0 * kFrame, 1e-9);
    EXPECT_EQ(right.step_mm.y, 0.0);
    EXPECT_TRUE(right.is_used);
    EXPECT_NEAR(request_of({.right_x = 1.0F}).step_mm.x, 0.35 * 160.0 * kFrame, 1e-9);
    const double half = request_of({.left_x = 0.5F}).step_mm.x;
    EXPECT_GT(half, 0.0);
    EXPECT_LT(half, 0.2 * right.step_mm.x) << "a light push moves finely";
}

TEST(GamepadFinger, CombinesTwoPadsWithinTheLimits) {
    GamepadFinger hand;
    const std::array<Gamepad, 2> pads{
        {{.left_x = 1.0F}, {.slot = 1, .left_x = 1.0F, .buttons = Gamepad::kA}}};
    const GamepadRequest request = hand.request(pads, kFrame);
    EXPECT_NEAR(request.step_mm.x, 160.0 * kFrame, 1e-9);
    EXPECT_TRUE(request.presses);
}

TEST_F(AGamepad, PressesWithItsButtonOrATriggerThatIsPulledFarEnough) {
    EXPECT_TRUE(request_of({.buttons = Gamepad::kA}).presses);
    EXPECT_TRUE(request_of({.right_trigger = 0.6F}).presses);
    EXPECT_FALSE(request_of({.right_trigger = 0.4F}).presses);
    EXPECT_FALSE(request_of({.left_trigger = 1.0F, .buttons = Gamepad::kB}).presses);
    pad.right_trigger = 0.6F;
    EXPECT_TRUE(asks().presses);
    pad.right_trigger = 0.4F;
    EXPECT_TRUE(asks().presses) << "a finger that trembles is still there";
    pad.right_trigger = 0.2F;
    EXPECT_FALSE(asks().presses);
    EXPECT_FALSE(hand.request({}, kFrame).presses) << "and none when it is pulled out";
}

TEST_F(AGamepad, LetsGoOfAButtonThatIsStuck) {
    pad.buttons = Gamepad::kA;
    for (int second = 0; second < 59; ++second)
        EXPECT_TRUE(asks(1.0).presses);
    pad.left_x = 1.0F;
    EXPECT_TRUE(asks(1.0).presses) << "somebody moves it";
    pad.left_x = 0.0F;
    for (int second = 0; second < 60; ++second)
        static_cast<void>(asks(1.0));
    EXPECT_FALSE(asks(1.0).presses);
    pad.left_x = 1.0F;
    EXPECT_FALSE(asks(1.0).presses) << "until it is let go";
    pad.buttons = 0;
    static_cast<void>(asks(1.0));
    pad.buttons = Gamepad::kA;
    EXPECT_TRUE(asks(1.0).presses);
}

TEST_F(AGamepad, AsksOncePerPressOfAButton) {
    pad.buttons = Gamepad::kStart | Gamepad::kRightBumper | Gamepad::kUp | Gamepad::kRight | Gamepad::kX;
    const GamepadRequest first = asks();
    EXPECT_TRUE(first.fresh_lump);
    EXPECT_EQ(first.ring_steps, 1);
    EXPECT_TRUE(first.takes);
    EXPECT_EQ(first.radius_steps, 1.0);
    EXPECT_EQ(first.speed_steps, 1.0);
    const GamepadRequest held = asks();
    EXPECT_FALSE(held.fresh_lump);
    EXPECT_EQ(held.ring_steps, 0);
    EXPECT_FALSE(held.takes);
    EXPECT_EQ(held.radius_steps, 0.0);
    EXPECT_EQ(held.speed_steps, 0.0);
    pad.buttons = 0;
    EXPECT_TRUE(asks().is_used) << "letting go is use, too";
    pad.buttons = Gamepad::kDown;
    EXPECT_EQ(asks().radius_steps, -1.0);
    pad.buttons = Gamepad::kLeftBumper;
    EXPECT_EQ(asks().speed_steps, -1.0);
}

// The value before this test's rule: a sign of life in every frame, for ever.
TEST_F(AGamepad, IsUsedWhileItChangesOnly) {
    pad.left_x = 1.0F;
    EXPECT_TRUE(asks().is_used);
    for (int frame = 0; frame < 500; ++frame) {
        const GamepadRequest held = asks(0.1);
        EXPECT_FALSE(held.is_used);
        EXPECT_FALSE(held.is_for_clay);
        EXPECT_NEAR(held.step_mm.x, 16.0, 1e-9) << "a thumb that is held still moves the finger on";
    }
    for (int frame = 0; frame < 100; ++frame)
        static_cast<void>(asks(0.1));
    EXPECT_EQ(asks().step_mm, dvec2(0.0)) << "a minute later nobody is there";
    pad.left_x = 0.8F;
    EXPECT_TRUE(asks().is_used);
    EXPECT_GT(asks().step_mm.x, 0.0);
}

TEST_F(AGamepad, IsNobodyWhereItsSticksLeanAndItsTriggerTrembles) {
    const auto signs_in_an_hour = [&] {
        int signs = 0;
        for (int frame = 0; frame < 36'000; ++frame) {
            pad.left_x = 0.16F + 0.01F * static_cast<float>(frame % 3);
            pad.right_trigger = 0.05F + 0.04F * static_cast<float>(frame % 2);
            const GamepadRequest request = asks(0.1);
            signs += request.is_used || request.is_for_clay ? 1 : 0;
        }
        return signs;
    };
    EXPECT_EQ(signs_in_an_hour(), 0);
    pad.left_x = -0.5F;
    EXPECT_TRUE(asks().is_used) << "a person";
}

TEST_F(AGamepad, NamesWhatDoesNotComeToRest) {
    pad.name = "a worn pad";
    const auto passes_minutes = [&](int minutes) {
        for (int second = 0; second < 60 * minutes; ++second)
            static_cast<void>(asks(1.0));
    };
    passes_minutes(11);
    EXPECT_TRUE(hand.restless().empty());
    for (const Gamepad& worn :
         {Gamepad{.right_y = 0.3F}, Gamepad{.right_trigger = 0.4F}, Gamepad{.buttons = Gamepad::kStart}}) {
        pad = worn;
        pad.name = "a worn pad";
        passes_minutes(9);
        EXPECT_TRUE(hand.restless().empty());
        passes_minutes(2);
        EXPECT_EQ(hand.restless(), std::vector<std::string>{"a worn pad"});
        pad = {.name = "a worn pad"};
        static_cast<void>(asks());
        EXPECT_TRUE(hand.restless().empty()) << "it was let go";
    }
}

TEST_F(AGamepad, WhoseContactsChatterPressesNothingAfterTenMinutesButByItsOtherButtons) {
    int presses = 0;
    const auto chatters = [&](int frames) {
        presses = 0;
        for (int frame = 0; frame < frames; ++frame) {
            pad.buttons = frame % 2 == 0 ? Gamepad::kRightBumper : 0U;
            const GamepadRequest request = asks(0.1);
            presses += request.speed_steps != 0.0 || request.is_used ? 1 : 0;
        }
    };
    chatters(6100);
    EXPECT_GT(presses, 5000);
    chatters(6000);
    EXPECT_EQ(presses, 0);
    EXPECT_EQ(hand.restless().size(), 1U);
    pad.buttons = Gamepad::kUp;
    EXPECT_EQ(asks().radius_steps, 1.0);
    EXPECT_EQ(hand.request({}, kFrame).radius_steps, 0.0);
    EXPECT_TRUE(hand.restless().empty()) << "it was pulled out";
}

TEST_F(AGamepad, WalksToEachButtonOfTheScreenAndPressesIt) {
    screens::Composition composition;
    for (const kiosk::Button button : {kiosk::Button::kUndo, kiosk::Button::kDone})
        composition.targets.emplace_back().button = button;
    KioskPointer pointer;
    pointer.look_at(&composition, 0, false);
    std::vector<PointerNews> news;
    const auto presses = [&](std::uint32_t buttons) {
        for (const std::uint32_t now : {buttons, 0U}) {
            pad.buttons = now;
            for (const window::KeyEvent& key : keys_of(asks()))
                pointer.handle(key, 0.0, news);
        }
    };
    const auto pressed = [&] {
        std::vector<kiosk::Button> all;
        for (const PointerNews& one : news)
            if (one.kind == PointerNews::Kind::kPressed) all.push_back(one.button);
        return all;
    };
    presses(Gamepad::kX);
    EXPECT_TRUE(pressed().empty()) << "nothing has the ring";
    const GamepadRequest request = request_of({.buttons = Gamepad::kX});
    EXPECT_TRUE(request.is_used);
    EXPECT_FALSE(request.is_for_clay) << "who walks the buttons has not touched the clay";
    presses(Gamepad::kRight);
    presses(Gamepad::kRight);
    presses(Gamepad::kX);
    presses(Gamepad::kLeft);
    presses(Gamepad::kX);
    EXPECT_EQ(pressed(), (std::vector{kiosk::Button::kDone, kiosk::Button::kUndo}));
}

}  // namespace
}  // namespace onggi::app
