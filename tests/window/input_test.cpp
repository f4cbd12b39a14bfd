// Two fingers and a pen on a real display: an X server with a touch screen and a pen (input_driver.h). The
// server's pen has a pressure and no tilt. Runs in real time, but waits for what it expects.
#include <gtest/gtest.h>
#include <xcb/xcb.h>
#include <xcb/xinput.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/window/input_server.h"
#include "engine/window/window.h"
#include "tests/support/comes_true.h"
#include "tests/window/input_driver.h"

namespace onggi::window {
namespace {

const WindowDesc kWindow{.width = 640, .height = 480, .title = "input", .full_screen = false};
constexpr double kMostPressure = 1000.0;  // of the driver's pens

std::string path_in(const char* variable) {
    const char* path = std::getenv(variable);
    return path == nullptr ? variable : path;
}

// The driver's sockets accept one program each, so all tests share them.
test::InputDriver& touch_screen() {
    static test::InputDriver screen(path_in("TOUCH_SCREEN"));
    return screen;
}
test::InputDriver& pen() {
    static test::InputDriver pen(path_in("PEN"));
    return pen;
}

class AWindow : public testing::Test {
  protected:
    void SetUp() override {
        auto window = open_window(kWindow);
        ASSERT_TRUE(window) << window.error().message;
        window_ = std::move(*window);
        ASSERT_EQ(window_->why_no_touches(), "");
    }
    template <typename Kind, typename Condition>
    [[nodiscard]] bool reports(Condition is_it) {
        return test::comes_true([&] {
            for (const Event& event : window_->poll_events())
                events_.push_back(event);
            for (const Event& event : events_) {
                const auto* one = std::get_if<Kind>(&event);
                if (one != nullptr && is_it(*one)) return true;
            }
            return false;
        });
    }
    [[nodiscard]] bool has_pen(bool has) {
        return test::comes_true([&] {
            static_cast<void>(window_->poll_events());
            return window_->pen().has_value() == has;
        });
    }
    // Draws a line that presses ever more, to that pressure.
    static void draw(double pressure) {
        pen().move(0.3, 0.3, 0.0);
        for (double part = 0.25; part <= 1.0; part += 0.25)
            pen().move(0.3 + 0.1 * part, 0.3, part * pressure);
    }

    std::unique_ptr<Window> window_;
    std::vector<Event> events_;
};

TEST_F(AWindow, TellsTwoFingersApart) {
    touch_screen().touch(1, XCB_INPUT_TOUCH_BEGIN, 0.2, 0.2);
    EXPECT_TRUE(reports<ButtonEvent>([](const ButtonEvent& button) { return button.pressed; }));
    touch_screen().touch(2, XCB_INPUT_TOUCH_BEGIN, 0.3, 0.3);
    EXPECT_TRUE(reports<SecondFingerEvent>(
        [](const SecondFingerEvent& finger) { return finger.phase == TouchPhase::kBegin; }));
    touch_screen().touch(2, XCB_INPUT_TOUCH_UPDATE, 0.32, 0.3);
    EXPECT_TRUE(reports<SecondFingerEvent>(
        [](const SecondFingerEvent& finger) { return finger.phase == TouchPhase::kMove; }));
    touch_screen().touch(1, XCB_INPUT_TOUCH_END, 0.2, 0.2);
    EXPECT_TRUE(reports<ButtonEvent>([](const ButtonEvent& button) { return !button.pressed; }));
    touch_screen().touch(2, XCB_INPUT_TOUCH_END, 0.32, 0.3);
    EXPECT_TRUE(reports<SecondFingerEvent>(
        [](const SecondFingerEvent& finger) { return finger.phase == TouchPhase::kEnd; }));
}

TEST_F(AWindow, FeelsThePressureOfAPenUntilAFingerComes) {
    pen().move(0.25, 0.25, 0.0);
    EXPECT_TRUE(reports<PointerEvent>([](const PointerEvent&) { return true; })) << "it hovers like a mouse";
    EXPECT_FALSE(window_->pen());
    pen().press(1, true);
    EXPECT_TRUE(reports<ButtonEvent>([](const ButtonEvent& button) { return button.pressed; }));
    draw(0.5 * kMostPressure);
    ASSERT_TRUE(has_pen(true));
    EXPECT_TRUE(test::comes_true([&] {
        static_cast<void>(window_->poll_events());
        return window_->pen() && std::abs(window_->pen()->pressure - 0.5) < 0.01;
    }));
    pen().press(3, true);
    pen().press(3, false);
    pen().press(1, false);
    EXPECT_TRUE(reports<ButtonEvent>(
        [](const ButtonEvent& button) { return button.button == MouseButton::kLeft && !button.pressed; }));
    EXPECT_TRUE(std::none_of(events_.begin(), events_.end(), [](const Event& event) {
        const auto* button = std::get_if<ButtonEvent>(&event);
        return button != nullptr && button->button != MouseButton::kLeft && button->pressed;
    })) << "a button at its side";
    touch_screen().touch(1, XCB_INPUT_TOUCH_BEGIN, 0.2, 0.2);
    EXPECT_TRUE(has_pen(false));
    touch_screen().touch(1, XCB_INPUT_TOUCH_END, 0.2, 0.2);
}

// Takes the pen away from the pointer, or gives it back. Switching it off would close its socket for good.
void plug(bool in) {
    const auto server = InputServer::connect();
    ASSERT_NE(server, nullptr);
    xcb_connection_t* const to = server->connection();
    const InputServer::Answer<xcb_input_xi_query_device_reply_t> found(
        xcb_input_xi_query_device_reply(to, xcb_input_xi_query_device(to, XCB_INPUT_DEVICE_ALL), nullptr));
    ASSERT_NE(found, nullptr);
    for (auto one = xcb_input_xi_query_device_infos_iterator(found.get()); one.rem > 0;
         xcb_input_xi_device_info_next(&one)) {
        const std::string_view name(xcb_input_xi_device_info_name(one.data), one.data->name_len);
        if (name != "pen") continue;
        constexpr std::uint16_t kCorePointer = 2;
        const std::uint16_t kind =
            in ? XCB_INPUT_HIERARCHY_CHANGE_TYPE_ATTACH_SLAVE : XCB_INPUT_HIERARCHY_CHANGE_TYPE_DETACH_SLAVE;
        const std::array<std::uint16_t, 4> change{kind, 2, one.data->deviceid,
                                                  in ? kCorePointer : std::uint16_t{0}};
        const auto asked = xcb_input_xi_change_hierarchy_checked(
            to, 1, reinterpret_cast<const xcb_input_hierarchy_change_t*>(change.data()));
        const InputServer::Answer<xcb_generic_error_t> refused(xcb_request_check(to, asked));
        EXPECT_EQ(refused, nullptr);
    }
}

TEST_F(AWindow, KnowsAPenThatIsPluggedInLater) {
    plug(false);
    window_.reset();
    SetUp();
    plug(true);
    EXPECT_TRUE(test::comes_true([&] {
        draw(0.6 * kMostPressure);
        static_cast<void>(window_->poll_events());
        return window_->pen().has_value();
    }));
}

}  // namespace
}  // namespace onggi::window
