#include "game/haptic/job.h"

#include <utility>

namespace onggi::haptic {
namespace {

constexpr std::size_t kCommandCapacity = 256;

// Room for as many hashes as there is for records.
std::size_t hash_capacity(const HapticJobOptions& options) {
    return options.record_capacity / record::kHashInterval + 2;
}

jobs::FixedRateJobOptions job_options(const HapticParameters& parameters, const HapticJobOptions& options) {
    return {.thread_name = "onggi-haptic",
            .pacing = {.rate_hz = parameters.clay.rate_hz, .wait = options.wait},
            .real_time = options.real_time,
            .policy = options.policy};
}

}  // namespace

HapticWork::HapticWork(HapticState start, const HapticParameters& parameters,
                       std::unique_ptr<haptics::HapticDevice> device, const HapticJobOptions& options)
    : start_(std::move(start)),
      parameters_(parameters),
      options_(options),
      device_(std::move(device)),
      state_(start_),
      commands_(kCommandCapacity),
      records_(options.record_capacity),
      hashes_(hash_capacity(options)),
      snapshots_(first_snapshot(start_)) {}

bool HapticWork::tick(const jobs::Period& period) noexcept {
    skipped_periods_ += period.skipped;
    obey_commands();
    if (run_is_over()) put_on_fresh_lump();

    const haptics::ToolState tool = device_->read(ticks_of_run(), period.dt_s);
    const TickResult result = haptic::tick(state_, tool, parameters_);
    device_->write(result.limited_force_n);
    keep_record(result);
    publish(result);
    lump_is_fresh_ = false;

    const bool time_is_up = options_.end_periods != 0 && period.index + 1 >= options_.end_periods;
    const bool last_run_is_over = run_is_over() && !options_.repeat;
    return !time_is_up && !last_run_is_over;
}

const Snapshot& HapticWork::newest_snapshot() noexcept {
    snapshots_.acquire();
    return snapshots_.reading();
}

void HapticWork::obey_commands() noexcept {
    Command command{};
    while (commands_.try_pop(command)) {
        switch (command) {
            case Command::kFreshLump:
                put_on_fresh_lump();
                break;
            case Command::kRearmForce:
                haptics::rearm(state_.safety);
                break;
        }
    }
}

void HapticWork::put_on_fresh_lump() noexcept {
    state_.restart_from(start_);
    lump_is_fresh_ = true;
    ++run_;
}

void HapticWork::keep_record(const TickResult& result) noexcept {
    TickRecord record;
    record.tick = static_cast<std::uint32_t>(state_.ticks - 1);
    if (state_.tool.wheel_button) record.flags |= TickRecord::kWheelButton;
    if (lump_is_fresh_) record.flags |= TickRecord::kFreshLump;
    if (result.hash_due) record.flags |= TickRecord::kHashDue;
    if (state_.safety.fault != haptics::Fault::kNone) record.flags |= TickRecord::kFault;
    record.position_mm = state_.tool.position_mm;
    record.radius_mm = state_.tool.radius_mm;
    record.force_n = result.forces.total_n();

    bool kept = true;
    if (result.hash_due) kept = hashes_.try_push({.ticks = state_.ticks, .state_hash = result.state_hash});
    kept = records_.try_push(record) && kept;
    if (!kept) ++dropped_records_;
}

void HapticWork::publish(const TickResult& result) noexcept {
    Snapshot& snapshot = snapshots_.writing();
    fill_snapshot(snapshot, state_, result);
    snapshot.run = run_;
    snapshot.skipped_periods = skipped_periods_;
    snapshots_.publish();
}

HapticJob::HapticJob(HapticState start, const HapticParameters& parameters,
                     std::unique_ptr<haptics::HapticDevice> device, const HapticJobOptions& options)
    : work_(std::move(start), parameters, std::move(device), options),
      job_(job_options(parameters, options)) {}

Result<void> HapticJob::start() {
    if (Result<void> opened = work_.device().open(); !opened) return opened;
    device_is_open_ = true;
    Result<void> started = job_.start(work_);
    if (!started) stop();
    return started;
}

void HapticJob::stop() noexcept {
    job_.stop();
    if (std::exchange(device_is_open_, false)) work_.device().close();
}

}  // namespace onggi::haptic
