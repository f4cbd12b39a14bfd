// Frames paced by the display's refresh: display_layer.cpp simulates a display with another rate than the
// program's own clock, and one that is off. Under the validation layer. Runs under with_display.sh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "engine/jobs/clock.h"
#include "engine/jobs/frame_pacer.h"
#include "game/wheel/live_view.h"
#include "tests/support/comes_true.h"
#include "tests/support/test_backend.h"

namespace onggi::wheel {
namespace {

class ADisplay : public testing::Test {
  protected:
    void SetUp() override {
        unsetenv("ONGGI_DISPLAY_IS_OFF");
        ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "run by with_display.sh, which brings a display";
        open(false);
    }
    void open(bool is_safe) {
        view_.reset();
        auto view = LiveView::open({.width = 320,
                                    .height = 240,
                                    .validation = true,
                                    .plain = is_safe,
                                    .backend = test::backend_of_environment(),
                                    .title = "Onggi on a display"});
        ASSERT_TRUE(view) << view.error().message;
        view_ = std::move(*view);
        ASSERT_EQ(view_->frame_rate_hz(), 60.0) << "what there is here tells no rate";
        draw(60);  // compiles what is compiled at first use
    }
    // The measurements over a number of frames drawn like the kiosk's.
    struct Drawn {
        double on_beat = 0.0;      // fraction of frames paced by the display
        int waits_in_vain = 0;     // waits of a tenth of a second that timed out
        double off_refresh = 0.0;  // median distance of frame starts from a refresh, in periods
    };
    Drawn draw(int frames, int display_hz = 60) {
        std::vector<double> off;
        Drawn drawn;
        double before_s = 0.0;
        for (int frame = 0; frame < frames; ++frame) {
            const double asked_s = jobs::MonotonicClock::now_s();
            const bool on_beat = view_->wait_for_display();
            if (!on_beat && jobs::MonotonicClock::now_s() - asked_s > 0.09) ++drawn.waits_in_vain;
            drawn.on_beat += on_beat ? 1.0 / frames : 0.0;
            pacer_.wait(on_beat);
            const double now_s = jobs::MonotonicClock::now_s();
            const double refreshes = (now_s - before_s) * display_hz;
            off.push_back(std::abs(refreshes - std::round(refreshes)));
            before_s = now_s;
            static_cast<void>(view_->poll_events());
            const auto shown = view_->draw({.pot = &pot_});
            EXPECT_TRUE(shown) << shown.error().message;
            pacer_.finish();
        }
        const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
        std::nth_element(off.begin(), middle, off.end());
        drawn.off_refresh = *middle;
        return drawn;
    }
    // Repeats the measurement for a while, because other processes make frames late. A pacer with its own
    // clock of 60 Hz never passes: it is a quarter of a period off each of the rates here. A late frame takes
    // two periods.
    void expect_followed(int display_hz) {
        Drawn drawn;
        EXPECT_TRUE(test::comes_true([&] {
            drawn = draw(120, display_hz);
            return drawn.on_beat > 0.9 && drawn.off_refresh < 0.12;
        })) << display_hz
            << " Hz: on the beat " << drawn.on_beat << ", off the refresh " << drawn.off_refresh;
    }

    pot::Pot pot_{.outer_mm = std::vector<float>(400, 60.0F), .height_mm = 200.0};
    std::unique_ptr<LiveView> view_;
    jobs::MonotonicClock clock_;
    jobs::FramePacer<> pacer_{clock_, 60.0};
};

TEST_F(ADisplay, IsTheFrameClockInsteadOfTheProgramsOwn) {
    for (const int rate_hz : {40, 45, 76}) {
        setenv("ONGGI_DISPLAY_HZ", std::to_string(rate_hz).c_str(), 1);
        draw(10);
        expect_followed(rate_hz);
    }
}

TEST_F(ADisplay, ThatIsOffDelaysNoFrameAndIsFollowedAgainOnceItIsOn) {
    setenv("ONGGI_DISPLAY_HZ", "40", 1);
    setenv("ONGGI_DISPLAY_IS_OFF", "1", 1);
    const double began_s = jobs::MonotonicClock::now_s();
    int waits_in_vain = 0;
    while (jobs::MonotonicClock::now_s() - began_s < 2.5) {
        const Drawn drawn = draw(1);
        EXPECT_EQ(drawn.on_beat, 0.0);
        waits_in_vain += drawn.waits_in_vain;
    }
    EXPECT_GE(waits_in_vain, 1);
    EXPECT_LE(waits_in_vain, 1 + static_cast<int>(jobs::MonotonicClock::now_s() - began_s)) << "one a second";
    unsetenv("ONGGI_DISPLAY_IS_OFF");
    draw(240);  // long enough for the next attempt
    expect_followed(40);
}

TEST_F(ADisplay, ThatIsLostWhileItIsWaitedForIsMended) {
    setenv("ONGGI_DISPLAY_HZ", "45", 1);
    draw(10);
    view_->device_health().inject({.call = "vkWaitForPresentKHR", .result = VK_ERROR_DEVICE_LOST});
    draw(5);
    EXPECT_EQ(view_->mended(), 1);
    draw(120);  // longer than the second without an attempt
    expect_followed(45);
}

TEST_F(ADisplay, IsNotWaitedForByADeviceThatKeepsFailing) {
    ASSERT_TRUE(test::comes_true([&] { return draw(30).on_beat > 0.9; }));
    open(true);
    EXPECT_EQ(draw(30).on_beat, 0.0);
}

}  // namespace
}  // namespace onggi::wheel
