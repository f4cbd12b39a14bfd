// A kiosk without a window: the whole program but its command line, with the picture drawn unseen, the real
// loop, the real keeper and the real disk, and a clock for the visits that runs as fast as frames are drawn.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/asset/image.h"
#include "engine/files/atomic_file.h"
#include "game/app/kiosk/presentation/demonstrations.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/app/kiosk/staff/kiosk_staff.h"
#include "game/app/kiosk/visit/kiosk_visit.h"

namespace onggi::app {

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr double kRateHz = 1000.0;
// A frame of who waits for what works by the clock on the wall, the keeper or whoever composes screens: on a
// busy machine the visit's clock must not run away from them, into attract.
constexpr double kSlowly = 0.002;

struct UnseenOptions {
    clay::StudioClay lump = clay::StudioClay(clay::StudioLump{});  // every lump is that
    bool forgiving = true;                                         // it bears more than real clay
    bool plain = true;                                             // no photographed room
    bool shows = false;                                            // recordings, while nobody is there
    bool real_time = false;                                        // 60 frames a second, no more
    std::chrono::minutes patience{1};                              // of until(), by the clock on the wall
    int most_pots = 100'000;
    int width = kWidth;
    int height = kHeight;
    kiosk::Config config = {};  // but its gallery
    std::function<int()> minute_of_day = app::minute_of_day;
    KioskSound::MakePlace loudspeaker = {};  // none: no sound
};

// ONGGI_LOOK=FOLDER: pictures of a visit's steps, large enough to be looked at; see UnseenKiosk::look().
inline UnseenOptions looked_at() {
    if (std::getenv("ONGGI_LOOK") == nullptr) return {};
    return {.plain = false, .width = 1280, .height = 720};
}

class UnseenKiosk {
  public:
    explicit UnseenKiosk(const std::filesystem::path& gallery, UnseenOptions options = {})
        : start_(std::move(options.lump)),
          frame_pause_(options.real_time ? 16 : 1),
          patience_(options.patience) {
        auto settings = load_settings("");
        EXPECT_TRUE(settings);
        settings_ = std::move(*settings);
        settings_.config = std::move(options.config);
        settings_.rules.shows_by_itself = settings_.config.visit.shows_by_itself;
        settings_.config.gallery.folder = gallery.string();
        settings_.config.gallery.least_free_mb = 1.0;
        settings_.config.gallery.most_pots = options.most_pots;
        auto view = wheel::LiveView::open(
            {.width = options.width, .height = options.height, .headless = true, .plain = options.plain});
        EXPECT_TRUE(view) << view.error().message;
        view_ = std::move(*view);
        parameters_.set_rate_hz(kRateHz);
        parameters_.studio.forgiving = options.forgiving;
        auto device = std::make_unique<haptics::SimulatedDevice>();
        hand_ = device.get();
        parameters_.safety = haptics::limits_for(device->capabilities());
        std::vector<std::string> remarks;
        if (options.shows) show_ = load_show({start_, options.forgiving}, remarks);
        EXPECT_TRUE(remarks.empty());
        auto first_hand = std::make_unique<DemonstrationHand>(std::move(device), show_.recordings, kRateHz);
        auto devices = HandDevices::make("mouse", std::move(first_hand), false);
        EXPECT_TRUE(devices);
        devices_ = std::make_unique<HandDevices>(std::move(*devices));
        job_ = std::make_unique<haptic::HapticJob>(start_, parameters_, devices_->take(),
                                                   haptic::HapticJobOptions{});
        keeper_ = std::make_unique<KioskKeeper>(*job_, start_, parameters_, Gallery(settings_.config),
                                                gallery / "statistics", KioskHeartbeat(settings_.config));
        EXPECT_TRUE(job_->start());
        EXPECT_TRUE(keeper_->start());
        if (options.loudspeaker) sound_ = std::make_unique<KioskSound>(0.5, true, options.loudspeaker);
        visit_ = std::make_unique<KioskVisit>(VisitParts{.view = *view_,
                                                         .job = *job_,
                                                         .hand = *hand_,
                                                         .devices = *devices_,
                                                         .keeper = *keeper_,
                                                         .sound = *sound_,
                                                         .settings = settings_,
                                                         .show = show_,
                                                         .rate_hz = kRateHz,
                                                         .minute_of_day = std::move(options.minute_of_day)});
        EXPECT_TRUE(visit_->start());
    }
    ~UnseenKiosk() {
        visit_.reset();
        keeper_->stop();
        job_->stop();
    }

    [[nodiscard]] kiosk::Screen screen() const { return visit_->state().screen; }
    [[nodiscard]] const kiosk::State& state() const { return visit_->state(); }
    [[nodiscard]] const KioskSettings& settings() const { return settings_; }
    [[nodiscard]] const haptic::Snapshot& snapshot() { return job_->newest_snapshot(); }
    void frame(double dt_s = 1.0 / 60.0) {
        now_s_ += dt_s;
        const auto shown = visit_->frame(now_s_);
        ASSERT_TRUE(shown) << shown.error().message;
        if (now_s_ - beat_s_ < KioskHeartbeat::kEveryS) return;
        beat_s_ = now_s_;
        keeper_->beat(visit_->pulse());
    }
    [[nodiscard]] double now_s() const { return now_s_; }
    // Where the last frame shows a place on the wheel, px.
    [[nodiscard]] std::optional<dvec2> seen(const dvec3& place_mm) const { return view_->project(place_mm); }
    // So long by the clock on the wall, which the wheel and the keeper go by.
    void passes(double seconds) {
        constexpr double kFrameS = 0.01;
        for (double since_s = 0.0; since_s < seconds; since_s += kFrameS) {
            std::this_thread::sleep_for(std::chrono::duration<double>(kFrameS));
            frame(kFrameS);
        }
    }
    // Where somebody asked to see it: a picture of that name, of a scene at rest after so long.
    void look(const std::string& name, double rest_s = 1.2) {
        const char* const folder = std::getenv("ONGGI_LOOK");
        if (folder == nullptr) return;
        passes(rest_s);
        const auto png = asset::encode_png(picture());
        ASSERT_TRUE(png);
        ASSERT_TRUE(files::write_file_atomically(std::filesystem::path(folder) / (name + ".png"), *png));
    }
    // The last frame.
    [[nodiscard]] asset::Image picture() { return view_->read_back().value(); }
    // Frames until it is so; the clock of the visit goes by dt_s a frame. As long as there is patience.
    template <typename Condition>
    bool until(Condition&& condition, double dt_s = 1.0 / 60.0) {
        const auto end = std::chrono::steady_clock::now() + patience_;
        while (!condition() && std::chrono::steady_clock::now() < end) {
            frame(dt_s);
            std::this_thread::sleep_for(frame_pause_);
        }
        return condition();
    }
    void does(const window::Event& event) { view_->feed(event); }
    void point(double x_px, double y_px) { view_->feed(window::PointerEvent{x_px, y_px}); }
    void hold(bool pressed) { view_->feed(window::ButtonEvent{window::MouseButton::kLeft, pressed}); }
    void press_key(window::Key which) {
        view_->feed(window::KeyEvent{.key = which, .pressed = true});
        frame();
        view_->feed(window::KeyEvent{.key = which, .pressed = false});
        frame();
    }
    // A finger anywhere.
    void touch() {
        point(0.5 * view_->width(), 0.5 * view_->height());
        hold(true);
        frame();
        hold(false);
    }
    // What the screen shows, which is a little later than what the visit has come to.
    [[nodiscard]] std::optional<kiosk::Screen> shown_screen() const {
        if (visit_->shown() == nullptr) return std::nullopt;
        return visit_->shown()->view->state.screen;
    }
    [[nodiscard]] int shown_exhibit() const {
        return visit_->shown() != nullptr ? visit_->shown()->view->attract_exhibit : -1;
    }
    [[nodiscard]] bool shown_closed() const {
        return visit_->shown() != nullptr && visit_->shown()->view->closed;
    }
    // What it was made from; null before the first.
    [[nodiscard]] std::shared_ptr<const screens::View> shown_view() const {
        return visit_->shown() != nullptr ? visit_->shown()->view : nullptr;
    }
    // Presses that button of the screen that is shown, as soon as it is there.
    bool press(kiosk::Button button, int value = 0) {
        if (!point_at(button, value)) return false;
        hold(true);
        frame();
        hold(false);
        frame();
        return true;
    }
    // The pointer over it.
    bool point_at(kiosk::Button button, int value = 0) {
        const screens::Target* target = nullptr;
        const auto is_there = [&] {
            const screens::Composed* shown = visit_->shown();
            if (shown == nullptr || shown->view->state.screen != screen()) return false;
            target = nullptr;
            for (const screens::Target& one : shown->composition.targets)
                if (one.button == button && one.value == value) target = &one;
            return target != nullptr;
        };
        if (!until(is_there, kSlowly)) {
            ADD_FAILURE() << missed(button, value);
            return false;
        }
        const float px = visit_->shown()->composition.px_per_u;
        const vec2 middle = px * target->rect.centre();
        point(double{middle.x}, double{middle.y});
        return true;
    }
    // From attract to clay on the wheel, after no pot of a museum.
    bool begins_to_throw() {
        touch();
        return until([&] { return screen() == kiosk::Screen::kChoose; }) && press(kiosk::Button::kFree) &&
               until([&] { return shown_screen() == kiosk::Screen::kThrow; }, kSlowly);
    }
    // To the decorating; a foot that is thick is left as it is.
    bool dries() {
        const auto is_dry = [&] {
            return shown_screen() == kiosk::Screen::kTrim || shown_screen() == kiosk::Screen::kDecorate;
        };
        if (!until(is_dry, 0.1)) return false;
        if (shown_screen() == kiosk::Screen::kTrim && !press(kiosk::Button::kSkip)) return false;
        return until([&] { return shown_screen() == kiosk::Screen::kDecorate; }, kSlowly);
    }
    // From the drying to the glazes, with a band of iron or as it is. False: it did not get there.
    bool fires_it(bool decorates) {
        const auto misses = [](const char* what) {
            ADD_FAILURE() << "expected " << what;
            return false;
        };
        if (!dries()) return misses("the pot dried");
        const auto is_cut_off = [&] { return shown_view() != nullptr && shown_view()->pot != nullptr; };
        if (!until(is_cut_off, kSlowly)) return misses("a pot to draw on");
        if (decorates) {
            constexpr int kFrames = 90;
            if (!press(kiosk::Button::kDrawingTool, 1)) return misses("a tool to draw with");
            const auto middle = seen({0.0, 0.5 * snapshot().pot->height_mm, 0.0});
            if (!middle) return misses("the middle of the pot in sight");
            point(middle->x, middle->y);
            hold(true);
            for (int i = 0; i < kFrames; ++i)
                frame();
            hold(false);
            frame();
            EXPECT_EQ(state().decorating.strokes, 1);
        }
        if (!press(kiosk::Button::kDone)) return misses("a way on to the kiln");
        return until([&] { return screen() == kiosk::Screen::kGlaze; }, 0.1) || misses("a fired pot");
    }
    // A hand that presses the wall in, with the pointer.
    void touch_clay(std::mt19937& chance) {
        const double y_mm = 10.0 + static_cast<double>(chance() % 25);
        stroke({{66.0, y_mm}, {56.0, y_mm}}, 0.3, chance);
    }
    // Opens the clay in the middle and draws its wall up, as a visitor in a hurry does: each touch again
    // until the clay has come on. False: it did not.
    bool throw_a_pot(std::mt19937& chance) {
        constexpr int kTries = 10;
        constexpr double kDeepMm = 25.0;
        constexpr double kHighMm = 72.0;
        const auto top_mm = [&] { return snapshot().pot->height_mm; };
        const auto is_open = [&] {
            return snapshot().pot->can_be_hollow() && top_mm() - snapshot().pot->floor_mm > kDeepMm;
        };
        for (int tries = 0; tries < kTries && !is_open(); ++tries)
            stroke({{0.0, top_mm() + 1.0}, {0.0, top_mm() - 38.0}}, 1.3, chance);
        for (int tries = 0; tries < kTries && top_mm() < kHighMm; ++tries)
            stroke({{58.0, 0.25 * top_mm()}, {56.0, top_mm()}, {55.0, top_mm() + 28.0}}, 1.2, chance);
        return is_open() && top_mm() >= kHighMm;
    }
    // A finger along those places of the upright plane through the axis, mm, missed by some; in real time, as
    // the clay goes.
    void stroke(const std::vector<dvec2>& way_mm, double seconds, std::mt19937& chance) {
        constexpr double kAimMm = 2.0;
        constexpr double kStaysS = 0.25;  // so that the hands come after
        std::normal_distribution<double> aim(0.0, kAimMm);
        const dvec2 miss_mm(aim(chance), aim(chance));
        const double legs = static_cast<double>(way_mm.size() - 1);
        const auto begun = std::chrono::steady_clock::now();
        double since_s = 0.0;
        for (bool is_down = false; since_s < seconds + kStaysS; is_down = true) {
            const double along = legs * std::min(since_s / seconds, 1.0);
            const auto leg = std::min(static_cast<std::size_t>(along), way_mm.size() - 2);
            const dvec2 place_mm =
                glm::mix(way_mm[leg], way_mm[leg + 1], along - static_cast<double>(leg)) + miss_mm;
            const auto px = seen({place_mm.x, place_mm.y, 0.0});
            ASSERT_TRUE(px);
            point(px->x, px->y);
            if (!is_down) hold(true);
            std::this_thread::sleep_for(std::max(std::chrono::milliseconds(4), frame_pause_));
            const std::chrono::duration<double> now = std::chrono::steady_clock::now() - begun;
            frame(now.count() - since_s);
            since_s = now.count();
        }
        hold(false);
        frame();
    }

  private:
    // What was looked for, and what is there instead.
    [[nodiscard]] std::string missed(kiosk::Button button, int value) const {
        std::string words =
            fmt::format("expected button {} {} on screen {} with panel {}, found", static_cast<int>(button),
                        value, static_cast<int>(screen()), static_cast<int>(state().panel));
        const screens::Composed* shown = visit_->shown();
        if (shown == nullptr) return words + " no screen";
        words += fmt::format(" on screen {} with panel {}:", static_cast<int>(shown->view->state.screen),
                             static_cast<int>(shown->view->state.panel));
        for (const screens::Target& one : shown->composition.targets)
            words += fmt::format(" {} {}", static_cast<int>(one.button), one.value);
        return words;
    }

    KioskSettings settings_;
    std::unique_ptr<wheel::LiveView> view_;
    haptic::HapticState start_;
    std::chrono::milliseconds frame_pause_;
    std::chrono::minutes patience_;
    haptic::HapticParameters parameters_;
    haptics::SimulatedDevice* hand_ = nullptr;
    std::unique_ptr<HandDevices> devices_;
    std::unique_ptr<haptic::HapticJob> job_;
    std::unique_ptr<KioskKeeper> keeper_;
    std::unique_ptr<KioskSound> sound_ = std::make_unique<KioskSound>(0.0);
    Show show_;
    std::unique_ptr<KioskVisit> visit_;
    double now_s_ = 1000.0;
    double beat_s_ = 0.0;
};

}  // namespace onggi::app
