#include "game/haptic/job.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "game/haptic/tick.h"

namespace onggi::haptic {
namespace {

// The clay's state for the other displays of a device: stiffness and thickness at the touch, load. Fit for
// the tick. mm, N.
constexpr double kKpaPerNMm2 = 1000.0;

// Returns the state after the last tick.
haptics::WorkFelt work_felt(const HapticState& state, const TickResult& result,
                            const HapticParameters& parameters) noexcept {
    haptics::WorkFelt felt{.touches = result.forces.contacts > 0,
                           .stiffness_n_per_mm = result.forces.local_stiffness_n_per_mm};
    if (parameters.feel.most_stiffness_n_per_mm > 0.0)
        felt.stiffness_n_per_mm = std::min(felt.stiffness_n_per_mm, parameters.feel.most_stiffness_n_per_mm);
    const clay::StudioClay* studio = state.studio();
    if (studio == nullptr) return felt;
    felt.load = studio->load_index();
    const clay::studio::Rings& rings = studio->rings();
    if (rings.count == 0 || !felt.touches) return felt;
    const int ring = rings.ring_at(state.tool.position_mm.y);
    if (!rings.is_hollow(ring)) return felt;
    felt.wall_mm = rings.wall_mm(ring);
    // The force at which a wall of that thickness bends aside: the limit of the studio clay (force.h).
    const double strength_n_mm2 =
        static_cast<double>(rings.strength_kpa[static_cast<std::size_t>(ring)]) / kKpaPerNMm2;
    felt.most_force_n = kTurn * strength_n_mm2 * felt.wall_mm * felt.wall_mm;
    return felt;
}

constexpr std::size_t kCommandCapacity = 256;
// Limit of one tick's late count, which can be huge after the machine has slept.
constexpr std::uint64_t kMostLate = 1'000'000;
constexpr std::size_t kStateCapacity = 4;

// The ticks of that time; at least one.
std::uint64_t ticks_of(std::int64_t time_ns, double rate_hz) {
    return std::max<std::uint64_t>(static_cast<std::uint64_t>(static_cast<double>(time_ns) * 1e-9 * rate_hz),
                                   1);
}

jobs::FixedRateJobOptions job_options(const HapticParameters& parameters, const HapticJobOptions& options) {
    return {.thread_name = "onggi-haptic",
            .pacing = {.rate_hz = parameters.rate_hz(), .wait = options.wait},
            .real_time = options.real_time,
            .policy = options.policy};
}

}  // namespace

HapticWork::HapticWork(HapticState start, const HapticParameters& parameters, ToolDevices devices,
                       const HapticJobOptions& options)
    : start_(std::move(start)),
      ticks_a_rest_(ticks_of(haptics::Watchdog::kRestNs, parameters.rate_hz())),
      parameters_(parameters),
      options_(options),
      devices_(std::move(devices)),
      fits_(fits_for(devices_.all(), parameters_, start_.paper() != nullptr)),
      state_(start_),
      watchdog_(devices_.all(), {.rate_hz = parameters.rate_hz()}),
      commands_(kCommandCapacity),
      states_(kStateCapacity),
      old_states_(2 * kStateCapacity),
      records_(options.record_capacity),
      snapshots_(first_snapshot(start_, parameters_)),
      pots_([&] { return PotCopy{.pot = pot_of(start_), .stamp = {}}; }) {
    hold_to(fits_.front());
    state_.take_memory();
}

bool HapticWork::tick(const jobs::Period& period) noexcept {
    skipped_periods_ += period.skipped;
    ++periods_;
    apply_commands();
    put_on_states();
    if (run_is_over()) put_on_fresh_lump();

    const tool::ToolState tool = devices_.read(ticks_of_run(), period.dt_s);
    const TickResult result = haptic::tick(state_, tool, parameters_, device_tick(period));
    force_test_.see(tool.position_mm, result.limited_force_n);
    devices_.all().feel(work_felt(state_, result, parameters_));
    devices_.all().write(result.limited_force_n);
    largest_force_n2_ = std::max(largest_force_n2_, glm::dot(result.limited_force_n, result.limited_force_n));
    watchdog_.rest(rests_);
    watchdog_.beat();
    keep_record(result);
    publish(result);
    lump_is_fresh_ = false;
    state_was_put_ = false;

    const bool time_is_up = options_.end_periods != 0 && period.index + 1 >= options_.end_periods;
    const bool last_run_is_over = run_is_over() && !options_.repeat;
    return !time_is_up && !last_run_is_over;
}

const Snapshot& HapticWork::newest_snapshot() noexcept {
    if (snapshots_.acquire() || newest_.pot == nullptr) newest_ = snapshots_.reading();
    pots_.acquire();
    newest_.pot = &pots_.reading().pot;
    newest_.pot_stamp = pots_.reading().stamp;
    return newest_;
}

void HapticWork::apply_commands() noexcept {
    Command command{};
    while (commands_.try_pop(command)) {
        switch (command) {
            case Command::kFreshLump:
                force_test_.end();
                put_on_fresh_lump();
                break;
            case Command::kRearmForce:
                stop_asked_.store(false, std::memory_order_relaxed);
                haptics::rearm(state_.safety);
                break;
            case Command::kLetGo:
                nobody_is_there_ = true;
                break;
            case Command::kTakeHold:
                nobody_is_there_ = false;
                break;
            case Command::kTestForce:
                force_test_.begin(device_);
                break;
        }
    }
}

std::vector<HapticWork::Fit> HapticWork::fits_for(const haptics::HapticDevice& device,
                                                  const HapticParameters& parameters, bool is_paper) {
    std::vector<Fit> fits;
    for (const haptics::DeviceCapabilities& one : device.capabilities_of_devices()) {
        HapticParameters fitted = parameters;
        Result<void> done = fit_to_device(fitted, one, is_paper);
        if (!done) fitted.safety.peak_force_n = 0.0;
        fits.push_back({.safety = fitted.safety,
                        .feel = fitted.feel,
                        .step_mm = one.position_resolution_mm,
                        .has_motors = one.has_motors,
                        .is_felt = one.has_motors && one.force_axes > 0,
                        .fits = std::move(done)});
    }
    return fits;
}

std::vector<std::string> HapticWork::refusals() const {
    std::vector<std::string> lines;
    for (std::size_t device = 1; device < fits_.size(); ++device)
        if (!fits_[device].fits) lines.push_back(fits_[device].fits.error().message);
    return lines;
}

void HapticWork::hold_to(const Fit& fit) noexcept {
    parameters_.safety = fit.safety;
    parameters_.feel = fit.feel;
    state_.velocity = haptics::VelocityEstimator(fit.step_mm);
}

DeviceTick HapticWork::device_tick(const jobs::Period& period) noexcept {
    if (const std::uint32_t silences = watchdog_.silences(); silences != silences_) {
        silences_ = silences;
        state_.safety.applied_force_n = state_.safety.applied_driven_n = dvec3(0.0);
        haptics::restart_ramp(state_.safety);
    }
    DeviceTick device{.dt_s = period.dt_s,
                      .late = static_cast<std::uint32_t>(std::min<std::uint64_t>(period.skipped, kMostLate)),
                      .signs = devices_.all().signs(),
                      .stop = stop_asked_.load(std::memory_order_relaxed),
                      .comes_anew = state_was_put_};
    if (device.signs.device != device_ && device.signs.device < fits_.size()) {
        device_ = device.signs.device;
        hold_to(fits_[device_]);
        haptics::restart_ramp(state_.safety);
    }
    // A wheel without motors, at which nobody is, may be late by some ms.
    rests_ = options_.spares_the_core && nobody_is_there_ && !force_test_.runs() && device.signs.is_alone &&
             !fits_[device_].is_felt;
    // A running force test needs a person at the device.
    const bool alone = (nobody_is_there_ && !force_test_.runs()) || watchdog_.picture_stands_still();
    if (alone && fits_[device_].has_motors) device.signs.hand_is_there = false;
    device.test_force_n = force_test_.step(state_.safety, device_, parameters_.dt_s());
    return device;
}

void HapticWork::put_on_fresh_lump() noexcept {
    state_.restart_from(start_);
    pot_copier_.restart();
    lump_is_fresh_ = true;
    ++run_;
}

HapticWork::~HapticWork() {
    free_old_states();
    OfRun waiting;
    while (states_.try_pop(waiting))
        delete waiting.state;
}

bool HapticWork::put(std::unique_ptr<HapticState> state, std::uint64_t run) {
    assert(state->clay.index() == start_.clay.index());
    assert(state->element_count() == start_.element_count());
    state->take_memory();
    free_old_states();
    if (!states_.try_push({state.get(), run})) return false;
    static_cast<void>(state.release());  // the ring owns it now
    return true;
}

void HapticWork::free_old_states() noexcept {
    HapticState* state = nullptr;
    while (old_states_.try_pop(state))
        delete state;
}

void HapticWork::put_on_states() noexcept {
    OfRun put;
    while (states_.try_pop(put)) {
        if (put.run == run_) {
            std::swap(state_.clay, put.state->clay);
            state_.wheel = put.state->wheel;
            state_.tool = put.state->tool;
            state_.ticks = put.state->ticks;
            pot_copier_.restart();
            state_was_put_ = true;
            ++states_put_;
        }
        // The push cannot fail: put() frees old states before it sends more than the ring holds.
        static_cast<void>(old_states_.try_push(put.state));
    }
}

void HapticWork::keep_record(const TickResult& result) noexcept {
    TickRecord record;
    record.tick = static_cast<std::uint32_t>(state_.ticks - 1);
    record.run = static_cast<std::uint32_t>(run_);
    if (lump_is_fresh_) record.flags |= TickRecord::kFreshLump;
    if (state_was_put_) record.flags |= TickRecord::kStatePut;
    if (state_.safety.fault != haptics::Fault::kNone) record.flags |= TickRecord::kFault;
    record.tool = state_.tool;
    record.force_n = result.forces.total_n();
    if (!records_.try_push(record)) ++dropped_records_;
}

void HapticWork::publish(const TickResult& result) noexcept {
    Snapshot& snapshot = snapshots_.writing();
    fill_snapshot(snapshot, state_, result, parameters_);
    snapshot.run = run_;
    snapshot.states_put = states_put_;
    snapshot.skipped_periods = skipped_periods_;
    snapshot.periods = periods_;
    snapshot.force_test = force_test_.report();
    snapshot.safety.silences = silences_;
    snapshot.safety.largest_force_n = std::sqrt(largest_force_n2_);
    snapshots_.publish();
    PotCopy& copy = pots_.writing();
    if (!pot_copier_.step(copy.pot, state_, parameters_.dt_s())) return;
    // A fresh lump or a put state restarts the copy, so a finished copy shows the current clay.
    copy.stamp = {.tick = state_.ticks, .run = run_, .states_put = states_put_};
    pots_.publish();
}

HapticJob::HapticJob(HapticState start, const HapticParameters& parameters, ToolDevices devices,
                     const HapticJobOptions& options)
    : work_(std::move(start), parameters, std::move(devices), options),
      job_(job_options(parameters, options)) {}

Result<void> HapticJob::start() {
    if (!work_.fits()) return work_.fits();
    if (Result<void> opened = work_.device().open(); !opened) return opened;
    device_is_open_ = true;
    Result<void> started = job_.start(work_);
    if (started) started = watchdog_thread_.start(work_.watchdog(), "onggi-watchdog");
    if (!started) stop();
    return started;
}

void HapticJob::stop() noexcept {
    job_.stop();
    watchdog_thread_.stop();
    if (!std::exchange(device_is_open_, false)) return;
    // The haptic thread has ended, so this thread may use the device.
    work_.device().write(dvec3(0.0));
    work_.device().close();
}

}  // namespace onggi::haptic
