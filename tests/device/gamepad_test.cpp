// Gamepads through the real GLFW: it finds, asks and reads /dev/input/eventN nodes that umockdev describes as
// the kernel would. Runs under a display of its own (tests/window/with_display.sh). Never on hardware.
#include <gtest/gtest.h>
#include <linux/input.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "engine/window/window.h"
#include "game/app/devices/gamepad_finger.h"
#include "tests/device/mock_gamepad.h"
#include "tests/support/comes_true.h"

namespace onggi {
namespace {

using testing::GamepadIdentity;
using testing::MockGamepad;
using window::Gamepad;

const GamepadIdentity kPad{.node = 7,
                           .name = "Microsoft X-Box 360 pad",
                           .vendor_id = 0x045e,
                           .product_id = 0x028e,
                           .version = 0x0110};

class GamepadsThroughGlfw : public ::testing::Test {
  protected:
    GamepadsThroughGlfw() {
        // This folder exists on every machine, and GLFW watches it for new devices.
        std::filesystem::create_directories(std::filesystem::path(umockdev_testbed_get_root_dir(testbed_)) /
                                            "dev" / "input");
    }
    ~GamepadsThroughGlfw() override {
        pads_.clear();
        window_.reset();
        g_object_unref(testbed_);
    }
    void open() {
        auto opened = window::open_window({.width = 64, .height = 36, .title = "pads"});
        ASSERT_TRUE(opened) << opened.error().message;
        window_ = std::move(*opened);
    }
    MockGamepad& plug_in(const GamepadIdentity& identity) {
        return *pads_.emplace_back(std::make_unique<MockGamepad>(testbed_, identity));
    }
    std::vector<Gamepad> now() {
        static_cast<void>(window_->poll_events());
        return window_->gamepads();
    }
    template <typename Condition>
    bool comes_true(Condition condition) {
        return test::comes_true([&] { return condition(now()); });
    }
    template <typename Condition>
    bool first_comes_to(Condition condition) {
        return comes_true(
            [&](const std::vector<Gamepad>& pads) { return !pads.empty() && condition(pads[0]); });
    }

    UMockdevTestbed* testbed_ = umockdev_testbed_new();
    std::vector<std::unique_ptr<MockGamepad>> pads_;
    std::unique_ptr<window::Window> window_;
};

TEST_F(GamepadsThroughGlfw, AreFoundByNameAndNumbers) {
    plug_in(kPad);
    open();
    const std::vector<Gamepad> pads = now();
    ASSERT_EQ(pads.size(), 1U);
    EXPECT_FALSE(pads[0].name.empty());
    EXPECT_EQ(pads[0].vendor_id, 0x045e);
    EXPECT_EQ(pads[0].product_id, 0x028e);
}

TEST_F(GamepadsThroughGlfw, SayWhereSticksAndTriggersAre) {
    MockGamepad& pad = plug_in(kPad);
    open();
    pad.move(ABS_X, 32767);
    ASSERT_TRUE(first_comes_to([](const Gamepad& one) { return one.left_x > 0.99F; }));
    pad.move(ABS_Y, -32768);
    ASSERT_TRUE(first_comes_to([](const Gamepad& one) { return one.left_y < -0.99F; })) << "up is negative";
    pad.move(ABS_RX, -16384);
    ASSERT_TRUE(
        first_comes_to([](const Gamepad& one) { return one.right_x < -0.49F && one.right_x > -0.51F; }));
    pad.move(ABS_RY, 32767);
    ASSERT_TRUE(first_comes_to([](const Gamepad& one) { return one.right_y > 0.99F; }));
    // A trigger is 0 when released, and 1 when pulled.
    pad.move(ABS_Z, 0);
    pad.move(ABS_RZ, 255);
    ASSERT_TRUE(first_comes_to(
        [](const Gamepad& one) { return one.left_trigger < 0.01F && one.right_trigger > 0.99F; }));
}

TEST_F(GamepadsThroughGlfw, SayWhichButtonsAreDown) {
    MockGamepad& pad = plug_in(kPad);
    open();
    const auto only = [&](std::uint32_t button) {
        return first_comes_to([&](const Gamepad& one) { return one.buttons == button; });
    };
    const std::vector<std::pair<std::uint16_t, std::uint32_t>> buttons{
        {BTN_A, Gamepad::kA},         {BTN_B, Gamepad::kB},           {BTN_X, Gamepad::kX},
        {BTN_Y, Gamepad::kY},         {BTN_TL, Gamepad::kLeftBumper}, {BTN_TR, Gamepad::kRightBumper},
        {BTN_SELECT, Gamepad::kBack}, {BTN_START, Gamepad::kStart}};
    for (const auto& [code, button] : buttons) {
        pad.press(code, true);
        EXPECT_TRUE(only(button)) << code;
        pad.press(code, false);
        EXPECT_TRUE(only(0)) << code;
    }
    pad.move(ABS_HAT0Y, -1);
    EXPECT_TRUE(only(Gamepad::kUp));
    pad.move(ABS_HAT0Y, 0);
    pad.move(ABS_HAT0X, 1);
    EXPECT_TRUE(only(Gamepad::kRight));
}

TEST_F(GamepadsThroughGlfw, ComeAndGoWhileTheWindowIsOpen) {
    open();
    EXPECT_TRUE(now().empty());
    MockGamepad& pad = plug_in(kPad);
    ASSERT_TRUE(comes_true([](const std::vector<Gamepad>& pads) { return pads.size() == 1; }));
    pad.pull_out();
    EXPECT_TRUE(comes_true([](const std::vector<Gamepad>& pads) { return pads.empty(); }));
}

TEST_F(GamepadsThroughGlfw, MoveTheTool) {
    MockGamepad& pad = plug_in(kPad);
    open();
    pad.move(ABS_X, 32767);
    ASSERT_TRUE(first_comes_to([](const Gamepad& one) { return one.left_x > 0.99F; }));
    app::GamepadFinger hand;
    const app::GamepadRequest request = hand.request(now(), 0.1);
    EXPECT_TRUE(request.is_used);
    EXPECT_NEAR(request.step_mm.x, 16.0, 0.5) << "160 mm/s to the right";
    EXPECT_FALSE(request.presses);
    pad.press(BTN_A, true);
    ASSERT_TRUE(first_comes_to([](const Gamepad& one) { return one.buttons == Gamepad::kA; }));
    EXPECT_TRUE(hand.request(now(), 0.1).presses);
    pad.press(BTN_A, false);
    pad.move(ABS_RZ, 255);
    ASSERT_TRUE(
        first_comes_to([](const Gamepad& one) { return one.right_trigger > 0.99F && one.buttons == 0; }));
    EXPECT_TRUE(hand.request(now(), 0.1).presses) << "the right trigger does, too";
    pad.pull_out();
    ASSERT_TRUE(comes_true([](const std::vector<Gamepad>& pads) { return pads.empty(); }));
    EXPECT_FALSE(hand.request(now(), 0.1).presses);
}

}  // namespace
}  // namespace onggi
