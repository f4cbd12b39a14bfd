// Who asked for less motion sees the camera cut: between two frames it is there. Everybody else sees it
// glide. By a clock of the test's own, a sixtieth of a second a frame.
#include <gtest/gtest.h>

#include <vector>

#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Screen;

constexpr double kSettlesS = 4.0;

class Camera : public testing::Test {
  protected:
    void begin(bool less_motion) {
        kiosk.touch();
        ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kChoose; }));
        if (less_motion) {
            ASSERT_TRUE(kiosk.press(Button::kLanguages));
            ASSERT_TRUE(kiosk.press(Button::kStill));
            ASSERT_TRUE(kiosk.press(Button::kComfortDone));
        }
        ASSERT_TRUE(kiosk.press(Button::kFree));
        places();
        ASSERT_EQ(kiosk.state().comfort.still, less_motion);
    }
    // Where the rim of the wheel head is seen, frame by frame, until the camera has long settled.
    std::vector<dvec2> places() {
        std::vector<dvec2> all;
        for (const double end_s = kiosk.now_s() + kSettlesS; kiosk.now_s() < end_s;) {
            kiosk.frame();
            all.push_back(kiosk.seen({150.0, 0.0, 0.0}).value_or(dvec2(-1.0)));
        }
        return all;
    }
    // In how many frames the camera is on its way after that button.
    int frames_on_the_way(Button button) {
        const dvec2 before = kiosk.seen({150.0, 0.0, 0.0}).value();
        EXPECT_TRUE(kiosk.point_at(button));
        kiosk.hold(true);
        kiosk.frame();
        kiosk.hold(false);
        const std::vector<dvec2> seen = places();
        EXPECT_GT(glm::length(seen.back() - before), 5.0) << "it went nowhere";
        int count = 0;
        for (const dvec2& place : seen)
            count += place != before && place != seen.back() ? 1 : 0;
        return count;
    }

    test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path(), {.plain = false}};
};

TEST_F(Camera, GlidesIntoThePot) {
    begin(false);
    EXPECT_GT(frames_on_the_way(Button::kLookIn), 30);
}

TEST_F(Camera, CutsForWhoAskedForLessMotion) {
    begin(true);
    EXPECT_EQ(frames_on_the_way(Button::kLookIn), 0);
    EXPECT_EQ(frames_on_the_way(Button::kLookIn), 0);
}

}  // namespace
}  // namespace onggi::app
