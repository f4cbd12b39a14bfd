// The haptic loop at work: clay, wheel, device and safety on a thread of their own, and the hand-offs to the
// others. Every method belongs to the main thread unless it says otherwise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "engine/core/result.h"
#include "engine/haptics/haptic_device.h"
#include "engine/jobs/fixed_rate_job.h"
#include "engine/jobs/spsc_ring.h"
#include "engine/jobs/triple_buffer.h"
#include "game/haptic/messages.h"
#include "game/haptic/tick.h"

namespace onggi::haptic {

struct HapticJobOptions {
    jobs::WaitMode wait = jobs::WaitMode::kHybrid;
    jobs::RealTimeRequest real_time{};
    jobs::RealTimePolicy policy = jobs::RealTimePolicy::kIgnore;
    std::uint64_t run_ticks = 0;  // how long a lump lasts, e.g. a gesture's ticks; 0: until told otherwise
    bool repeat = false;          // after run_ticks: again on a fresh lump, or the end
    std::uint64_t end_periods =
        0;  // the end after so many periods of the clock, skipped ones counted; 0: none
    std::size_t record_capacity = std::size_t{1} << 14U;  // tick records; 4 s at 4 kHz
};

// What one period does, without the thread: the job runs it, and tests run it on a virtual clock.
class HapticWork final : public jobs::PeriodicWork {
  public:
    // `start` is the lump, also of every restart. The parameters' rate is the loop's.
    HapticWork(HapticState start, const HapticParameters& parameters,
               std::unique_ptr<haptics::HapticDevice> device, const HapticJobOptions& options);

    // Haptic thread.
    [[nodiscard]] bool tick(const jobs::Period& period) noexcept override;

    // The other side of each hand-off: the one thread that is not the haptic one.
    // The newest snapshot; it stays as it is until the next call.
    [[nodiscard]] const Snapshot& newest_snapshot() noexcept;
    // False when the ring is full, which some hundred commands in one period take.
    [[nodiscard]] bool send(Command command) noexcept { return commands_.try_push(command); }
    [[nodiscard]] bool take_record(TickRecord& record) noexcept { return records_.try_pop(record); }
    [[nodiscard]] bool take_hash(BlockHash& hash) noexcept { return hashes_.try_pop(hash); }

    // While the haptic thread does not run.
    [[nodiscard]] const HapticState& state() const noexcept { return state_; }
    [[nodiscard]] std::uint64_t runs() const noexcept { return run_ + 1; }
    // Ticks whose record or hash found its ring full. A recording with any is not whole.
    [[nodiscard]] std::uint64_t dropped_records() const noexcept { return dropped_records_; }
    [[nodiscard]] haptics::HapticDevice& device() noexcept { return *device_; }

  private:
    // Since the lump was put on; a start state may have been ticked before.
    [[nodiscard]] std::uint64_t ticks_of_run() const noexcept { return state_.ticks - start_.ticks; }
    [[nodiscard]] bool run_is_over() const noexcept {
        return options_.run_ticks != 0 && ticks_of_run() >= options_.run_ticks;
    }
    void obey_commands() noexcept;
    void put_on_fresh_lump() noexcept;
    void keep_record(const TickResult& result) noexcept;
    void publish(const TickResult& result) noexcept;

    const HapticState start_;
    const HapticParameters parameters_;
    const HapticJobOptions options_;
    std::unique_ptr<haptics::HapticDevice> device_;

    // Haptic thread only, while it runs.
    HapticState state_;
    std::uint64_t run_ = 0;
    bool lump_is_fresh_ = true;
    std::uint64_t skipped_periods_ = 0;
    std::uint64_t dropped_records_ = 0;

    jobs::SpscRing<Command> commands_;
    jobs::SpscRing<TickRecord> records_;
    jobs::SpscRing<BlockHash> hashes_;
    jobs::TripleBuffer<Snapshot> snapshots_;
};

class HapticJob {
  public:
    HapticJob(HapticState start, const HapticParameters& parameters,
              std::unique_ptr<haptics::HapticDevice> device, const HapticJobOptions& options);
    ~HapticJob() { stop(); }
    HapticJob(const HapticJob&) = delete;
    HapticJob& operator=(const HapticJob&) = delete;

    // Opens the device and starts the thread. Errors: the device's, or see FixedRateJob::start.
    Result<void> start();
    // Joins the thread and closes the device. Harmless when it does not run.
    void stop() noexcept;
    // Any thread: the loop has come to its end by itself, or was stopped.
    [[nodiscard]] bool finished() const noexcept { return job_.finished(); }

    // Once a frame.
    [[nodiscard]] const Snapshot& newest_snapshot() noexcept { return work_.newest_snapshot(); }
    [[nodiscard]] bool send(Command command) noexcept { return work_.send(command); }
    // The thread that records: this one or another, but always the same.
    [[nodiscard]] bool take_record(TickRecord& record) noexcept { return work_.take_record(record); }
    [[nodiscard]] bool take_hash(BlockHash& hash) noexcept { return work_.take_hash(hash); }

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
    bool device_is_open_ = false;
};

}  // namespace onggi::haptic
