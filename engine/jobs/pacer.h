// Waits for the periods of a fixed rate and keeps statistics: late wake-ups, skipped periods, work times. The
// clock is a parameter, so that tests can use a virtual one. One thread; times in ns.
//
// Deadline k is origin + k / rate, not a running sum, so the rate does not drift. A late loop runs once, in
// the current period: missed periods are skipped and counted, never caught up.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/jobs/clock.h"
#include "engine/jobs/histogram.h"

namespace onggi::jobs {

// The statistics of a fixed-rate loop. Written by its own thread, read by others after it has ended.
struct TickStats {
    Histogram tick_ns;                  // the duration of the work
    Histogram wake_latency_ns;          // start of the work minus the awaited deadline
    std::uint64_t ticks = 0;            // number of runs
    std::uint64_t skipped_periods = 0;  // periods that had passed before their work could begin
    std::uint64_t overrun_periods = 0;  // periods whose work ended after the next deadline

    // Periods whose tick had not finished one period after its deadline, including skipped periods.
    [[nodiscard]] std::uint64_t missed_deadlines() const noexcept {
        return skipped_periods + overrun_periods;
    }
};

enum class WaitMode {
    kHybrid,  // sleep until shortly before the deadline, then spin: punctual to 0.1 us, costs core time
    kSleep,   // sleep only: cheap, late by the kernel's wake-up time (5 to 50 us)
};

// How long before a deadline the hybrid wait stops sleeping and spins: longer than a usual wake-up (p99 about
// 40 us), but short enough that spinning takes less than half of the core.
[[nodiscard]] inline std::int64_t default_guard_ns(double rate_hz) {
    constexpr double kLongestNs = 150'000.0;
    constexpr double kFractionOfPeriod = 0.4;
    return static_cast<std::int64_t>(std::min(kLongestNs, kFractionOfPeriod * 1e9 / rate_hz));
}

struct PacerOptions {
    double rate_hz = 1000.0;  // above 0
    WaitMode wait = WaitMode::kHybrid;
    // Never take more than 90 % of the core, even when overloaded. The kernel stops a real-time thread that
    // does not sleep for 50 ms in every second; other threads do not need this.
    bool leave_rest = true;
};

// One period, passed to the work.
struct Period {
    std::uint64_t index = 0;       // number of the deadline, counting skipped ones
    std::uint64_t tick = 0;        // number of earlier runs
    std::uint64_t skipped = 0;     // periods missed since the last tick
    std::int64_t deadline_ns = 0;  // of `index`
    std::int64_t start_ns = 0;     // when the work began
    double dt_s = 0.0;             // time to advance: one period, at most two however many were skipped
};

template <PacerClock Clock>
class Pacer {
  public:
    // The first deadline is one period from now.
    Pacer(Clock& clock, const PacerOptions& options)
        : clock_(clock),
          leave_rest_(options.leave_rest),
          period_ns_(1e9 / options.rate_hz),
          hybrid_guard_ns_(options.wait == WaitMode::kHybrid ? default_guard_ns(options.rate_hz) : 0),
          guard_ns_(hybrid_guard_ns_),
          origin_ns_(clock.now_ns() + static_cast<std::int64_t>(period_ns_)),
          awake_since_ns_(clock.now_ns()) {}

    // Waits for the next deadline (not at all if it has passed) and returns the period that has begun. While
    // periods are gathered, it waits for the last of them, and the next calls return the others at once.
    Period wait_for_next() noexcept {
        const std::uint64_t index = awaited();
        if (index < gathered_end_) return gathered(index);
        const std::uint64_t last = index + gathers_ - 1;
        const std::int64_t awaited_ns = deadline_ns(last);
        const std::int64_t start_ns = wait_until(awaited_ns);

        Period period;
        period.index = index + (std::max(last, index_at(start_ns)) - last);
        gathered_end_ = period.index + gathers_;
        period.tick = stats_.ticks;
        period.skipped = period.index - index;
        period.deadline_ns = deadline_ns(period.index);
        period.start_ns = start_ns;
        constexpr double kMostPeriods = 2.0;
        period.dt_s = std::min(kMostPeriods, 1.0 + static_cast<double>(period.skipped)) * period_ns_ * 1e-9;

        last_index_ = period.index;
        stats_.skipped_periods += period.skipped;
        // Relative to the awaited deadline: a skip must not hide a late wake-up.
        stats_.wake_latency_ns.record(start_ns - awaited_ns);
        ++stats_.ticks;
        return period;
    }

    // Call when the period's work is done.
    void finish(const Period& period) noexcept {
        const std::int64_t end_ns = clock_.now_ns();
        stats_.tick_ns.record(end_ns - period.start_ns);
        if (end_ns > deadline_ns(std::max(period.index + 1, gathered_end_))) ++stats_.overrun_periods;
    }

    // Sets how many periods each wait gathers (default: one, at least one). A loop that may be late by some
    // periods so wakes less often.
    void gather(std::uint64_t periods) noexcept { gathers_ = periods; }

    // Sets whether hybrid waits spin before the deadline (default: yes).
    void be_punctual(bool punctual) noexcept { guard_ns_ = punctual ? hybrid_guard_ns_ : 0; }

    // Moves every deadline so that the next is at this time, to follow another clock.
    void align_next(std::int64_t time_ns) noexcept { origin_ns_ += time_ns - deadline_ns(awaited()); }

    [[nodiscard]] double period_ns() const noexcept { return period_ns_; }
    [[nodiscard]] const TickStats& stats() const noexcept { return stats_; }
    [[nodiscard]] std::int64_t deadline_ns(std::uint64_t index) const noexcept {
        return origin_ns_ + static_cast<std::int64_t>(static_cast<double>(index) * period_ns_);
    }

  private:
    [[nodiscard]] std::uint64_t awaited() const noexcept { return stats_.ticks == 0 ? 0 : last_index_ + 1; }

    // A period that had begun when the wait ended.
    Period gathered(std::uint64_t index) noexcept {
        Period period;
        period.index = last_index_ = index;
        period.tick = stats_.ticks++;
        period.deadline_ns = deadline_ns(index);
        period.start_ns = clock_.now_ns();
        period.dt_s = period_ns_ * 1e-9;
        return period;
    }

    // The last period whose deadline is not after time_ns.
    [[nodiscard]] std::uint64_t index_at(std::int64_t time_ns) const noexcept {
        if (time_ns <= origin_ns_) return 0;
        auto index = static_cast<std::uint64_t>(static_cast<double>(time_ns - origin_ns_) / period_ns_);
        // The division may be off by one in its last bit; the deadlines themselves decide.
        while (deadline_ns(index + 1) <= time_ns)
            ++index;
        while (index > 0 && deadline_ns(index) > time_ns)
            --index;
        return index;
    }

    std::int64_t wait_until(std::int64_t deadline_ns) noexcept {
        const std::int64_t now_ns = clock_.now_ns();
        // After each awake interval, the thread owes a ninth of its length in sleep: 90 % awake, 10 % asleep.
        // Normal sleeps far exceed that.
        if (leave_rest_) rest_owed_ns_ += (now_ns - awake_since_ns_) / kAwakePerRest;
        std::int64_t wake_ns = deadline_ns - guard_ns_;
        if (rest_owed_ns_ >= kLeastRestNs) wake_ns = std::max(wake_ns, now_ns + rest_owed_ns_);
        awake_since_ns_ = now_ns;
        if (wake_ns > now_ns) {
            clock_.sleep_until_ns(wake_ns);
            awake_since_ns_ = clock_.now_ns();
            rest_owed_ns_ = std::max<std::int64_t>(0, rest_owed_ns_ - (awake_since_ns_ - now_ns));
        }
        std::int64_t start_ns = awake_since_ns_;
        while (start_ns < deadline_ns) {
            clock_.relax();
            start_ns = clock_.now_ns();
        }
        return start_ns;
    }

    static constexpr std::int64_t kAwakePerRest = 9;
    static constexpr std::int64_t kLeastRestNs = 100'000;  // shorter sleeps are not worth their cost

    Clock& clock_;
    bool leave_rest_;
    double period_ns_;
    std::int64_t hybrid_guard_ns_;
    std::int64_t guard_ns_;
    std::int64_t origin_ns_;
    std::int64_t awake_since_ns_;
    std::int64_t rest_owed_ns_ = 0;
    std::uint64_t last_index_ = 0;
    std::uint64_t gathers_ = 1;
    std::uint64_t gathered_end_ = 0;  // one past the last period that the last wait has gathered
    TickStats stats_;
};

}  // namespace onggi::jobs
