#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/jobs/clock.h"
#include "engine/jobs/frame_pacer.h"
#include "engine/jobs/shared_loop.h"
#include "engine/jobs/thread_setup.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/live_loop.h"
#include "game/app/command_line/options.h"
#include "game/app/devices/attached_devices.h"
#include "game/app/devices/haptic_guard.h"
#include "game/app/kiosk/gallery/moving_house.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/demonstrations.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/app/kiosk/presentation/kiosk_voice.h"
#include "game/app/kiosk/visit/kiosk_visit.h"
#include "game/app/system/end_signal.h"
#include "game/app/system/haptic_core.h"
#include "game/app/system/picture_note.h"
#include "game/app/system/report.h"
#include "game/app/system/service.h"
#include "game/app/system/start_log.h"
#include "game/app/system/wall_clock.h"
#include "game/haptic/job.h"
#include "game/haptic/simulated_device.h"
#include "game/screens/page/legibility.h"
#include "game/visit/steps.h"
#include "game/wheel/live_view.h"

namespace onggi::app {
namespace {

struct KioskOptions {
    PictureSize size;
    bool full_screen = false;
    std::string device = "auto";
    std::string config;
    std::string other_config;  // for the message when it cannot be read
    std::string gallery;
    std::optional<double> volume = {};
    std::optional<render::BackendChoice> backend = {};
};

// Returns a number that changes with every tick.
std::uint64_t tick_mark(const haptic::Snapshot& snapshot) {
    return snapshot.tick + (snapshot.run << 40U) + (snapshot.states_put << 32U);
}

// Returns the backend of the command line, else of the settings, which have been validated.
render::BackendChoice backend_of(const KioskOptions& options, const kiosk::Config& config) {
    return options.backend.value_or(
        render::backend_choice_named(config.screen.backend).value_or(render::BackendChoice::kAuto));
}

// The kiosk's services other than the visits.
struct Beside {
    KioskKeeper& keeper;
    KioskSound& sound;
    wheel::LiveView& view;
    PictureNote* picture;  // null: this run's quality is not remembered
};

// The file's settings, overridden by the command line.
Result<KioskSettings> settings_of(const KioskOptions& options) {
    auto settings = load_settings(options.config, options.other_config);
    if (settings && !options.gallery.empty()) settings->config.gallery.folder = options.gallery;
    return settings;
}

Result<void> run_visits(KioskVisit& visit, haptic::HapticJob& job, const Beside& beside) {
    KioskSound& sound = beside.sound;
    KioskKeeper& keeper = beside.keeper;
    Service service;
    jobs::MonotonicClock clock;
    double frame_rate_hz = beside.view.frame_rate_hz();
    std::optional<jobs::FramePacer<>> pacer;
    pacer.emplace(clock, frame_rate_hz);
    std::optional<double> beat_s;
    bool has_drawn = true;
    while (!visit.quits() && !end_was_asked()) {
        if (job.finished()) return failed("the haptic loop has ended by itself");
        // The display or the GPU has changed.
        if (const double rate_hz = beside.view.frame_rate_hz(); rate_hz != frame_rate_hz)
            pacer.emplace(clock, frame_rate_hz = rate_hz);
        // A frame without a picture has nothing to wait for.
        pacer->wait(has_drawn && beside.view.wait_for_display());
        const double now_s = jobs::MonotonicClock::now_s();
        const std::uint64_t shown_before = visit.frames_shown();
        if (auto shown = visit.frame(now_s); !shown) return shown;
        has_drawn = visit.frames_shown() != shown_before;
        // The first beat follows the first picture.
        if (beat_s ? now_s - *beat_s >= KioskHeartbeat::kEveryS : visit.frames_shown() > 0) {
            beat_s = now_s;
            keeper.beat(visit.pulse());
        }
        service.live(now_s, {visit.frames_shown(), tick_mark(job.newest_snapshot())});
        service.say(fmt::format("{}; {} pots kept since the start", visit::step_of(visit.state().screen).name,
                                visit.pots_kept()));
        if (const std::string line = sound.news(); !line.empty()) remark(line);
        if (beside.picture != nullptr) {
            if (auto kept = beside.picture->keep(beside.view.quality_note()); !kept)
                remark(kept.error().message);
        }
        pacer->finish();
    }
    service.ends();
    if (end_was_asked()) remark("ending, as requested");
    if (visit.quits())
        remark(visit.restarts() ? "restarting, as requested at the panel"
                                : "ending, as requested at the window");
    return {};
}

enum class KioskEnd { kDone, kStartAnew };

Result<std::unique_ptr<wheel::LiveView>> open_view(const KioskOptions& options, const KioskSettings& settings,
                                                   const jobs::CoreChoice& core, bool is_safe_mode,
                                                   std::string quality_note) {
    return wheel::LiveView::open({.width = options.size.width,
                                  .height = options.size.height,
                                  .full_screen = options.full_screen || settings.config.screen.full_screen,
                                  .plain = is_safe_mode,
                                  .draw_threads = draw_threads(core),
                                  .backend = backend_of(options, settings.config),
                                  .quality_note = std::move(quality_note),
                                  .workshop = settings.config.screen.room,
                                  .title = "Onggi"});
}

void warn_of_lacks(const KioskSettings& settings, const wheel::LiveView& view) {
    for (const std::string& line : settings.remarks)
        warn(line);
    for (const std::string& lack : {view.workshop_lack(), view.touch_lack()})
        if (!lack.empty()) warn(lack);
    if (const std::string lack = screens::missing_fonts(settings.config.languages.order); !lack.empty())
        warn(lack);
    for (const std::string& lack : panel_lacks(settings.config, view.width(), view.height()))
        warn(lack);
}

// Returns whether the haptic thread will have real-time priority, which decides where a second thread may
// draw.
bool share_drawing(wheel::LiveView& view, const jobs::RealTimeRequest& request) {
    const bool is_real_time = jobs::probe_real_time(request).fifo.grant == jobs::Grant::kGranted;
    const std::vector<int> cores = jobs::cores_of_second_thread(request.core, is_real_time);
    if (auto shared = view.share_drawing(cores); !shared) warn(shared.error().message);
    return is_real_time;
}

Show show_of(const ShowClay& clay) {
    std::vector<std::string> lacks;
    Show show = load_show(clay, lacks);
    for (const std::string& line : lacks)
        warn(line);
    return show;
}

haptic::HapticJobOptions kiosk_job_options(const jobs::RealTimeRequest& real_time, double rate_hz) {
    haptic::HapticJobOptions options;
    options.spares_the_core = true;
    options.real_time = real_time;
    // On a busy machine, the keeper may be late by this time without losing a visitor's pot.
    constexpr double kMostLateS = 16.0;
    options.record_capacity = static_cast<std::size_t>(kMostLateS * rate_hz);
    return options;
}

haptic::HapticParameters kiosk_parameters(const kiosk::Config& config, bool is_real_time) {
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(tick_rate_hz(config.haptics.rate_hz, is_real_time));
    parameters.studio.forgiving = config.visit.forgiving;
    return parameters;
}

// Without a synthesiser, visitors are not offered what they would not hear.
std::unique_ptr<KioskVoice> begin_voice(KioskSettings& settings) {
    std::string lack;
    auto voice = make_voice(settings.config, lack);
    if (!lack.empty()) warn("voice: " + lack);
    if (auto started = voice->start(); !started) warn(started.error().message);
    settings.rules.offers_speech = settings.rules.offers_speech && voice->can_synthesise();
    settings.rules.speaks = settings.rules.speaks && voice->can_synthesise();
    return voice;
}

void tell_last_answers(KioskKeeper& keeper) {
    while (const auto answer = keeper.next_answer())
        if (!answer->words.empty()) answer->is_trouble ? warn(answer->words) : remark(answer->words);
}

Result<KioskEnd> open_kiosk(const KioskOptions& options) {
    auto settings = settings_of(options);
    if (!settings) return settings.error();
    note_end_signals(settings->rules.locked);
    take_kept_house(*settings);
    const jobs::CoreChoice core = leave_haptic_core();
    const std::filesystem::path state = state_folder(settings->config.gallery.folder);
    GalleryLock lock;
    if (auto taken = lock.take(state); !taken) return taken.error();
    if (auto finished = finish_import(settings->config); !finished) warn(finished.error().message);
    StartKeeper starts(state);
    const StartReport start_report = starts.begin_now(settings->remarks);
    PictureNote picture(state);
    auto view = open_view(options, *settings, core, start_report.is_safe_mode, picture.read());
    if (!view) return starts.end_without(view.error());
    leave_haptic_core_wholly(core);
    warn_of_lacks(*settings, **view);

    const jobs::RealTimeRequest real_time{.core = core};
    const bool is_real_time = share_drawing(**view, real_time);
    const haptic::HapticState start{clay::StudioClay(clay::StudioLump{})};
    haptic::HapticParameters parameters = kiosk_parameters(settings->config, is_real_time);
    auto device = std::make_unique<haptic::SimulatedDevice>();
    haptic::SimulatedDevice& pointer = *device;
    pointer.set_target(resting_finger());
    parameters.safety = haptics::limits_for(device->capabilities());
    const bool has_devices = settings->config.haptics.devices && !start_report.is_safe_mode;
    const Show show = show_of({start, parameters.studio.forgiving});
    auto first =
        std::make_unique<DemonstrationDevice>(std::move(device), show.recordings, parameters.rate_hz());
    auto devices = AttachedDevices::make(has_devices ? options.device : "mouse", std::move(first), false);
    if (!devices) return devices.error();
    haptic::HapticJob job(start, parameters, devices->take(),
                          kiosk_job_options(real_time, parameters.rate_hz()));
    KioskKeeper keeper(job, start, parameters, Gallery(settings->config), statistics_folder(settings->config),
                       KioskHeartbeat(settings->config));
    if (auto started = job.start(); !started) return started.error();
    if (auto started = keeper.start(); !started) return started.error();
    keeper.note_start();
    KioskPhone phone(*settings, "/proc/self/exe");
    if (auto started = phone.start(); !started) return started.error();
    const StopGuard stop_guard(job);
    for (const std::string& line : job.refusals())
        warn(line);
    KioskSound sound(options.volume.value_or(settings->config.sound.volume / kLoudestStep),
                     options.volume.has_value());
    const auto voice = begin_voice(*settings);
    Result<void> played;
    KioskEnd end = KioskEnd::kDone;
    {
        KioskVisit visit({.view = **view,
                          .job = job,
                          .pointer = pointer,
                          .devices = *devices,
                          .keeper = keeper,
                          .phone = kiosk::shares(settings->config) ? &phone : nullptr,
                          .sound = sound,
                          .voice = voice.get(),
                          .settings = *settings,
                          .show = show,
                          .start = start_report,
                          .rate_hz = parameters.rate_hz()});
        played = visit.start();
        if (played)
            played = run_visits(visit, job,
                                {.keeper = keeper,
                                 .sound = sound,
                                 .view = **view,
                                 .picture = start_report.is_safe_mode ? nullptr : &picture});
        if (visit.restarts()) end = KioskEnd::kStartAnew;
    }
    phone.stop();
    keeper.stop();
    job.stop();
    tell_last_answers(keeper);
    // An error that ends the program counts as a crash, because it may repeat after the restart.
    if (played) played = starts.end_now();
    if (!played) return played.error();
    return end;
}

// After the supervised kiosk has ended, writes its end to the journal and to the status file for remote
// monitoring.
void tell_of_end(const KioskOptions& options, int code) {
    // A kiosk that could not start has already printed its error.
    if (code == 0 || code == exit_code(ErrorKind::kFailed))
        remark(fmt::format("the kiosk ended with exit code {}", code));
    if (code == 0) return;
    const auto settings = settings_of(options);
    if (!settings) return;  // the kiosk has printed the error
    if (GalleryLock::other_at(state_folder(settings->config.gallery.folder)))
        return;  // the status is the other kiosk's
    if (auto told = KioskHeartbeat(settings->config).end_after_fall(wall_clock_s()); !told)
        warn(told.error().message);
}

// Restarts the program in this process; returns the exit code if that fails.
int begin_anew() {
    static_cast<void>(report(start_anew()));
    return kRestartExitCode;
}

}  // namespace

void add_kiosk_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand("kiosk", "the kiosk, in a window; the default command");
    const auto options = std::make_shared<KioskOptions>();
    add_size_option(*command, options->size);
    command->add_flag("--full-screen", options->full_screen, "fill the primary screen");
    command
        ->add_option("--config", options->config, "settings of this kiosk (assets/kiosk.toml shows them all)")
        ->type_name("FILE.toml");
    command
        ->add_option("--or-config", options->other_config,
                     "fallback settings if those of --config cannot be read")
        ->type_name("FILE.toml");
    command->add_option("--gallery", options->gallery, "the folder for pots, overriding the settings")
        ->type_name("FOLDER");
    add_device_option(*command, options->device);
    add_volume_option(*command, options->volume);
    add_backend_option(*command, options->backend,
                       "what draws, overriding the settings: the GPU, the processor, or the GPU if there is "
                       "one (auto); without a GPU, gpu is drawn by software, for testing");
    command->footer(
        "In the window: V shows what the hand feels, F or F11 fills the screen, arrow keys move the hand, "
        "Tab "
        "and Enter\nwork the buttons, Space is a single switch, W says where you are, Esc leaves unless the "
        "kiosk is "
        "locked.");
    command->callback([options, &exit_status] {
        const bool lets_devices_push = options->device != "mouse";
        if (lets_devices_push) {
            if (const auto end = supervise_devices()) {
                if (*end != kRestartExitCode) tell_of_end(*options, *end);
                exit_status = *end == kRestartExitCode ? begin_anew() : *end;
                return;
            }
        }
        const auto done = open_kiosk(*options);
        exit_status = done ? 0 : report(done.error());
        if (!done || *done != KioskEnd::kStartAnew) return;
        exit_status = lets_devices_push && is_supervised() ? kRestartExitCode : begin_anew();
    });
}

}  // namespace onggi::app
