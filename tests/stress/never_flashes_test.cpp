// Neither the attract screen nor the reaction to a touch flashes: a whole cycle of demonstration and museum
// pots is drawn on a virtual clock, in the photographed room, and its luminance is measured.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "tests/stress/unseen_kiosk.h"
#include "tests/support/comes_true.h"
#include "tests/support/flash_meter.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Screen;

// The wheel runs in real time, so it turns more slowly than the virtual clock; with ONGGI_REAL_TIME=1 both
// match, for a minute.
//
// About twenty samples a second, and sixty during transitions; slightly irregular, so that no periodic flash
// is missed.
constexpr double kSlowS = 0.0487;
constexpr double kQuickS = 0.0163;

class NeverFlashes : public testing::Test {
  protected:
    // Samples the picture for that long.
    void watch(double seconds, double dt_s) {
        for (const double end_s = kiosk.now_s() + seconds; kiosk.now_s() < end_s;) {
            kiosk.frame(dt_s);
            if (std::getenv("ONGGI_REAL_TIME") != nullptr)
                std::this_thread::sleep_until(begun + std::chrono::duration<double>(kiosk.now_s() - begin_s));
            meter.see(kiosk.now_s(), kiosk.picture());
        }
    }
    // Screens are composed beside the frame, in real time: on a busy machine a sample comes before they are
    // ready. After 600 samples the virtual clock runs slowly, so that no timeout fires first.
    template <typename Condition>
    [[nodiscard]] bool watch_until(const Condition& is_shown) {
        int looks = 0;
        return test::comes_true(
            [&] {
                if (is_shown()) return true;
                const double dt_s = ++looks < 600 ? kQuickS : kSlowly;
                watch(dt_s, dt_s);
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                return false;
            },
            std::chrono::minutes(1));
    }
    void watch_until_shown(Screen screen) {
        ASSERT_TRUE(watch_until([&] { return kiosk.shown_screen() == screen; }));
        watch(1.0, kQuickS);
    }

    test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path(), {.plain = false, .shows = true}};
    support::FlashMeter meter;
    const std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
    const double begin_s = kiosk.now_s();
};

TEST_F(NeverFlashes, OnTheAttractScreenOrWhenAVisitorComes) {
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kAttract; }, 0.0));
    const auto shows_pot = [&] { return kiosk.shown_exhibit() >= 0; };
    watch(24.5, kSlowS);
    EXPECT_FALSE(shows_pot());
    EXPECT_TRUE(watch_until(shows_pot)) << "a museum's pot has come";
    watch(2.0, kQuickS);
    watch(16.0, kSlowS);
    EXPECT_TRUE(watch_until([&] { return !shows_pot(); })) << "and has gone";
    watch(2.0, kQuickS);
    kiosk.touch();
    watch_until_shown(Screen::kChoose);
    kiosk.point_at(Button::kFree);
    kiosk.hold(true);
    watch(0.1, kQuickS);
    kiosk.hold(false);
    watch_until_shown(Screen::kThrow);
    std::printf("%s\n", meter.in_words().c_str());
    EXPECT_TRUE(meter.is_calm()) << meter.in_words();
    EXPECT_GT(meter.largest_step(), 1e-4) << "it is no standing picture that was measured";
}

}  // namespace
}  // namespace onggi::app
