// A visitor's touch that is interrupted, through the whole program: the hand releases, the clay stays intact,
// and the next touch works.
#include <gtest/gtest.h>

#include <limits>

#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Screen;

class BadTouch : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(kiosk.begins_to_throw()); }
    [[nodiscard]] bool presses() { return kiosk.snapshot().tool.guided && kiosk.snapshot().tool.pressing; }
    void point_at(const dvec3& place_mm) {
        const auto px = kiosk.seen(place_mm);
        ASSERT_TRUE(px);
        kiosk.point(px->x, px->y);
    }
    void lay_finger_on_wall() {
        point_at({66.0, 20.0, 0.0});
        kiosk.frame();
        kiosk.hold(true);
        ASSERT_TRUE(kiosk.until([&] { return presses(); }));
        point_at({60.0, 20.0, 0.0});
        kiosk.frame();
        ASSERT_TRUE(presses());
    }
    // Checks that the hand has released and presses again only after another touch.
    void expect_let_go(const char* what) {
        EXPECT_TRUE(kiosk.until([&] { return !presses(); })) << what;
        for (int frame = 0; frame < 20; ++frame) {
            point_at({60.0 - 0.5 * frame, 20.0, 0.0});
            kiosk.frame();
            EXPECT_FALSE(presses()) << what;
        }
        kiosk.hold(false);
        kiosk.frame();
        EXPECT_NEAR(kiosk.snapshot().on_wheel_mm3, clay_mm3_, 1.0) << what;
        EXPECT_EQ(kiosk.snapshot().fault, haptics::Fault::kNone) << what;
    }

    test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path()};
    double clay_mm3_ = clay::StudioClay(clay::StudioLump{}).volume_mm3();
};

TEST_F(BadTouch, LetsGoAndTakesTheNext) {
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    lay_finger_on_wall();
    kiosk.does(window::FocusEvent{false});
    expect_let_go("the window lost attention");
    lay_finger_on_wall();
    kiosk.point(-40.0, 90.0);
    expect_let_go("it left the window");
    lay_finger_on_wall();
    kiosk.does(window::ButtonEvent{window::MouseButton::kRight, true});
    kiosk.does(window::ButtonEvent{window::MouseButton::kRight, false});
    expect_let_go("a second button came");
    lay_finger_on_wall();
    point_at({-80.0, 20.0, 0.0});
    expect_let_go("it leapt across the clay");
    lay_finger_on_wall();
    kiosk.point(kNoNumber, kNoNumber);
    expect_let_go("it is nowhere");
    lay_finger_on_wall();
    kiosk.hold(true);
    kiosk.hold(false);
    kiosk.frame();
    EXPECT_TRUE(kiosk.until([&] { return !presses(); })) << "its release was lost once";
}

TEST_F(BadTouch, IsNotAMouseThatOnlyPasses) {
    for (int x = -120; x < 120; x += 4) {
        point_at({static_cast<double>(x), 25.0, 0.0});
        kiosk.frame();
        EXPECT_FALSE(presses());
        EXPECT_EQ(kiosk.snapshot().result.forces.contacts, 0);
    }
}

// Hands moved by a key work on for a second; a visitor can pick up a tool meanwhile.
TEST_F(BadTouch, LeavesTheTrayOpenThatIsAskedForWhileItGoesOn) {
    kiosk.press_key(window::Key::kLeft);
    ASSERT_TRUE(kiosk.until([&] { return kiosk.snapshot().result.forces.contacts > 0; }, kSlowly));
    kiosk.press_key(window::Key::kT);
    for (int frame = 0; frame < 5; ++frame)
        kiosk.frame(kSlowly);
    ASSERT_TRUE(presses()) << "it is over already";
    EXPECT_TRUE(kiosk.state().throwing.tray);
    kiosk.press_key(window::Key::kUp);
    EXPECT_FALSE(kiosk.state().throwing.tray) << "another touch";
}

}  // namespace
}  // namespace onggi::app
