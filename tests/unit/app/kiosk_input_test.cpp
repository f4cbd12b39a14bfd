#include "game/app/kiosk_input.h"

#include <gtest/gtest.h>

namespace onggi::app {
namespace {

using window::Key;

// A picture where a pixel is a millimetre; nothing left of its edge.
std::optional<dvec3> place_of(double x_px, double y_px) {
    if (x_px < 0.0) return std::nullopt;
    return dvec3(x_px - 100.0, 200.0 - y_px, 0.0);
}

class AVisitor : public testing::Test {
  protected:
    KioskAction does(const window::Event& event) { return input_.handle(event, place_of); }
    KioskAction presses(Key key, bool repeat = false) {
        return does(window::KeyEvent{.key = key, .pressed = true, .repeat = repeat});
    }
    [[nodiscard]] const haptics::ToolState& tool() const { return input_.target(); }

    KioskInput input_;
};

TEST_F(AVisitor, MovesTheToolWithThePointer) {
    does(window::PointerEvent{180.0, 60.0});
    EXPECT_EQ(tool().position_mm, dvec3(80.0, 140.0, 0.0));
    does(window::PointerEvent{-5.0, 60.0});
    EXPECT_EQ(tool().position_mm, dvec3(80.0, 140.0, 0.0)) << "a pixel that shows no place moves nothing";
}

TEST_F(AVisitor, CannotPushTheToolIntoTheWheelHeadNorOutOfReach) {
    does(window::PointerEvent{180.0, 900.0});
    EXPECT_EQ(tool().position_mm.y, tool().radius_mm);
    does(window::PointerEvent{9000.0, 60.0});
    EXPECT_LE(tool().position_mm.x, haptics::kWorkspaceMm);
    EXPECT_LT(tool().position_mm.x, 300.0);
}

TEST_F(AVisitor, TurnsTheWheelWhileButtonOrSpaceIsHeld) {
    EXPECT_FALSE(tool().wheel_button);
    does(window::ButtonEvent{window::MouseButton::kLeft, true});
    EXPECT_TRUE(tool().wheel_button);
    presses(Key::kSpace);
    does(window::ButtonEvent{window::MouseButton::kLeft, false});
    EXPECT_TRUE(tool().wheel_button) << "space still holds it";
    does(window::KeyEvent{.key = Key::kSpace, .pressed = false});
    EXPECT_FALSE(tool().wheel_button);
    does(window::ButtonEvent{window::MouseButton::kRight, true});
    EXPECT_FALSE(tool().wheel_button);
}

TEST_F(AVisitor, ChangesTheToolByScrollAndKeysWithinItsLimits) {
    const double before = tool().radius_mm;
    does(window::ScrollEvent{2.0});
    EXPECT_EQ(tool().radius_mm, before + 2.0);
    presses(Key::kLeftBracket);
    presses(Key::kMinus);
    EXPECT_EQ(tool().radius_mm, before);
    presses(Key::kRightBracket, true);
    presses(Key::kPlus);
    EXPECT_EQ(tool().radius_mm, before + 2.0);
    does(window::ScrollEvent{1000.0});
    EXPECT_EQ(tool().radius_mm, haptics::kMaxToolRadiusMm);
    does(window::ScrollEvent{-1000.0});
    EXPECT_EQ(tool().radius_mm, haptics::kMinToolRadiusMm);
}

TEST_F(AVisitor, AsksOnceHoweverLongTheKeyIsHeld) {
    EXPECT_EQ(presses(Key::kR), KioskAction::kFreshLump);
    EXPECT_EQ(presses(Key::kR, true), KioskAction::kNone);
    EXPECT_EQ(presses(Key::kE), KioskAction::kSaveModel);
    EXPECT_EQ(presses(Key::kS), KioskAction::kSavePicture);
    EXPECT_EQ(presses(Key::kF11), KioskAction::kToggleFullScreen);
    EXPECT_EQ(presses(Key::kUnknown), KioskAction::kNone);
    EXPECT_EQ(does(window::KeyEvent{.key = Key::kR, .pressed = false}), KioskAction::kNone);
}

TEST_F(AVisitor, LeavesByEscapeOrByClosingTheWindow) {
    EXPECT_EQ(presses(Key::kEscape), KioskAction::kQuit);
    EXPECT_EQ(does(window::CloseEvent{}), KioskAction::kQuit);
}

}  // namespace
}  // namespace onggi::app
