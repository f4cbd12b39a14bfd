// A thread that runs work at a fixed rate: the loop, its thread and its real-time set-up.
#pragma once

#include <atomic>
#include <latch>
#include <string>
#include <thread>
#include <utility>

#include "engine/core/result.h"
#include "engine/jobs/pacer.h"
#include "engine/jobs/thread_setup.h"

namespace onggi::jobs {

// The work of a job, called once a period.
class PeriodicWork {
  public:
    virtual ~PeriodicWork() = default;

    // The job's thread. No lock, allocation or system call. False ends the job.
    [[nodiscard]] virtual bool tick(const Period& period) noexcept = 0;
    // Likewise, after each tick: whether the next tick needs a spin wait, which costs part of a core.
    [[nodiscard]] virtual bool needs_punctuality() const noexcept { return true; }
    // Likewise: how many ticks may wait for each other and then run one after the other. At least one.
    [[nodiscard]] virtual std::uint64_t ticks_at_once() const noexcept { return 1; }
};

// The loop itself, on any clock. Ends when tick() returns false or `stop` is set; at most one period later.
template <PacerClock Clock>
void run_fixed_rate(Pacer<Clock>& pacer, PeriodicWork& work, const std::atomic<bool>& stop) noexcept {
    bool more = true;
    while (more && !stop.load(std::memory_order_relaxed)) {
        const Period period = pacer.wait_for_next();
        more = work.tick(period);
        pacer.be_punctual(work.needs_punctuality());
        pacer.gather(work.ticks_at_once());
        pacer.finish(period);
    }
}

enum class RealTimePolicy {
    kEnforce,  // a refusal is an error, and the job does not start (kiosk)
    kIgnore,   // a refusal is recorded, and the job runs as well as it can (tests, development)
};

struct FixedRateJobOptions {
    std::string thread_name = "onggi-haptic";  // at most 15 letters
    PacerOptions pacing{};
    RealTimeRequest real_time{};
    RealTimePolicy policy = RealTimePolicy::kIgnore;
};

// Every method belongs to the one thread that owns the job, unless it says otherwise.
class FixedRateJob {
  public:
    explicit FixedRateJob(FixedRateJobOptions options) : options_(std::move(options)) {}
    ~FixedRateJob() { stop(); }

    FixedRateJob(const FixedRateJob&) = delete;
    FixedRateJob& operator=(const FixedRateJob&) = delete;

    // Starts the thread and waits until it has set itself up. `work` must outlive the job's run. Errors:
    // kSystemLacks under kEnforce if anything was refused, naming the first lack and its remedy; kFailed if
    // the thread cannot start. Precondition: not running.
    Result<void> start(PeriodicWork& work);
    // Ends the loop within about a period and joins the thread. Does nothing if it is not running.
    void stop() noexcept;

    // Any thread: the loop has ended, by itself or by stop().
    [[nodiscard]] bool finished() const noexcept { return finished_.load(std::memory_order_acquire); }

    // After start().
    [[nodiscard]] const RealTimeReport& real_time() const noexcept { return report_; }
    // After stop(): the whole run.
    [[nodiscard]] const TickStats& stats() const noexcept { return stats_; }

  private:
    void run(PeriodicWork& work, std::latch& set_up) noexcept;

    FixedRateJobOptions options_;
    RealTimeReport report_;
    WakefulCores wakeful_cores_;  // while the job runs
    TickStats stats_;
    std::atomic<bool> go_{false};  // the owner has seen the report
    std::atomic<bool> stop_{false};
    std::atomic<bool> finished_{true};
    std::jthread thread_;
};

}  // namespace onggi::jobs
