// A screen is composed again only when something visible has changed, because composing takes tens of
// milliseconds. On a virtual clock.
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "tests/stress/unseen_kiosk.h"
#include "tests/support/comes_true.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Screen;

class SteadyScreen : public testing::Test {
  protected:
    // The number of screens shown in `seconds`, including the first one.
    std::size_t screens_in(double seconds) {
        std::set<std::shared_ptr<const screens::View>> shown;
        for (const double end_s = kiosk.now_s() + seconds; kiosk.now_s() < end_s;) {
            kiosk.frame();
            shown.insert(kiosk.shown_view());
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return shown.size();
    }
    // A busy machine composes a screen late. Then five seconds must pass without a new screen, which fails if
    // the kiosk keeps composing without reason.
    void expect_steady(Screen screen) {
        ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == screen; }));
        EXPECT_TRUE(test::comes_true([&] { return screens_in(5.0) == 1; }));
    }

    test::TemporaryFolder gallery;
    UnseenKiosk kiosk{gallery.path()};
};

TEST_F(SteadyScreen, StaysWithoutAVisibleChange) {
    kiosk.touch();
    expect_steady(Screen::kChoose);
    ASSERT_TRUE(kiosk.press(Button::kTarget, 0));
    expect_steady(Screen::kThrow);  // with an outline over the clay
    const auto before = kiosk.shown_view();
    ASSERT_TRUE(kiosk.press(Button::kWaterMore));
    EXPECT_TRUE(kiosk.until([&] {
        return kiosk.shown_view() != before &&
               kiosk.shown_view()->state.throwing.water == before->state.throwing.water + 1;
    }));
}

// However late the words are on a busy machine.
TEST(AStartingKiosk, ShowsItsFirstPictureWithItsWords) {
    const test::TemporaryFolder folder;
    UnseenKiosk kiosk(folder.path());
    ASSERT_TRUE(kiosk.until([&] { return kiosk.frames_shown() > 0; }, kSlowly));
    EXPECT_EQ(kiosk.shown_screen(), kiosk::Screen::kAttract);
}

}  // namespace
}  // namespace onggi::app
