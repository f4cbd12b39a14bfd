// Controls that do not come to rest, through the whole program on a virtual clock: the kiosk goes back to the
// attract screen all the same, and a person wakes it.
#include <gtest/gtest.h>

#include <random>

#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using kiosk::Screen;

constexpr double kFrameS = 0.1;
constexpr double kMinuteS = 60.0;

class AWornControl : public testing::Test {
  protected:
    // Whether the kiosk is back on the attract screen after so long at most. Before each frame something worn
    // does what it does.
    template <typename Each>
    bool goes_back_within(double seconds, const Each& each) {
        for (double since_s = 0.0; since_s < seconds && kiosk.screen() != Screen::kAttract;
             since_s += kFrameS) {
            each();
            kiosk.frame(kFrameS);
        }
        return kiosk.screen() == Screen::kAttract;
    }
    template <typename Each>
    bool stays_for(double seconds, const Each& each) {
        for (double since_s = 0.0; since_s < seconds; since_s += kFrameS) {
            each();
            kiosk.frame(kFrameS);
            if (kiosk.screen() != Screen::kAttract) return false;
        }
        return true;
    }
    [[nodiscard]] double a_visit_s() const {
        const kiosk::Rules& rules = kiosk.settings().rules;
        return rules.idle_s + rules.countdown_s + 2.0;
    }
    void finger_wakes_it() {
        kiosk.touch();
        EXPECT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kChoose; }, kFrameS));
    }
    float about(double middle, double tremble) {
        return static_cast<float>(middle + std::uniform_real_distribution(-tremble, tremble)(chance));
    }

    std::mt19937 chance{46};
    test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path()};
    window::Gamepad pad{.name = "a worn pad"};
};

TEST_F(AWornControl, AStickThatLeansLetsTheKioskGoBackAndIsNamedAndAPersonWakesItByThatStick) {
    const auto leans = [&] {
        pad.left_x = about(0.18, 0.015);
        pad.right_trigger = about(0.05, 0.02);
        kiosk.plug_in({pad});
    };
    const auto wakes_it = [&] {
        pad.left_x = 0.9F;
        kiosk.plug_in({pad});
        return kiosk.until([&] { return kiosk.screen() == Screen::kChoose; }, kFrameS);
    };
    leans();
    kiosk.frame(kFrameS);
    ASSERT_TRUE(wakes_it());
    EXPECT_FALSE(goes_back_within(kiosk.settings().rules.idle_s, leans));
    EXPECT_TRUE(goes_back_within(a_visit_s(), leans)) << "it kept the kiosk awake for ever";
    testing::internal::CaptureStderr();
    EXPECT_TRUE(stays_for(8.5 * kMinuteS, leans));
    EXPECT_EQ(testing::internal::GetCapturedStderr().find("a worn pad"), std::string::npos);
    testing::internal::CaptureStderr();
    EXPECT_TRUE(stays_for(kMinuteS, leans));
    const std::string journal = testing::internal::GetCapturedStderr();
    const std::string line = "a worn pad does not come to rest";
    EXPECT_NE(journal.find(line), std::string::npos) << journal;
    EXPECT_EQ(journal.find(line), journal.rfind(line)) << "once";
    EXPECT_TRUE(wakes_it());
}

TEST_F(AWornControl, ATouchThatIsNotLiftedLetsItGoBack) {
    ASSERT_TRUE(kiosk.begins_to_throw());
    const auto place = kiosk.seen({66.0, 20.0, 0.0});
    ASSERT_TRUE(place);
    kiosk.point(place->x, place->y);
    kiosk.hold(true);
    EXPECT_TRUE(goes_back_within(2.0 + a_visit_s(), [&] {
        kiosk.point(place->x + double{about(0.0, 1.4)}, place->y + double{about(0.0, 1.4)});
    })) << "a drop of water";
    EXPECT_TRUE(stays_for(kMinuteS, [] {}));
    kiosk.hold(false);
    finger_wakes_it();
}

TEST_F(AWornControl, ATouchOnAButtonThatRepeatsLetsItGoBack) {
    ASSERT_TRUE(kiosk.begins_to_throw());
    ASSERT_TRUE(kiosk.point_at(kiosk::Button::kSpeedMore));
    kiosk.hold(true);
    EXPECT_TRUE(goes_back_within(kMinuteS + a_visit_s(), [] {}));
    kiosk.hold(false);
    finger_wakes_it();
}

TEST_F(AWornControl, AKeyUnderABookLetsItGoBack) {
    for (const window::Key key : {window::Key::kUp, window::Key::kTab, window::Key::kSpace}) {
        ASSERT_TRUE(kiosk.begins_to_throw());
        kiosk.does(window::KeyEvent{.key = key, .pressed = true});
        const auto repeats = [&] {
            kiosk.does(window::KeyEvent{.key = key, .pressed = true, .repeat = true});
        };
        EXPECT_TRUE(goes_back_within(2.0 + a_visit_s(), repeats)) << static_cast<int>(key);
        EXPECT_TRUE(stays_for(kMinuteS, repeats)) << static_cast<int>(key);
        kiosk.does(window::KeyEvent{.key = key});
        kiosk.frame(kFrameS);
    }
    finger_wakes_it();
}

TEST_F(AWornControl, AMouseThatJittersDoesNotWakeIt) {
    kiosk.point(160.0, 90.0);
    kiosk.frame(kFrameS);
    EXPECT_TRUE(stays_for(kMinuteS, [&] { kiosk.point(160.0 + double{about(0.0, 1.0)}, 90.0); }));
    finger_wakes_it();
}

}  // namespace
}  // namespace onggi::app
