#include "game/app/kiosk_command.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "engine/asset/image.h"
#include "engine/core/units.h"
#include "engine/files/atomic_file.h"
#include "engine/haptics/simulated_device.h"
#include "engine/jobs/clock.h"
#include "engine/jobs/frame_pacer.h"
#include "engine/jobs/thread_setup.h"
#include "game/app/command_line.h"
#include "game/app/haptic_core.h"
#include "game/app/kiosk_input.h"
#include "game/app/live_loop.h"
#include "game/app/options.h"
#include "game/app/snapshot_view.h"
#include "game/haptic/job.h"
#include "game/share/export.h"
#include "game/wheel/live_view.h"
#include "game/wheel/still.h"

namespace onggi::app {
namespace {

// Where the kernel keeps deadlines for us the hand gets the finer rate.
constexpr double kRealTimeRateHz = 4000.0;
constexpr double kPlainRateHz = 1000.0;

struct KioskOptions {
    PictureSize size;
    bool full_screen = false;
};

// The first of out/pot-1.glb, out/pot-2.glb, ... that is not there yet.
Result<std::filesystem::path> free_place(const std::string& ending) {
    const std::filesystem::path folder = "out";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return system_lacks(
            fmt::format("out: expected a folder to save in, found none: {}", error.message()));
    for (int number = 1;; ++number) {
        std::filesystem::path place = folder / fmt::format("pot-{}{}", number, ending);
        if (!std::filesystem::exists(place, error)) return place;
    }
}

Result<void> save(const std::string& ending, const Result<std::vector<std::byte>>& bytes) {
    if (!bytes) return bytes.error();
    const auto place = free_place(ending);
    if (!place) return place.error();
    if (auto written = files::write_file_atomically(*place, *bytes); !written) return written;
    remark(fmt::format("saved {}", place->string()));
    return {};
}

Result<std::vector<std::byte>> picture_of(const wheel::PotView& pot, const wheel::LiveView& view) {
    wheel::PotView alone = pot;
    alone.tool_shown = false;
    const auto image = wheel::render_still(alone, view.width(), view.height());
    if (!image) return image.error();
    return asset::encode_png(*image);
}

std::string title_of(const haptic::Snapshot& snapshot, const haptic::HapticParameters& parameters) {
    const double rev_min =
        snapshot.wheel_turning ? units::rev_min_from_rad_s(parameters.clay.wheel_speed_rad_s) : 0.0;
    return fmt::format("Onggi - tool {:.0f} mm, wheel {:.0f} rev/min, force {:.2f} N{}",
                       snapshot.tool.radius_mm, rev_min, glm::length(snapshot.limited_force_n),
                       snapshot.fault == haptics::Fault::kNone ? "" : ", stopped for safety: press R");
}

// One visitor after another, until somebody closes the window.
class Kiosk {
  public:
    Kiosk(wheel::LiveView& view, haptic::HapticJob& job, haptics::SimulatedDevice& hand,
          const haptic::HapticParameters& parameters, double height_mm)
        : view_(view),
          job_(job),
          hand_(hand),
          parameters_(parameters),
          height_mm_(height_mm) {}

    Result<void> run() {
        jobs::MonotonicClock clock;
        jobs::FramePacer<> pacer(clock, kFrameRateHz);
        while (!quits_ && !job_.finished()) {
            pacer.wait();
            if (auto shown = frame(); !shown) return shown;
            pacer.finish();
        }
        return {};
    }

  private:
    Result<void> frame() {
        const haptic::Snapshot& snapshot = job_.newest_snapshot();
        const wheel::PotView pot = pot_view(snapshot, height_mm_);
        const KioskInput::PlaceOf place_of = [&](double x_px, double y_px) {
            return view_.tool_target_mm(x_px, y_px);
        };
        for (const window::Event& event : view_.poll_events()) {
            // What cannot be saved is said, and the visitor throws on.
            if (auto done = act(input_.handle(event, place_of), pot); !done) remark(done.error().message);
        }
        hand_.set_target(input_.target());
        auto drawn = view_.draw(pot);
        if (!drawn) return drawn.error();
        constexpr std::uint64_t kFramesPerTitle = 12;  // five times a second is as quick as one can read
        if (frames_++ % kFramesPerTitle == 0) view_.set_title(title_of(snapshot, parameters_));
        pass_over_records(job_);
        return {};
    }

    Result<void> act(KioskAction action, const wheel::PotView& pot) {
        switch (action) {
            case KioskAction::kNone:
                break;
            case KioskAction::kQuit:
                quits_ = true;
                break;
            case KioskAction::kFreshLump:
                // A full ring means that the haptic thread stands still; then the window says nothing new
                // either.
                static_cast<void>(job_.send(haptic::Command::kFreshLump));
                static_cast<void>(job_.send(haptic::Command::kRearmForce));
                break;
            case KioskAction::kSaveModel:
                return save(".glb", share::export_pot({.height_mm = pot.height_mm, .radii_mm = pot.radii_mm},
                                                      share::ExportKind::kGlb));
            case KioskAction::kSavePicture:
                return save(".png", picture_of(pot, view_));
            case KioskAction::kToggleFullScreen:
                full_screen_ = !full_screen_;
                view_.set_full_screen(full_screen_);
                break;
        }
        return {};
    }

    wheel::LiveView& view_;
    haptic::HapticJob& job_;
    haptics::SimulatedDevice& hand_;
    const haptic::HapticParameters& parameters_;
    double height_mm_;
    KioskInput input_;
    std::uint64_t frames_ = 0;
    bool full_screen_ = false;
    bool quits_ = false;
};

Result<void> open_kiosk(const KioskOptions& options) {
    const jobs::CoreChoice core = leave_haptic_core();
    auto view = wheel::LiveView::open({.width = options.size.width,
                                       .height = options.size.height,
                                       .full_screen = options.full_screen,
                                       .title = "Onggi"});
    if (!view) return view.error();

    const jobs::RealTimeRequest real_time{.core = core};
    const bool is_real_time = jobs::probe_real_time(real_time).fifo.grant == jobs::Grant::kGranted;
    haptic::HapticState start;
    haptic::HapticParameters parameters;
    parameters.clay.rate_hz = is_real_time ? kRealTimeRateHz : kPlainRateHz;
    auto device = std::make_unique<haptics::SimulatedDevice>();
    haptics::SimulatedDevice& hand = *device;
    hand.set_target(KioskInput().target());
    parameters.safety = haptics::limits_for(device->capabilities());
    const double height_mm = start.clay.height_mm();
    haptic::HapticJobOptions job_options;
    job_options.real_time = real_time;
    haptic::HapticJob job(std::move(start), parameters, std::move(device), job_options);
    if (auto started = job.start(); !started) return started;
    auto played = Kiosk(**view, job, hand, parameters, height_mm).run();
    job.stop();
    return played;
}

}  // namespace

void add_kiosk_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand("kiosk", "the wheel in a window; also what onggi does alone");
    const auto options = std::make_shared<KioskOptions>();
    add_size_option(*command, options->size);
    command->add_flag("--full-screen", options->full_screen, "fill the primary screen");
    command->callback([options, &exit_status] {
        const auto done = open_kiosk(*options);
        exit_status = done ? 0 : report(done.error());
    });
}

}  // namespace onggi::app
