// One scripted visitor after another, at a kiosk without a window: the whole program but its command line,
// with the picture drawn unseen, the real loop, the real keeper and the real disk, and a clock for the visits
// that runs as fast as frames are drawn. Memory and handles stay flat, and every pot that was to be kept is
// kept. A few visitors in ./check; ONGGI_VISITS=200 for the long run.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "engine/files/asset_folder.h"
#include "game/app/kiosk_sound.h"
#include "game/app/kiosk_visit.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using kiosk::Button;
using kiosk::Screen;

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr double kRateHz = 1000.0;

int visits() {
    const char* wanted = std::getenv("ONGGI_VISITS");
    return wanted != nullptr ? std::atoi(wanted) : 6;
}

double resident_kb() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        double kb = 0.0;
        if (word == "VmRSS:" && status >> kb) return kb;
    }
    return 0.0;
}

long open_handles() {
    const fs::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
}

class Kiosk {
  public:
    explicit Kiosk(const fs::path& gallery) {
        auto settings = load_settings("");
        EXPECT_TRUE(settings);
        settings_ = std::move(*settings);
        settings_.config.gallery.folder = gallery.string();
        settings_.config.gallery.least_free_mb = 1.0;
        settings_.config.gallery.most_pots = 100'000;
        auto view =
            wheel::LiveView::open({.width = kWidth, .height = kHeight, .headless = true, .plain = true});
        EXPECT_TRUE(view) << view.error().message;
        view_ = std::move(*view);
        parameters_.set_rate_hz(kRateHz);
        parameters_.studio.forgiving = true;
        auto device = std::make_unique<haptics::SimulatedDevice>();
        hand_ = device.get();
        parameters_.safety = haptics::limits_for(device->capabilities());
        auto devices = HandDevices::make("mouse", std::move(device), false);
        EXPECT_TRUE(devices);
        devices_ = std::make_unique<HandDevices>(std::move(*devices));
        job_ = std::make_unique<haptic::HapticJob>(start_, parameters_, devices_->take(),
                                                   haptic::HapticJobOptions{});
        keeper_ = std::make_unique<KioskKeeper>(*job_, start_, parameters_, Gallery(settings_.config),
                                                gallery / "statistics");
        EXPECT_TRUE(job_->start());
        EXPECT_TRUE(keeper_->start());
        visit_ = std::make_unique<KioskVisit>(VisitParts{.view = *view_,
                                                         .job = *job_,
                                                         .hand = *hand_,
                                                         .devices = *devices_,
                                                         .keeper = *keeper_,
                                                         .sound = sound_,
                                                         .settings = settings_,
                                                         .demonstration = demonstration_,
                                                         .rate_hz = kRateHz});
        EXPECT_TRUE(visit_->start());
    }
    ~Kiosk() {
        visit_.reset();
        keeper_->stop();
        job_->stop();
    }

    [[nodiscard]] Screen screen() const { return visit_->state().screen; }
    [[nodiscard]] const kiosk::State& state() const { return visit_->state(); }
    void frame(double dt_s = 1.0 / 60.0) {
        now_s_ += dt_s;
        const auto shown = visit_->frame(now_s_);
        ASSERT_TRUE(shown) << shown.error().message;
    }
    // Frames until it is so; the clock of the visit goes by dt_s a frame. At most a minute of real time.
    template <typename Condition>
    bool until(Condition&& condition, double dt_s = 1.0 / 60.0) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (!condition() && std::chrono::steady_clock::now() < end) {
            frame(dt_s);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return condition();
    }
    void point(double x_px, double y_px) { view_->feed(window::PointerEvent{x_px, y_px}); }
    void hold(bool pressed) { view_->feed(window::ButtonEvent{window::MouseButton::kLeft, pressed}); }
    // Presses that button of the screen that is shown, as soon as it is there.
    bool press(Button button, int value = 0) {
        const screens::Target* target = nullptr;
        const auto is_there = [&] {
            const screens::Composed* shown = visit_->shown();
            if (shown == nullptr || shown->view->state.screen != screen()) return false;
            target = nullptr;
            for (const screens::Target& one : shown->composition.targets)
                if (one.button == button && one.value == value) target = &one;
            return target != nullptr;
        };
        if (!until(is_there)) return false;
        const float px = visit_->shown()->composition.px_per_u;
        const vec2 middle = px * target->rect.centre();
        point(double{middle.x}, double{middle.y});
        hold(true);
        frame();
        hold(false);
        frame();
        return true;
    }
    // A hand that presses the wall in, with the pointer.
    void throw_a_little(std::mt19937& chance) {
        const double y_px = kHeight * (0.5 + 0.001 * static_cast<double>(chance() % 150));
        point(0.60 * kWidth, y_px);
        frame();
        hold(true);
        for (int step = 0; step < 25; ++step) {
            point((0.60 - 0.0016 * step) * kWidth, y_px);
            frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        hold(false);
        frame();
    }

  private:
    KioskSettings settings_;
    std::unique_ptr<wheel::LiveView> view_;
    haptic::HapticState start_{clay::StudioClay(clay::StudioLump{})};
    haptic::HapticParameters parameters_;
    haptics::SimulatedDevice* hand_ = nullptr;
    std::unique_ptr<HandDevices> devices_;
    std::unique_ptr<haptic::HapticJob> job_;
    std::unique_ptr<KioskKeeper> keeper_;
    KioskSound sound_{0.0};
    std::optional<haptics::Gesture> demonstration_;
    std::unique_ptr<KioskVisit> visit_;
    double now_s_ = 1000.0;
};

// From attract to attract. True where a pot was to be kept.
bool visit(Kiosk& kiosk, std::mt19937& chance) {
    const auto on = [&](Screen screen) { return [&kiosk, screen] { return kiosk.screen() == screen; }; };
    kiosk.until(on(Screen::kAttract));
    kiosk.point(0.5 * kWidth, 0.5 * kHeight);
    kiosk.hold(true);
    kiosk.frame();
    kiosk.hold(false);
    EXPECT_TRUE(kiosk.until(on(Screen::kChoose)));
    if (chance() % 2 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kFree));
    } else {
        EXPECT_TRUE(kiosk.press(Button::kTarget, static_cast<int>(chance() % 4)));
    }
    EXPECT_TRUE(kiosk.until(on(Screen::kThrow)));
    kiosk.throw_a_little(chance);
    if (chance() % 3 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kUndo));
    }
    if (chance() % 4 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kNewClay));
    }
    if (chance() % 3 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kLanguages));
        EXPECT_TRUE(kiosk.press(Button::kLanguage, static_cast<int>(chance() % 3)));
        EXPECT_TRUE(kiosk.press(Button::kComfortDone));
    }
    if (chance() % 8 == 0) {
        // Somebody who just walks away.
        EXPECT_TRUE(kiosk.until(on(Screen::kAttract), 0.1));
        return false;
    }
    EXPECT_TRUE(kiosk.press(Button::kDone));
    EXPECT_TRUE(kiosk.until(on(Screen::kGlaze), 0.1));
    EXPECT_TRUE(kiosk.press(Button::kGlaze, static_cast<int>(chance() % 6)));
    EXPECT_TRUE(kiosk.press(Button::kTakeGlaze));
    EXPECT_TRUE(kiosk.until(on(Screen::kYourPot)));
    EXPECT_TRUE(kiosk.press(Button::kKeep));
    EXPECT_TRUE(
        kiosk.until([&] { return kiosk.state().keeping.outcome != kiosk::Keeping::Outcome::kSaving; }));
    EXPECT_EQ(kiosk.state().keeping.outcome, kiosk::Keeping::Outcome::kKept);
    EXPECT_TRUE(kiosk.press(Button::kFinish));
    return true;
}

std::size_t pots_in(const fs::path& gallery) {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(gallery))
        count += entry.path().filename() == "pot.png" ? 1U : 0U;
    return count;
}

TEST(Visitors, LeaveMemoryAndHandlesAsTheyWereAndEveryPotOnTheShelf) {
    const test::TemporaryFolder folder;
    Kiosk kiosk(folder.path());
    std::mt19937 chance(20261122);
    const int count = visits();
    const int warm = std::max(2, count / 5);  // caches, pools and the shelf of the day fill up first
    std::size_t to_keep = 0;
    long handles = 0;
    double sum_x = 0.0;
    double sum_y = 0.0;
    double sum_xx = 0.0;
    double sum_xy = 0.0;
    double first_kb = 0.0;
    for (int number = 0; number < count; ++number) {
        to_keep += visit(kiosk, chance) ? 1U : 0U;
        if (HasFailure()) FAIL() << "in visit " << number + 1;
        if (number == warm) handles = open_handles();
        if (number == warm) first_kb = resident_kb();
        if (number < warm) continue;
        // The keeper works beside us and may have files open just now, and have had one when we counted.
        EXPECT_TRUE(kiosk.until([&] { return open_handles() <= handles + 1; }))
            << "after visit " << number + 1 << ": expected " << handles << " open files, found "
            << open_handles();
        const double x = number - warm;
        const double y = resident_kb();
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    EXPECT_EQ(pots_in(folder.path()), to_keep) << "every pot is kept, and no other";
    const double n = count - warm;
    const double slope_kb = n > 1 ? (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x) : 0.0;
    std::printf("%d visits, %zu pots kept; resident %.0f kB, then %+.1f kB a visit; %ld handles\n", count,
                to_keep, first_kb, slope_kb, open_handles());
    if (count >= 100) {
        EXPECT_LT(slope_kb, 40.0) << "memory grows";
    }
}

}  // namespace
}  // namespace onggi::app
