// With reduced motion the camera cuts: the other view appears between two frames. Otherwise it fades in, with
// the CPU backend. On a virtual clock, a sixtieth of a second per frame.
#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>
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
    // The position of the wheel head's rim in each frame, until the camera has settled.
    std::vector<dvec2> places() {
        std::vector<dvec2> all;
        for (const double end_s = kiosk.now_s() + kSettlesS; kiosk.now_s() < end_s;) {
            kiosk.frame();
            all.push_back(kiosk.seen({150.0, 0.0, 0.0}).value_or(dvec2(-1.0)));
        }
        return all;
    }
    // Counts the frames after that button in which the picture changes much, beyond the change while the
    // camera rests, so that the turning wheel does not count.
    int frames_of_change(Button button) {
        const dvec2 before = kiosk.seen({150.0, 0.0, 0.0}).value();
        EXPECT_TRUE(kiosk.point_at(button));
        kiosk.hold(true);
        kiosk.frame();
        kiosk.hold(false);
        int count = 0;
        int jumps = 0;
        dvec2 place = before;
        asset::Image last = kiosk.picture();
        for (const double end_s = kiosk.now_s() + kSettlesS; kiosk.now_s() < end_s;) {
            kiosk.frame();
            const dvec2 now = kiosk.seen({150.0, 0.0, 0.0}).value();
            jumps += now != place ? 1 : 0;
            place = now;
            asset::Image shown = kiosk.picture();
            count += pixels_apart(last, shown) > kWidth * kHeight / 6 ? 1 : 0;
            last = std::move(shown);
        }
        EXPECT_GT(glm::length(place - before), 5.0) << "it went nowhere";
        EXPECT_EQ(jumps, 1) << "for touches it is in one place or in the other";
        return count;
    }
    // Counts pixels that differ by more than a few levels.
    static int pixels_apart(const asset::Image& a, const asset::Image& b) {
        constexpr int kLevels = 3;
        int count = 0;
        for (std::size_t i = 0; i < a.rgba.size(); i += 4)
            count += std::abs(int{a.rgba[i + 1]} - int{b.rgba[i + 1]}) > kLevels ? 1 : 0;
        return count;
    }

    // Disables the demonstrations, which start after eight seconds and would swallow a press.
    static kiosk::Config without_shows() {
        kiosk::Config config;
        config.visit.shows_by_itself = false;
        return config;
    }

    test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path(), {.plain = false, .config = without_shows()}};
};

TEST_F(Camera, FadesOverIntoThePot) {
    begin(false);
    EXPECT_GT(frames_of_change(Button::kLookIn), 6);
}

TEST_F(Camera, CutsWithReducedMotion) {
    begin(true);
    EXPECT_EQ(frames_of_change(Button::kLookIn), 1);
    EXPECT_EQ(frames_of_change(Button::kLookIn), 1);
}

}  // namespace
}  // namespace onggi::app
