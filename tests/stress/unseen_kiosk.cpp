#include "tests/stress/unseen_kiosk.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <thread>
#include <utility>

#include "engine/files/atomic_file.h"
#include "game/app/kiosk/presentation/demonstrations.h"
#include "game/app/kiosk/staff/kiosk_staff.h"
#include "game/app/kiosk/visit/kiosk_visit.h"
#include "tests/support/patience.h"

namespace onggi::app {

UnseenOptions looked_at() {
    if (std::getenv("ONGGI_LOOK") == nullptr) return {};
    return {.plain = false, .width = 1280, .height = 720};
}

struct UnseenKiosk::Parts {
    Parts(const std::filesystem::path& gallery, UnseenOptions options, std::optional<OtherDevice> arm)
        : start(std::move(options.lump)),
          frame_pause(options.real_time ? 16 : 1),
          patience(options.patience) {
        auto loaded = load_settings("");
        EXPECT_TRUE(loaded);
        settings = std::move(*loaded);
        settings.config = std::move(options.config);
        settings.rules.shows_by_itself = settings.config.visit.shows_by_itself;
        settings.config.gallery.folder = gallery.string();
        settings.config.gallery.least_free_mb = 1.0;
        settings.config.gallery.most_pots = options.most_pots;
        auto opened = wheel::LiveView::open(
            {.width = options.width, .height = options.height, .headless = true, .plain = options.plain});
        EXPECT_TRUE(opened) << opened.error().message;
        view = std::move(*opened);
        parameters.set_rate_hz(kRateHz);
        parameters.studio.forgiving = options.forgiving;
        auto device = std::make_unique<haptic::SimulatedDevice>();
        pointer = device.get();
        parameters.safety = haptics::limits_for(device->capabilities());
        std::vector<std::string> remarks;
        if (options.shows) show = load_show({start, options.forgiving}, remarks);
        EXPECT_TRUE(remarks.empty());
        auto first = std::make_unique<DemonstrationDevice>(std::move(device), show.recordings, kRateHz);
        auto made = AttachedDevices::make("mouse", std::move(first), false, std::move(arm));
        EXPECT_TRUE(made);
        devices = std::make_unique<AttachedDevices>(std::move(*made));
        job = std::make_unique<haptic::HapticJob>(start, parameters, devices->take(),
                                                  haptic::HapticJobOptions{.spares_the_core = true});
        keeper = std::make_unique<KioskKeeper>(*job, start, parameters, Gallery(settings.config),
                                               gallery / "statistics", KioskHeartbeat(settings.config));
        EXPECT_TRUE(job->start());
        EXPECT_TRUE(keeper->start());
        if (options.loudspeaker) sound = std::make_unique<KioskSound>(0.5, true, options.loudspeaker);
        if (options.speech) {
            settings.rules.offers_speech = settings.rules.speaks = true;
            voice = std::make_unique<KioskVoice>(std::filesystem::path(), std::move(options.speech));
            EXPECT_TRUE(voice->start());
        }
        if (!options.minute_of_day) options.minute_of_day = app::minute_of_day;
        visit = std::make_unique<KioskVisit>(VisitParts{.view = *view,
                                                        .job = *job,
                                                        .pointer = *pointer,
                                                        .devices = *devices,
                                                        .keeper = *keeper,
                                                        .sound = *sound,
                                                        .voice = voice.get(),
                                                        .settings = settings,
                                                        .show = show,
                                                        .rate_hz = kRateHz,
                                                        .minute_of_day = std::move(options.minute_of_day)});
        EXPECT_TRUE(visit->start());
    }
    ~Parts() {
        visit.reset();
        keeper->stop();
        job->stop();
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    KioskSettings settings;
    std::unique_ptr<wheel::LiveView> view;
    haptic::HapticState start;
    std::chrono::milliseconds frame_pause;
    std::chrono::minutes patience;
    haptic::HapticParameters parameters;
    haptic::SimulatedDevice* pointer = nullptr;
    std::unique_ptr<AttachedDevices> devices;
    std::unique_ptr<haptic::HapticJob> job;
    std::unique_ptr<KioskKeeper> keeper;
    std::unique_ptr<KioskSound> sound = std::make_unique<KioskSound>(0.0);
    std::unique_ptr<KioskVoice> voice;  // null: nothing is spoken
    Show show;
    std::unique_ptr<KioskVisit> visit;
    double now_s = 1000.0;
    double beat_s = 0.0;
};

UnseenKiosk::UnseenKiosk(const std::filesystem::path& gallery, UnseenOptions options,
                         std::optional<OtherDevice> arm)
    : parts_(std::make_unique<Parts>(gallery, std::move(options), std::move(arm))) {}

UnseenKiosk::~UnseenKiosk() = default;

const kiosk::State& UnseenKiosk::state() const {
    return parts_->visit->state();
}

const KioskSettings& UnseenKiosk::settings() const {
    return parts_->settings;
}

const haptic::Snapshot& UnseenKiosk::snapshot() {
    return parts_->job->newest_snapshot();
}

void UnseenKiosk::frame(double dt_s) {
    parts_->now_s += dt_s;
    const auto shown = parts_->visit->frame(parts_->now_s);
    ASSERT_TRUE(shown) << shown.error().message;
    if (parts_->now_s - parts_->beat_s < KioskHeartbeat::kEveryS) return;
    parts_->beat_s = parts_->now_s;
    parts_->keeper->beat(parts_->visit->pulse());
}

double UnseenKiosk::now_s() const {
    return parts_->now_s;
}

std::optional<dvec2> UnseenKiosk::seen(const dvec3& place_mm) const {
    return parts_->view->project(place_mm);
}

void UnseenKiosk::passes(double seconds) {
    constexpr std::chrono::milliseconds kFrame(10);
    const auto end = std::chrono::steady_clock::now() + test::scaled(parts_->patience);
    std::uint64_t last_tick = snapshot().tick;
    for (double since_s = 0.0; since_s < seconds;) {
        ASSERT_LT(std::chrono::steady_clock::now(), end) << "the wheel stands still";
        std::this_thread::sleep_for(kFrame);
        const std::uint64_t tick = snapshot().tick;
        // The tick count of a fresh lump begins at 0.
        const double dt_s = static_cast<double>(tick - (tick < last_tick ? 0 : last_tick)) / kRateHz;
        last_tick = tick;
        frame(dt_s);
        since_s += dt_s;
    }
}

bool UnseenKiosk::journal_catches_up() {
    const auto journal_bytes = [folder = state_folder(parts_->settings.config.gallery.folder)] {
        std::uintmax_t bytes = 0;
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            std::error_code gone;
            const std::uintmax_t size = file.file_size(gone);
            if (!gone && file.path().filename().string().starts_with("visit-")) bytes += size;
        }
        return bytes;
    };
    // The first new block may have begun before this call; the second has not.
    for (int block = 0; block < 2; ++block)
        if (!until([&, before = journal_bytes()] { return journal_bytes() > before; }, kSlowly)) return false;
    return true;
}

void UnseenKiosk::look(const std::string& name, double rest_s) {
    const char* const folder = std::getenv("ONGGI_LOOK");
    if (folder == nullptr) return;
    passes(rest_s);
    const auto png = asset::encode_png(picture());
    ASSERT_TRUE(png);
    ASSERT_TRUE(files::write_file_atomically(std::filesystem::path(folder) / (name + ".png"), *png));
}

asset::Image UnseenKiosk::picture() {
    return parts_->view->read_back().value();
}

bool UnseenKiosk::until(const std::function<bool()>& condition, double dt_s) {
    const auto end = std::chrono::steady_clock::now() + test::scaled(parts_->patience);
    while (!condition() && std::chrono::steady_clock::now() < end) {
        frame(dt_s);
        std::this_thread::sleep_for(parts_->frame_pause);
    }
    return condition();
}

void UnseenKiosk::does(const window::Event& event) {
    parts_->view->feed(event);
}

void UnseenKiosk::plug_in(std::vector<window::Gamepad> pads) {
    parts_->view->feed(std::move(pads));
}

void UnseenKiosk::point(double x_px, double y_px) {
    parts_->view->feed(window::PointerEvent{x_px, y_px});
}

void UnseenKiosk::hold(bool pressed) {
    parts_->view->feed(window::ButtonEvent{window::MouseButton::kLeft, pressed});
}

void UnseenKiosk::press_key(window::Key which) {
    parts_->view->feed(window::KeyEvent{.key = which, .pressed = true});
    frame();
    parts_->view->feed(window::KeyEvent{.key = which, .pressed = false});
    frame();
}

void UnseenKiosk::touch() {
    point(0.5 * parts_->view->width(), 0.5 * parts_->view->height());
    hold(true);
    frame();
    hold(false);
}

std::optional<kiosk::Screen> UnseenKiosk::shown_screen() const {
    if (parts_->visit->shown() == nullptr) return std::nullopt;
    return parts_->visit->shown()->view->state.screen;
}

int UnseenKiosk::shown_exhibit() const {
    return parts_->visit->shown() != nullptr ? parts_->visit->shown()->view->attract_exhibit : -1;
}

std::uint64_t UnseenKiosk::frames_shown() const {
    return parts_->visit->frames_shown();
}

bool UnseenKiosk::shown_closed() const {
    return parts_->visit->shown() != nullptr && parts_->visit->shown()->view->closed;
}

std::shared_ptr<const screens::View> UnseenKiosk::shown_view() const {
    return parts_->visit->shown() != nullptr ? parts_->visit->shown()->view : nullptr;
}

bool UnseenKiosk::press(kiosk::Button button, int value) {
    if (!point_at(button, value)) return false;
    hold(true);
    frame();
    hold(false);
    frame();
    return true;
}

bool UnseenKiosk::point_at(kiosk::Button button, int value) {
    const screens::Target* target = nullptr;
    const auto is_there = [&] {
        const screens::Composed* shown = parts_->visit->shown();
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
    const float px = parts_->visit->shown()->composition.px_per_u;
    const vec2 middle = px * target->rect.centre();
    point(double{middle.x}, double{middle.y});
    return true;
}

bool UnseenKiosk::begins_to_throw() {
    touch();
    return until([&] { return screen() == kiosk::Screen::kChoose; }) && press(kiosk::Button::kFree) &&
           until([&] { return shown_screen() == kiosk::Screen::kThrow; }, kSlowly);
}

bool UnseenKiosk::ends_throwing() {
    if (!press(kiosk::Button::kDone)) return false;
    return state().throwing.asks == kiosk::DoneQuestion::kNone || press(kiosk::Button::kDone);
}

bool UnseenKiosk::dries() {
    const auto is_dry = [&] {
        return shown_screen() == kiosk::Screen::kTrim || shown_screen() == kiosk::Screen::kDecorate;
    };
    if (!until(is_dry, 0.1)) return false;
    if (shown_screen() == kiosk::Screen::kTrim && !press(kiosk::Button::kSkip)) return false;
    const auto can_be_drawn_on = [&] {
        return shown_screen() == kiosk::Screen::kDecorate && shown_view()->pot != nullptr;
    };
    return until(can_be_drawn_on, kSlowly);
}

bool UnseenKiosk::fires_it(bool decorates) {
    const auto misses = [](const char* what) {
        ADD_FAILURE() << "expected " << what;
        return false;
    };
    if (!dries()) return misses("the pot dried");
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

void UnseenKiosk::touch_clay(std::mt19937& chance) {
    const double y_mm = 10.0 + static_cast<double>(chance() % 25);
    stroke({{66.0, y_mm}, {56.0, y_mm}}, 0.3, chance);
}

bool UnseenKiosk::throw_a_pot(std::mt19937& chance) {
    constexpr int kTries = 10;
    constexpr double kDeepMm = 25.0;
    constexpr double kHighMm = 72.0;
    const auto top_mm = [&] { return snapshot().pot->height_mm; };
    const auto is_open = [&] {
        return snapshot().pot->can_be_hollow() && top_mm() - snapshot().pot->floor_mm > kDeepMm;
    };
    // The previous pot is visible for a moment longer.
    if (!until([&] { return !is_open(); }, kSlowly)) return false;
    for (int tries = 0; tries < kTries && !is_open(); ++tries)
        stroke({{0.0, top_mm() + 1.0}, {0.0, top_mm() - 38.0}}, 1.3, chance);
    for (int tries = 0; tries < kTries && top_mm() < kHighMm; ++tries)
        stroke({{58.0, 0.25 * top_mm()}, {56.0, top_mm()}, {55.0, top_mm() + 28.0}}, 1.2, chance);
    return is_open() && top_mm() >= kHighMm;
}

void UnseenKiosk::stroke(const std::vector<dvec2>& way_mm, double seconds, std::mt19937& chance) {
    constexpr double kAimMm = 2.0;
    constexpr double kStaysS = 0.25;  // so that the hands come after
    std::normal_distribution<double> aim(0.0, kAimMm);
    const double miss_up_mm = aim(chance);
    const dvec2 miss_mm(aim(chance), miss_up_mm);
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
        std::this_thread::sleep_for(std::max(std::chrono::milliseconds(4), parts_->frame_pause));
        const std::chrono::duration<double> now = std::chrono::steady_clock::now() - begun;
        frame(now.count() - since_s);
        since_s = now.count();
    }
    hold(false);
    frame();
}

std::string UnseenKiosk::missed(kiosk::Button button, int value) const {
    std::string words =
        fmt::format("expected button {} {} on screen {} with panel {}, found", static_cast<int>(button),
                    value, static_cast<int>(screen()), static_cast<int>(state().panel));
    const screens::Composed* shown = parts_->visit->shown();
    if (shown == nullptr) return words + " no screen";
    words += fmt::format(" on screen {} with panel {}:", static_cast<int>(shown->view->state.screen),
                         static_cast<int>(shown->view->state.panel));
    for (const screens::Target& one : shown->composition.targets)
        words += fmt::format(" {} {}", static_cast<int>(one.button), one.value);
    return words;
}

}  // namespace onggi::app
