// Both loops in real time: the haptic job on its own core, and the picture at 60 Hz on the calling thread,
// which must be the main one. What a frame is made of is the caller's affair.
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
    std::uint64_t tick_count = 0;   // of the recording; then it starts again on a fresh lump
    std::optional<double> seconds;  // the end; none: when the path has been played once
    jobs::WaitMode wait = jobs::WaitMode::kHybrid;
    jobs::RealTimeRequest real_time{};
};

enum class FrameOutcome {
    kDrawn,
    kNotShown,  // minimised, or between two sizes
    kStopped,   // drawn, and the window's stop key was pressed: no force from here on
    kClosed,    // the visitor has closed the window: the run ends
};
// Draws one snapshot and returns when the picture is done. An error ends the run.
using DrawFrame = std::function<Result<FrameOutcome>(const haptic::Snapshot&)>;

// What a run was like.
struct LiveReport {
    double rate_hz = 0.0;
    jobs::RealTimeReport real_time;
    jobs::TickStats ticks;
    std::uint64_t frames = 0;             // drawn
    std::optional<double> first_frame_s;  // when the first was there, since the process was started
    std::optional<double> resident_mb;    // of the process, after the last
    std::optional<double> own_mb;         // what of that it has allocated
    jobs::Histogram frame_ns;             // what a frame took
    jobs::Histogram frame_interval_ns;    // from the start of a frame to the start of the next
    std::uint64_t lumps = 0;              // how many were begun
    std::uint64_t dropped_records = 0;
    haptic::SafetyReport safety;
    double most_force_n = 0.0;  // that any of the hands may be told
    haptic::HapticState state;  // at the end
};

// A device that cannot be shown this clay gets no force, and one line on stderr says why.
// Errors: the device's or the thread's (see HapticJob::start), or the first that `draw` returned.
[[nodiscard]] Result<LiveReport> run_live(LiveRun run, const DrawFrame& draw);

// Nobody records a live run, but the rings must not run full: a full one counts as lost ticks. Once a frame.
void pass_over_records(haptic::HapticJob& job);

}  // namespace onggi::app
