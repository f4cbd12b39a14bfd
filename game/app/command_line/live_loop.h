// Runs both real-time loops: the haptic job on its own core, and the picture at 60 Hz on the calling thread,
// which must be the main one. The caller draws the frames.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "engine/core/result.h"
#include "engine/haptics/haptic_device.h"
#include "engine/jobs/fixed_rate_job.h"
#include "engine/jobs/histogram.h"
#include "game/haptic/job.h"
#include "game/haptic/start_state.h"

namespace onggi::app {

constexpr double kFrameRateHz = 60.0;

struct LiveRun {
    haptic::Start start;
    haptic::ToolDevices devices;
    std::uint64_t tick_count = 0;   // length of the recording; it repeats on a fresh lump
    std::optional<double> seconds;  // duration; by default the path is played once
    jobs::WaitMode wait = jobs::WaitMode::kHybrid;
    jobs::RealTimeRequest real_time{};
};

enum class FrameOutcome {
    kDrawn,
    kNotShown,  // minimised, or between two sizes
    kStopped,   // drawn, and the window's stop key was pressed: forces off
    kClosed,    // the window was closed: the run ends
};
// Draws one snapshot and returns when the picture is done. An error ends the run.
using DrawFrame = std::function<Result<FrameOutcome>(const haptic::Snapshot&)>;

// The statistics of a run.
struct LiveReport {
    double rate_hz = 0.0;
    jobs::RealTimeReport real_time;
    jobs::TickStats ticks;
    std::uint64_t frames = 0;             // drawn
    std::optional<double> first_frame_s;  // time of the first frame since the process started
    std::optional<double> resident_mb;    // of the process, after the last frame
    std::optional<double> own_mb;         // the part that the process has allocated
    jobs::Histogram frame_ns;             // duration of a frame
    jobs::Histogram frame_interval_ns;    // from the start of a frame to the start of the next
    std::uint64_t lumps = 0;              // number of lumps started
    std::uint64_t dropped_records = 0;
    haptic::SafetyReport safety;
    double most_force_n = 0.0;  // limit for each hand
    haptic::HapticState state;  // at the end
};

// A device that cannot render this clay gets no force, and one line on stderr states the reason. Errors: the
// device's or the thread's (see HapticJob::start), or the first that `draw` returned.
[[nodiscard]] Result<LiveReport> run_live(LiveRun run, const DrawFrame& draw);

// Discards the records of a live run, which are not needed: a full ring would count lost ticks. Call it once
// a frame.
void pass_over_records(haptic::HapticJob& job);

}  // namespace onggi::app
