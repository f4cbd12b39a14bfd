// Outside the opening hours, on a virtual clock: the screen dims and the wheel is silent; a late visitor is
// still served, and in the morning everything is normal again.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "tests/stress/unseen_kiosk.h"
#include "tests/support/flash_meter.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using kiosk::Screen;

constexpr int kHourMin = 60;

// A loudspeaker that measures the last block's level.
class Ear final : public sound::SoundPlayer {
  public:
    explicit Ear(std::atomic<float>& peak) : peak_(peak) {}
    [[nodiscard]] std::string name() const override { return "an ear"; }
    Result<std::size_t> blocks_wanted() override { return std::size_t{1}; }
    Result<void> play(std::span<const sound::Sample, sound::kBlockFrames> block) override {
        float peak = 0.0F;
        for (const sound::Sample& sample : block)
            peak = std::max({peak, std::abs(sample.left), std::abs(sample.right)});
        peak_ = peak;
        return {};
    }
    void pause_ms(int milliseconds) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    }

  private:
    std::atomic<float>& peak_;
};

class Head final : public sound::SoundPlace {
  public:
    explicit Head(std::atomic<float>& peak) : peak_(peak) {}
    Result<std::unique_ptr<sound::SoundPlayer>> open() override {
        return std::unique_ptr<sound::SoundPlayer>(std::make_unique<Ear>(peak_));
    }

  private:
    std::atomic<float>& peak_;
};

class Museum : public testing::Test {
  protected:
    static UnseenOptions options(std::atomic<float>& peak, const int& minute) {
        UnseenOptions made;
        made.shows = true;
        made.config.hours.opens_min = 9 * kHourMin;
        made.config.hours.closes_min = 18 * kHourMin;
        made.minute_of_day = [&minute] { return minute; };
        made.loudspeaker = [&peak] { return std::make_unique<Head>(peak); };
        return made;
    }
    // The mean brightness of the picture after the transition.
    double brightness(bool is_dim) {
        EXPECT_TRUE(kiosk.until([&] { return kiosk.shown_closed() == is_dim; }));
        for (int look = 0; look < 20; ++look)  // two seconds: the room's own evening eases in
            kiosk.frame(0.1);
        const asset::Image picture = kiosk.picture();
        double sum = 0.0;
        for (std::size_t at = 0; at < picture.rgba.size(); at += 4)
            sum += support::relative_luminance(
                std::span<const std::uint8_t, 3>(picture.rgba.begin() + static_cast<std::ptrdiff_t>(at), 3));
        return sum / static_cast<double>(picture.rgba.size() / 4);
    }
    bool is_heard() {
        return kiosk.until([&] { return peak > 1e-3F; }, 0.001);
    }
    bool falls_silent() {
        return kiosk.until([&] { return peak < 1e-4F; }, 0.001);
    }

    test::TemporaryFolder folder;
    std::atomic<float> peak{0.0F};
    int minute = 12 * kHourMin;
    UnseenKiosk kiosk{folder.path(), options(peak, minute)};
};

TEST_F(Museum, IsDimAndSilentWhileItIsClosed) {
    const double noon = brightness(false);
    EXPECT_TRUE(is_heard()) << "the wheel that throws by itself";
    minute = 18 * kHourMin;
    const double night = brightness(true);
    EXPECT_LT(night, 0.1 * noon) << "at noon " << noon;
    EXPECT_TRUE(falls_silent());
    for (int look = 0; look < 100; ++look) {
        kiosk.frame(0.001);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        EXPECT_LT(peak, 1e-4F);
    }

    kiosk.touch();
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kChoose; }));
    EXPECT_FALSE(kiosk.shown_closed()) << "somebody is there: the watch, or a late visitor";
    EXPECT_TRUE(is_heard());
    ASSERT_TRUE(kiosk.press(kiosk::Button::kBack));
    EXPECT_TRUE(kiosk.until([&] { return kiosk.shown_closed(); }));
    EXPECT_TRUE(falls_silent());

    minute = 9 * kHourMin;
    EXPECT_GT(brightness(false), 0.5 * noon);
    EXPECT_TRUE(is_heard());
}

TEST_F(Museum, ShowsHalfOfThePicturesToNobodyTenASecondWhileItIsClosedAndAllToSomebody) {
    const auto shown_in_two_seconds = [&] {
        const std::uint64_t before = kiosk.frames_shown();
        for (int frame = 0; frame < 120; ++frame)
            kiosk.frame();
        return kiosk.frames_shown() - before;
    };
    ASSERT_TRUE(kiosk.until([&] { return kiosk.frames_shown() > 0; }))
        << "the first picture waits for its words";
    EXPECT_EQ(shown_in_two_seconds(), 60U);
    minute = 18 * kHourMin;
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_closed(); }));
    EXPECT_EQ(shown_in_two_seconds(), 60U) << "while it fades";
    for (int frame = 0; frame < 300; ++frame)
        kiosk.frame();
    const std::uint64_t dim = shown_in_two_seconds();
    EXPECT_GE(dim, 15U);
    EXPECT_LE(dim, 20U);
    kiosk.touch();
    EXPECT_GE(shown_in_two_seconds(), 119U);
}

TEST_F(Museum, DrawsTheFirstTouchInTheFrameThatBringsIt) {
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kAttract; }));
    const auto is_drawn = [&] {
        const std::uint64_t before = kiosk.frames_shown();
        kiosk.frame();
        return kiosk.frames_shown() != before;
    };
    while (!is_drawn()) {
    }
    kiosk.point(10.0, 10.0);  // the next frame would have no picture
    kiosk.hold(true);
    EXPECT_TRUE(is_drawn());
    kiosk.hold(false);
    EXPECT_TRUE(is_drawn());
    EXPECT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kChoose; }));
}

}  // namespace
}  // namespace onggi::app
