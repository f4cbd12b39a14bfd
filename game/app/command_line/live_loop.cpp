#include "game/app/command_line/live_loop.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/jobs/clock.h"
#include "engine/jobs/frame_pacer.h"
#include "game/app/devices/haptic_guard.h"
#include "game/app/system/process_use.h"
#include "game/app/system/report.h"

namespace onggi::app {
namespace {

haptic::HapticJobOptions job_options(const LiveRun& run) {
    haptic::HapticJobOptions options;
    options.wait = run.wait;
    options.real_time = run.real_time;
    options.run_ticks = run.tick_count;
    options.repeat = run.seconds.has_value();
    if (run.seconds) {
        const double periods = std::round(*run.seconds * run.start.parameters.rate_hz());
        options.end_periods = static_cast<std::uint64_t>(std::max(1.0, periods));
    }
    return options;
}

}  // namespace

void pass_over_records(haptic::HapticJob& job) {
    haptic::TickRecord record;
    while (job.take_record(record)) {
    }
}

Result<LiveReport> run_live(LiveRun run, const DrawFrame& draw) {
    const haptic::HapticJobOptions options = job_options(run);
    const double rate_hz = run.start.parameters.rate_hz();
    run.start.parameters.safety = haptics::limits_for(run.devices.all().capabilities());
    LiveReport report;
    for (const haptics::DeviceCapabilities& device : run.devices.all().capabilities_of_devices())
        report.most_force_n = std::max(report.most_force_n, haptics::limits_for(device).peak_force_n);
    haptic::HapticJob job(std::move(run.start.state), run.start.parameters, std::move(run.devices), options);
    if (auto started = job.start(); !started) return started.error();
    const StopGuard stop_guard(job);
    for (const std::string& line : job.refusals())
        remark(line);

    jobs::MonotonicClock clock;
    jobs::FramePacer<> pacer(clock, kFrameRateHz);
    bool open = true;
    while (open && !job.finished()) {
        pacer.wait();
        const auto outcome = draw(job.newest_snapshot());
        if (!outcome) return outcome.error();
        pacer.finish();
        if (*outcome == FrameOutcome::kStopped) job.stop_force();
        if (*outcome == FrameOutcome::kDrawn || *outcome == FrameOutcome::kStopped) ++report.frames;
        if (report.frames == 1 && !report.first_frame_s) report.first_frame_s = since_start_s();
        open = *outcome != FrameOutcome::kClosed;
        pass_over_records(job);
    }
    report.resident_mb = resident_mb();
    report.own_mb = own_mb();
    job.stop();

    report.rate_hz = rate_hz;
    report.real_time = job.real_time();
    report.ticks = job.stats();
    report.frame_ns = pacer.work_ns();
    report.frame_interval_ns = pacer.interval_ns();
    report.lumps = job.runs();
    report.dropped_records = job.dropped_records();
    report.state = job.state();
    report.safety = job.newest_snapshot().safety;
    return report;
}

}  // namespace onggi::app
