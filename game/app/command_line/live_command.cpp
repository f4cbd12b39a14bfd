#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "engine/jobs/clock.h"
#include "engine/jobs/shared_loop.h"
#include "engine/jobs/thread_setup.h"
#include "engine/render/overlay.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/options.h"
#include "game/app/command_line/performance.h"
#include "game/app/command_line/progress.h"
#include "game/app/command_line/stats.h"
#include "game/app/devices/attached_devices.h"
#include "game/app/devices/haptic_guard.h"
#include "game/app/kiosk/presentation/force_view.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/app/system/end_signal.h"
#include "game/app/system/haptic_core.h"
#include "game/app/system/report.h"
#include "game/kiosk/strings.h"
#include "game/screens/stage.h"
#include "game/wheel/live_view.h"

namespace onggi::app {
namespace {

// The force view over a replayed picture. A key turns it on and off.
class LiveForces {
  public:
    explicit LiveForces(bool shown) : shown_(shown) {}
    ~LiveForces() { composer_.stop(); }
    LiveForces(const LiveForces&) = delete;
    LiveForces& operator=(const LiveForces&) = delete;

    Result<void> start() { return composer_.start(); }
    void turn_over() { shown_ = !shown_; }

    // Call it once a frame, shown or not, so that the plots have a history. Returns null when there is no
    // overlay. Valid until the next call.
    [[nodiscard]] const render::Overlay* look(const haptic::Snapshot& snapshot, const wheel::LiveView& view,
                                              double now_s);

  private:
    bool shown_;
    ForceView forces_;
    screens::Composer composer_{screens::compose_forces};
    screens::Stage stage_;
    std::shared_ptr<const screens::View> asked_;
    render::Overlay overlay_;
};

const render::Overlay* LiveForces::look(const haptic::Snapshot& snapshot, const wheel::LiveView& view,
                                        double now_s) {
    forces_.look(snapshot, now_s);
    if (!shown_ || view.width() <= 0 || view.height() <= 0) return nullptr;
    if (!asked_ || asked_->width_px != view.width() || asked_->height_px != view.height()) {
        screens::View request;
        request.width_px = view.width();
        request.height_px = view.height();
        request.state.comfort.forces = true;
        request.languages = std::make_shared<const std::vector<kiosk::Language>>(kiosk::built_in_languages());
        asked_ = std::make_shared<const screens::View>(std::move(request));
        composer_.ask(asked_);
    }
    stage_.take(composer_.latest(), now_s);
    const screens::ForceFrame frame = forces_.frame(snapshot, sight_of(view), true);
    overlay_.list = &stage_.draw({.now_s = now_s, .forces = &frame});
    overlay_.uploads = stage_.uploads();
    overlay_.atlas_side_px = stage_.atlas_side_px();
    return &overlay_;
}

// A live run may last months, but not less than a frame.
constexpr double kLeastSeconds = 0.02;
constexpr double kMostSeconds = 1e7;

struct LiveOptions {
    InputOptions input;
    std::optional<double> seconds;
    std::string wait = "hybrid";
    std::string device = "gesture";
    std::optional<double> volume;
    bool headless = false;
    bool forces = false;
    PictureSize size;
    std::optional<render::BackendChoice> backend;
    std::optional<std::string> stats;
};

// A live run has no input but closing and two keys.
Result<FrameOutcome> show(wheel::LiveView& view, LiveForces& forces, const haptic::Snapshot& snapshot) {
    bool stops = false;
    for (const window::Event& event : view.poll_events()) {
        const auto* key = std::get_if<window::KeyEvent>(&event);
        if (key == nullptr || !key->pressed || key->repeat) continue;
        if (key->key == window::Key::kV) forces.turn_over();
        stops = stops || key->key == window::Key::kPause;
    }
    if (view.close_requested() || end_was_asked()) return FrameOutcome::kClosed;
    const double now_s = jobs::MonotonicClock::now_s();
    const auto drawn = view.draw(snapshot, 1.0 / kFrameRateHz, forces.look(snapshot, view, now_s));
    if (!drawn) return drawn.error();
    if (auto done = view.wait(); !done) return done.error();
    for (const std::string& line : view.take_remarks())
        remark(line);
    if (stops) return FrameOutcome::kStopped;
    return *drawn ? FrameOutcome::kDrawn : FrameOutcome::kNotShown;
}

void say_what_is_lacking(const jobs::RealTimeReport& report) {
    for (const jobs::RealTimeLack& lack : report.lacks()) {
        remark(fmt::format("real time: {}; {}; to mend it, {}", lack.what, lack.cost, lack.remedy));
    }
}

Result<void> play(const LiveOptions& options) {
    if (options.stats) {
        if (auto place = files::check_output_place(*options.stats); !place) return place;
    }
    auto performance = load_performance(options.input);
    if (!performance) return performance.error();
    if (performance->remark) remark(*performance->remark);

    const jobs::CoreChoice core = leave_haptic_core();
    auto view = wheel::LiveView::open({.width = options.size.width,
                                       .height = options.size.height,
                                       .headless = options.headless,
                                       .paper = performance->start.state.paper() != nullptr,
                                       .draw_threads = draw_threads(core),
                                       .backend = options.backend.value_or(render::BackendChoice::kAuto),
                                       .title = "Onggi"});
    if (!view) return view.error();
    if (const std::string& lack = (*view)->workshop_lack(); !lack.empty()) remark(lack);
    leave_haptic_core_wholly(core);
    const bool is_real_time = jobs::probe_real_time({.core = core}).fifo.grant == jobs::Grant::kGranted;
    if (auto shared = (*view)->share_drawing(jobs::cores_of_second_thread(core, is_real_time)); !shared)
        return shared;

    auto devices = AttachedDevices::make(options.device, std::move(performance->player), true);
    if (!devices) return devices.error();
    const double rate_hz = performance->start.parameters.rate_hz();
    const double seconds = options.seconds.value_or(static_cast<double>(performance->tick_count) / rate_hz);
    Progress progress("playing", static_cast<std::uint64_t>(seconds * kFrameRateHz));
    std::uint64_t frame = 0;
    note_end_signals();
    KioskSound sound(options.volume.value_or(0.0));
    LiveForces forces(options.forces);
    if (auto started = forces.start(); !started) return started;
    const auto report =
        run_live({.start = std::move(performance->start),
                  .devices = devices->take(),
                  .tick_count = performance->tick_count,
                  .seconds = options.seconds,
                  .wait = options.wait == "sleep" ? jobs::WaitMode::kSleep : jobs::WaitMode::kHybrid,
                  .real_time = {.core = core}},
                 [&](const haptic::Snapshot& snapshot) {
                     progress.reached_rarely(frame++);
                     sound.hear(snapshot);
                     if (const std::string line = sound.news(); !line.empty()) remark(line);
                     for (const std::string& line : devices->news())
                         remark(line);
                     return show(**view, forces, snapshot);
                 });
    if (!report) return report.error();
    say_what_is_lacking(report->real_time);
    if (!options.stats) return {};
    auto stats = live_stats(*report);
    stats["picture"] = {{"device", (*view)->device_name()}, {"quality", (*view)->quality()}};
    return files::write_file_atomically(*options.stats, stats.dump(2) + "\n");
}

std::string check_wait(const std::string& word) {
    if (word == "hybrid" || word == "sleep") return {};
    return fmt::format("expected hybrid or sleep, found {}", in_quotes(word));
}

}  // namespace

void add_live_command(CLI::App& program, int& exit_status) {
    CLI::App* command =
        program.add_subcommand("live", "play a gesture or session in real time, with its picture");
    const auto options = std::make_shared<LiveOptions>();
    add_input_file(*command, options->input);
    add_clay_options(*command, options->input);
    add_rate_option(*command, options->input);
    add_number_option(*command, "--seconds", options->seconds, kLeastSeconds, kMostSeconds,
                      "duration; past its end the gesture starts again on a fresh lump");
    command->add_option("--wait", options->wait, "how the haptic loop waits: hybrid or sleep (hybrid)")
        ->type_name("hybrid|sleep")
        ->check(CLI::Validator(check_wait, ""));
    add_device_option(*command, options->device, "gesture");
    add_number_option(*command, "--volume", options->volume, 0.0, 1.0, "volume of the wheel, 0 to 1 (0)");
    command->add_flag("--headless", options->headless, "draw without a window or display");
    command->add_flag("--forces", options->forces,
                      "start with the forces shown; in the window, V shows and hides them");
    add_size_option(*command, options->size);
    add_backend_option(*command, options->backend,
                       "what draws: the GPU, the processor, or the GPU if there is one (auto); without a "
                       "GPU, gpu is drawn by software, for testing");
    command->add_option("--stats", options->stats, "statistics of ticks and frames")->type_name("F.json");
    command->callback([options, &exit_status] {
        if (options->device != "gesture") {
            if (const auto end = supervise_devices()) {
                exit_status = *end;
                return;
            }
        }
        exit_status = exit_code(play(*options));
    });
}

}  // namespace onggi::app
