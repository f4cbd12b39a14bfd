#include "game/app/kiosk_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/files/asset_folder.h"
#include "engine/files/read_file.h"
#include "engine/haptics/simulated_device.h"
#include "engine/jobs/clock.h"
#include "engine/jobs/frame_pacer.h"
#include "engine/jobs/thread_setup.h"
#include "game/app/command_line.h"
#include "game/app/end_signal.h"
#include "game/app/hand_devices.h"
#include "game/app/haptic_core.h"
#include "game/app/haptic_guard.h"
#include "game/app/kiosk_settings.h"
#include "game/app/kiosk_sound.h"
#include "game/app/kiosk_visit.h"
#include "game/app/live_loop.h"
#include "game/app/options.h"
#include "game/haptic/job.h"
#include "game/wheel/live_view.h"

namespace onggi::app {
namespace {

// Where the kernel keeps deadlines for us the hand gets the finer rate.
constexpr double kRealTimeRateHz = 4000.0;
constexpr double kPlainRateHz = 1000.0;
constexpr double kNsPerSecond = 1e9;

struct KioskOptions {
    PictureSize size;
    bool full_screen = false;
    std::string device = "auto";
    std::string config;
    std::string gallery;
    std::optional<double> volume = {};
};

// What the wheel shows by itself while nobody is there; without it the wheel waits with its lump.
std::optional<haptics::Gesture> demonstration() {
    constexpr std::size_t kMostBytes = std::size_t{16} << 20U;
    const auto folder = files::find_asset("gestures/attract.csv");
    if (!folder) {
        remark(folder.error().message);
        return std::nullopt;
    }
    const auto text = files::read_file(*folder, kMostBytes);
    const auto gesture =
        text ? haptics::parse_gesture(*text, "attract.csv") : Result<haptics::Gesture>(text.error());
    if (gesture) return *gesture;
    remark(gesture.error().message);
    return std::nullopt;
}

// The visitor turns the volume in steps.
constexpr double kLoudestStep = 5.0;

Result<void> run_visits(KioskVisit& visit, haptic::HapticJob& job, std::optional<double> volume) {
    KioskSound sound(volume.value_or(visit.state().comfort.volume / kLoudestStep));
    jobs::MonotonicClock clock;
    jobs::FramePacer<> pacer(clock, kFrameRateHz);
    while (!visit.quits() && !end_was_asked() && !job.finished()) {
        pacer.wait();
        const double now_s = static_cast<double>(jobs::MonotonicClock::now_ns()) / kNsPerSecond;
        if (auto shown = visit.frame(now_s); !shown) return shown;
        if (!volume) sound.set_volume(visit.state().comfort.volume / kLoudestStep);
        sound.hear(job.newest_snapshot());
        if (const std::string line = sound.news(); !line.empty()) remark(line);
        pacer.finish();
    }
    return {};
}

Result<void> open_kiosk(const KioskOptions& options) {
    auto settings = load_settings(options.config);
    if (!settings) return settings.error();
    if (!options.gallery.empty()) settings->config.gallery.folder = options.gallery;
    const jobs::CoreChoice core = leave_haptic_core();
    auto view =
        wheel::LiveView::open({.width = options.size.width,
                               .height = options.size.height,
                               .full_screen = options.full_screen || settings->config.screen.full_screen,
                               .draw_threads = draw_threads(core),
                               .title = "Onggi"});
    if (!view) return view.error();
    for (const std::string& line : settings->remarks)
        remark(line);
    if (const std::string& lack = (*view)->workshop_lack(); !lack.empty()) remark(lack);
    if (const std::string lack = screens::missing_fonts(); !lack.empty()) remark(lack);

    const jobs::RealTimeRequest real_time{.core = core};
    const bool is_real_time = jobs::probe_real_time(real_time).fifo.grant == jobs::Grant::kGranted;
    const double wanted_hz = settings->config.haptics.rate_hz;
    const haptic::HapticState start{clay::StudioClay(clay::StudioLump{})};
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(wanted_hz > 0.0 ? wanted_hz : is_real_time ? kRealTimeRateHz : kPlainRateHz);
    parameters.studio.forgiving = settings->config.visit.forgiving;
    auto device = std::make_unique<haptics::SimulatedDevice>();
    haptics::SimulatedDevice& hand = *device;
    hand.set_target({.position_mm = {170.0, 220.0, 120.0}});
    parameters.safety = haptics::limits_for(device->capabilities());
    auto devices = HandDevices::make(settings->config.haptics.devices ? options.device : "mouse",
                                     std::move(device), false);
    if (!devices) return devices.error();
    haptic::HapticJobOptions job_options;
    job_options.real_time = real_time;
    haptic::HapticJob job(start, parameters, devices->take(), job_options);
    const std::string& wanted = settings->config.staff.statistics_folder;
    const std::filesystem::path statistics =
        wanted.empty() ? std::filesystem::path(settings->config.gallery.folder) / "statistics"
                       : std::filesystem::path(wanted);
    KioskKeeper keeper(job, start, parameters, Gallery(settings->config), statistics);
    note_end_signals(settings->rules.locked);
    if (auto started = job.start(); !started) return started;
    if (auto started = keeper.start(); !started) return started;
    const StopGuard stop_guard(job);
    for (const std::string& line : job.refusals())
        remark(line);
    const std::optional<haptics::Gesture> shown = demonstration();
    Result<void> played;
    {
        KioskVisit visit({.view = **view,
                          .job = job,
                          .hand = hand,
                          .devices = *devices,
                          .keeper = keeper,
                          .settings = *settings,
                          .demonstration = shown,
                          .rate_hz = parameters.rate_hz()});
        played = visit.start();
        if (played) played = run_visits(visit, job, options.volume);
    }
    keeper.stop();
    job.stop();
    return played;
}

}  // namespace

void add_kiosk_command(CLI::App& program, int& exit_status) {
    CLI::App* command =
        program.add_subcommand("kiosk", "the experience, in a window; also what onggi does alone");
    const auto options = std::make_shared<KioskOptions>();
    add_size_option(*command, options->size);
    command->add_flag("--full-screen", options->full_screen, "fill the primary screen");
    command
        ->add_option("--config", options->config, "settings of this kiosk (assets/kiosk.toml shows them all)")
        ->type_name("FILE.toml");
    command->add_option("--gallery", options->gallery, "where pots are saved, whatever the settings say")
        ->type_name("FOLDER");
    add_device_option(*command, options->device);
    add_volume_option(*command, options->volume);
    command->callback([options, &exit_status] {
        if (options->device != "mouse") {
            if (const auto end = supervise_devices()) {
                exit_status = *end;
                return;
            }
        }
        const auto done = open_kiosk(*options);
        exit_status = done ? 0 : report(done.error());
    });
}

}  // namespace onggi::app
