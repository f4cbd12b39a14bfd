// Frames by a display's own beat, where the driver says when an image is on the screen: display_layer.cpp is
// a display whose rate is another than that of the program's own clock, and that can be off. Under the
// validation layer. Runs under with_display.sh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "engine/jobs/clock.h"
#include "engine/jobs/frame_pacer.h"
#include "game/wheel/live_view.h"
#include "tests/support/test_backend.h"

namespace onggi::wheel {
namespace {

class ADisplay : public testing::Test {
  protected:
    void SetUp() override {
        unsetenv("ONGGI_DISPLAY_IS_OFF");
        ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "run by with_display.sh, which brings a display";
        auto view = LiveView::open({.width = 320,
                                    .height = 240,
                                    .validation = true,
                                    .backend = test::backend_of_environment(),
                                    .title = "Onggi on a display"});
        ASSERT_TRUE(view) << view.error().message;
        view_ = std::move(*view);
        ASSERT_EQ(view_->frame_rate_hz(), 60.0) << "what there is here tells no rate";
        draw(60);  // what is compiled at first use
    }
    // Frame by frame as the kiosk does; from the start of one to the start of the next, ms.
    std::vector<double> draw(int frames) {
        std::vector<double> intervals_ms;
        double before_s = 0.0;
        for (int frame = 0; frame < frames; ++frame) {
            pacer_.wait(view_->wait_for_display());
            const double now_s = jobs::MonotonicClock::now_s();
            if (frame > 0) intervals_ms.push_back(1e3 * (now_s - before_s));
            before_s = now_s;
            static_cast<void>(view_->poll_events());
            const auto drawn = view_->draw({.pot = &pot_});
            EXPECT_TRUE(drawn) << drawn.error().message;
            pacer_.finish();
        }
        return intervals_ms;
    }
    static double median(std::vector<double> values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    }

    pot::Pot pot_{.outer_mm = std::vector<float>(400, 60.0F), .height_mm = 200.0};
    std::unique_ptr<LiveView> view_;
    jobs::MonotonicClock clock_;
    jobs::FramePacer<> pacer_{clock_, 60.0};
};

TEST_F(ADisplay, GivesTheBeatWhateverTheOwnClockSays) {
    for (const int rate_hz : {40, 50, 72}) {
        setenv("ONGGI_DISPLAY_HZ", std::to_string(rate_hz).c_str(), 1);
        draw(10);
        EXPECT_NEAR(median(draw(120)), 1e3 / rate_hz, 1.0) << rate_hz;
    }
}

TEST_F(ADisplay, ThatIsOffHoldsUpNothingAndIsFollowedAgainWhenItIsOn) {
    setenv("ONGGI_DISPLAY_HZ", "40", 1);
    setenv("ONGGI_DISPLAY_IS_OFF", "1", 1);
    const std::vector<double> off_ms = draw(150);  // two seconds and a half
    EXPECT_NEAR(median(off_ms), 1e3 / 60.0, 1.0) << "by its own clock";
    const auto waits = std::count_if(off_ms.begin(), off_ms.end(), [](double ms) { return ms > 95.0; });
    EXPECT_GE(waits, 1) << "in vain, now and then";
    EXPECT_LE(waits, 3);
    unsetenv("ONGGI_DISPLAY_IS_OFF");
    draw(240);  // it is asked again by then
    EXPECT_NEAR(median(draw(60)), 25.0, 1.0);
}

TEST_F(ADisplay, ThatIsLostWhileItIsWaitedForIsMended) {
    view_->device_health().inject({.call = "vkWaitForPresentKHR", .result = VK_ERROR_DEVICE_LOST});
    draw(5);
    EXPECT_EQ(view_->mended(), 1);
    setenv("ONGGI_DISPLAY_HZ", "50", 1);
    draw(120);  // after the second in which it is not asked
    EXPECT_NEAR(median(draw(60)), 20.0, 1.0);
}

}  // namespace
}  // namespace onggi::wheel
