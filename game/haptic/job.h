// The running haptic loop: clay, wheel, device and safety on their own thread, and the hand-offs to other
// threads. All methods belong to the main thread unless noted.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "engine/haptics/watchdog.h"
#include "engine/jobs/fixed_rate_job.h"
#include "engine/jobs/io_thread.h"
#include "engine/jobs/spsc_ring.h"
#include "engine/jobs/triple_buffer.h"
#include "game/haptic/messages.h"
#include "game/haptic/tick.h"
#include "game/haptic/tool_device.h"

namespace onggi::haptic {

struct HapticJobOptions {
    jobs::WaitMode wait = jobs::WaitMode::kHybrid;
    // Does not spin while the tool's device has no motors: without force the exact start of a tick cannot be
    // felt, and spinning takes two fifths of a core at 4 kHz. Ticks in bursts of 4 ms while, besides, nobody
    // is there and no device other than the first is plugged in.
    bool spares_the_core = false;
    jobs::RealTimeRequest real_time{};
    jobs::RealTimePolicy policy = jobs::RealTimePolicy::kIgnore;
    std::uint64_t run_ticks = 0;  // ticks of a lump, e.g. of a gesture; 0: unbounded
    bool repeat = false;          // after run_ticks: restart on a fresh lump instead of ending
    std::uint64_t end_periods =
        0;  // number of periods of the clock until the job ends, skipped ones included; 0: unbounded
    std::size_t record_capacity = std::size_t{1} << 14U;  // tick records; 4 s at 4 kHz
};

// One period's work, without the thread: the job runs it on its thread, and tests run it on a virtual clock.
class HapticWork final : public jobs::PeriodicWork {
  public:
    // `start` is the first lump and that of every restart. The loop runs at the parameters' rate.
    HapticWork(HapticState start, const HapticParameters& parameters, ToolDevices devices,
               const HapticJobOptions& options);
    ~HapticWork() override;
    HapticWork(const HapticWork&) = delete;
    HapticWork& operator=(const HapticWork&) = delete;

    // Haptic thread.
    [[nodiscard]] bool tick(const jobs::Period& period) noexcept override;
    [[nodiscard]] bool needs_punctuality() const noexcept override {
        return !options_.spares_the_core || fits_[device_].is_felt;
    }
    [[nodiscard]] std::uint64_t ticks_at_once() const noexcept override { return rests_ ? ticks_a_rest_ : 1; }

    // The consumer's side of each hand-off, on one thread that is not the haptic one. Returns the newest
    // snapshot, which is unchanged until the next call; its pot is the newest finished copy and valid as
    // long.
    [[nodiscard]] const Snapshot& newest_snapshot() noexcept;
    // Returns false if the ring is full, after some hundred commands in one period.
    [[nodiscard]] bool send(Command command) noexcept { return commands_.try_push(command); }
    // Any thread, wait-free: switches the force off from the next tick on, until kRearmForce.
    void stop_force() noexcept { stop_asked_.store(true, std::memory_order_relaxed); }
    // Puts another state of the same lump on the wheel, as from History::state_at(): clay, wheel, tool and
    // ticks, but not the device's safety. It takes effect before the next tick, whose record has kStatePut.
    // The haptic thread swaps it in and returns the old one, so it neither copies nor frees. The state
    // belongs to `run`: it is dropped if another lump has come on the wheel meanwhile. Returns false if too
    // many states are queued. Precondition: the same clay as the start's, of the same size.
    [[nodiscard]] bool put(std::unique_ptr<HapticState> state, std::uint64_t run);
    [[nodiscard]] bool take_record(TickRecord& record) noexcept { return records_.try_pop(record); }

    // Only while the haptic thread does not run.
    [[nodiscard]] const HapticState& state() const noexcept { return state_; }
    [[nodiscard]] std::uint64_t runs() const noexcept { return run_ + 1; }
    // The number of ticks whose record was dropped because the ring was full. If it is not 0, the
    // recording is incomplete.
    [[nodiscard]] std::uint64_t dropped_records() const noexcept { return dropped_records_; }
    [[nodiscard]] haptics::HapticDevice& device() noexcept { return devices_.all(); }
    // Runs on its own thread while the job runs.
    [[nodiscard]] haptics::Watchdog& watchdog() noexcept { return watchdog_; }
    // Whether the first device can render this clay (fit_to_device).
    [[nodiscard]] const Result<void>& fits() const noexcept { return fits_.front().fits; }
    // One line for each device that gets no force, with the reason.
    [[nodiscard]] std::vector<std::string> refusals() const;

  private:
    // Ticks since the lump was put on the wheel; a start state may have ticks of its own.
    [[nodiscard]] std::uint64_t ticks_of_run() const noexcept { return state_.ticks - start_.ticks; }
    [[nodiscard]] bool run_is_over() const noexcept {
        return options_.run_ticks != 0 && ticks_of_run() >= options_.run_ticks;
    }
    void apply_commands() noexcept;
    // The tick's data from the loop, the device and the watchdog.
    [[nodiscard]] DeviceTick device_tick(const jobs::Period& period) noexcept;
    void put_on_fresh_lump() noexcept;
    void put_on_states() noexcept;
    void free_old_states() noexcept;
    void keep_record(const TickResult& result) noexcept;
    void publish(const TickResult& result) noexcept;

    const HapticState start_;
    // The limits of each device; a device that cannot render this clay gets no force.
    struct Fit {
        haptics::SafetyLimits safety;
        DeviceFeel feel;
        double step_mm = 0.0;     // resolution of its encoder
        bool has_motors = false;  // without motors, a person's presence is not needed
        bool is_felt = false;     // its motors exert a force
        Result<void> fits;
    };
    [[nodiscard]] static std::vector<Fit> fits_for(const haptics::HapticDevice& device,
                                                   const HapticParameters& parameters, bool is_paper);
    void hold_to(const Fit& fit) noexcept;

    const std::uint64_t ticks_a_rest_;
    HapticParameters parameters_;  // with the limits of the device that has the tool
    const HapticJobOptions options_;
    ToolDevices devices_;
    const std::vector<Fit> fits_;

    // Haptic thread only, while it runs.
    HapticState state_;
    std::uint64_t run_ = 0;
    bool lump_is_fresh_ = true;
    bool state_was_put_ = false;
    std::uint64_t states_put_ = 0;
    std::uint64_t skipped_periods_ = 0;
    std::uint64_t dropped_records_ = 0;
    std::uint32_t silences_ = 0;
    std::size_t device_ = 0;
    bool nobody_is_there_ = false;
    bool rests_ = false;  // ticks in bursts
    ForceTest force_test_;
    std::uint64_t periods_ = 0;
    double largest_force_n2_ = 0.0;

    std::atomic<bool> stop_asked_{false};
    haptics::Watchdog watchdog_;
    jobs::SpscRing<Command> commands_;
    struct OfRun {
        HapticState* state = nullptr;  // owned while it is in the ring
        std::uint64_t run = 0;
    };
    jobs::SpscRing<OfRun> states_;             // to be put on
    jobs::SpscRing<HapticState*> old_states_;  // to be freed
    jobs::SpscRing<TickRecord> records_;
    jobs::TripleBuffer<Snapshot> snapshots_;
    PotCopier pot_copier_;  // haptic thread
    jobs::TripleBuffer<PotCopy> pots_;
    Snapshot newest_;  // main thread
};

class HapticJob {
  public:
    HapticJob(HapticState start, const HapticParameters& parameters, ToolDevices devices,
              const HapticJobOptions& options);
    ~HapticJob() { stop(); }
    HapticJob(const HapticJob&) = delete;
    HapticJob& operator=(const HapticJob&) = delete;

    // Opens the device and starts the thread and its watchdog. Errors: kBadInput if the clay cannot be
    // rendered stably on this device at this rate (fit_to_device); the device's errors; see
    // FixedRateJob::start.
    Result<void> start();
    // Joins the threads, switches the force off and closes the device. Has no effect if it does not run.
    void stop() noexcept;
    // One line for each device other than the first that gets no force, with the reason.
    [[nodiscard]] std::vector<std::string> refusals() const { return work_.refusals(); }
    // Any thread, including those of a stop key or a signal; wait-free.
    void stop_force() noexcept { work_.stop_force(); }
    // Any thread: the loop ended by itself or was stopped.
    [[nodiscard]] bool finished() const noexcept { return job_.finished(); }

    // Call it once a frame. After two seconds without a call the picture counts as hung, and the force is
    // switched off.
    [[nodiscard]] const Snapshot& newest_snapshot() noexcept {
        work_.watchdog().picture_is_alive();
        return work_.newest_snapshot();
    }
    [[nodiscard]] bool send(Command command) noexcept { return work_.send(command); }
    [[nodiscard]] bool put(std::unique_ptr<HapticState> state, std::uint64_t run) {
        return work_.put(std::move(state), run);
    }
    // For the recording thread, which is this one or another, but always the same.
    [[nodiscard]] bool take_record(TickRecord& record) noexcept { return work_.take_record(record); }

    // After start().
    [[nodiscard]] const jobs::RealTimeReport& real_time() const noexcept { return job_.real_time(); }
    // After stop().
    [[nodiscard]] const jobs::TickStats& stats() const noexcept { return job_.stats(); }
    [[nodiscard]] const HapticState& state() const noexcept { return work_.state(); }
    [[nodiscard]] std::uint64_t runs() const noexcept { return work_.runs(); }
    [[nodiscard]] std::uint64_t dropped_records() const noexcept { return work_.dropped_records(); }

  private:
    HapticWork work_;
    jobs::FixedRateJob job_;
    jobs::IoThread watchdog_thread_;
    bool device_is_open_ = false;
};

}  // namespace onggi::haptic
