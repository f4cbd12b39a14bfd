// A real window through bad weather: sizes that change faster than frames, a window that is taken off the
// screen and put back, a surface and a device that are lost. The validation layer, with synchronization
// validation, hears no complaint. Runs under with_display.sh, which brings a display; xdotool is the weather.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "game/wheel/live_view.h"

namespace onggi::wheel {
namespace {

constexpr const char* kTitle = "Onggi in a storm";

class AWindow : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "run by with_display.sh, which brings a display";
        auto view = LiveView::open({.width = 640, .height = 480, .validation = true, .title = kTitle});
        ASSERT_TRUE(view) << view.error().message;
        view_ = std::move(*view);
        draw(3);
    }
    // Not waited for: the weather does not wait either.
    void weather(const std::string& words) {
        const std::string command =
            fmt::format("xdotool search --name '^{}$' {} >/dev/null 2>&1 &", kTitle, words);
        ASSERT_EQ(std::system(command.c_str()), 0);
    }
    // How many of so many frames were shown. Each may find any trouble, and none may end the picture.
    int draw(int frames) {
        int shown = 0;
        for (int frame = 0; frame < frames; ++frame) {
            static_cast<void>(view_->poll_events());
            const auto drawn = view_->draw({.pot = &pot_, .hand = {.position_mm = {72.0, 100.0, 0.0}}});
            EXPECT_TRUE(drawn) << drawn.error().message;
            if (!drawn) return shown;
            shown += *drawn ? 1 : 0;
            std::this_thread::sleep_for(std::chrono::milliseconds(4));
        }
        return shown;
    }
    // Until the picture is so wide, or a long time has gone by.
    bool becomes(int width) {
        for (int round = 0; round < 200; ++round) {
            draw(3);
            if (view_->width() == width) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return false;
    }

    pot::Pot pot_{.outer_mm = std::vector<float>(400, 60.0F), .height_mm = 200.0};
    std::unique_ptr<LiveView> view_;
};

TEST_F(AWindow, TakesSizesThatChangeFasterThanFrames) {
    for (int gust = 0; gust < 16; ++gust) {
        weather(fmt::format("windowsize {} {}", 200 + (gust * 137) % 500, 150 + (gust * 91) % 350));
        draw(2);
    }
    weather("windowsize 1 1");
    draw(6);
    weather("windowsize 333 222");
    EXPECT_TRUE(becomes(333)) << "found " << view_->width();
    EXPECT_EQ(view_->height(), 222);
    EXPECT_GT(draw(5), 0);
}

TEST_F(AWindow, ComesBackAfterItWasTakenOffTheScreen) {
    weather("windowunmap");
    draw(20);
    weather("windowmap");
    draw(20);
    EXPECT_GT(draw(5), 0);
}

TEST_F(AWindow, GoesOnAfterItsSurfaceIsOutOfDateOrLost) {
    view_->device_health().inject({.call = "vkAcquireNextImageKHR", .result = VK_ERROR_OUT_OF_DATE_KHR});
    draw(3);
    EXPECT_EQ(view_->mended(), 0) << "a swapchain that is out of date is made anew, and nothing else";
    view_->device_health().inject({.call = "vkAcquireNextImageKHR", .result = VK_ERROR_SURFACE_LOST_KHR});
    draw(3);
    EXPECT_EQ(view_->mended(), 1);
    draw(60);
    view_->device_health().inject({.call = "vkQueuePresentKHR", .result = VK_ERROR_SURFACE_LOST_KHR});
    draw(3);
    EXPECT_EQ(view_->mended(), 2);
    EXPECT_EQ(draw(5), 5);
}

TEST_F(AWindow, GoesOnAfterItsDeviceIsLostInTheMiddleOfAStorm) {
    for (int gust = 0; gust < 4; ++gust) {
        weather(fmt::format("windowsize {} {}", 300 + 60 * gust, 260 + 30 * gust));
        draw(1);
        if (gust == 2)
            view_->device_health().inject({.call = "vkQueueSubmit2", .result = VK_ERROR_DEVICE_LOST});
        draw(4);
    }
    EXPECT_EQ(view_->mended(), 1);
    EXPECT_GT(draw(5), 0);
}

}  // namespace
}  // namespace onggi::wheel
