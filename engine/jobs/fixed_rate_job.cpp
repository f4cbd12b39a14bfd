#include "engine/jobs/fixed_rate_job.h"

#include <cassert>
#include <system_error>

namespace onggi::jobs {

Result<void> FixedRateJob::start(PeriodicWork& work) {
    assert(!thread_.joinable());
    stop_.store(false, std::memory_order_relaxed);
    go_.store(false, std::memory_order_relaxed);
    finished_.store(false, std::memory_order_relaxed);
    std::latch set_up(1);
    try {
        thread_ = std::jthread([this, &work, &set_up] { run(work, set_up); });
    } catch (const std::system_error& error) {
        finished_.store(true, std::memory_order_relaxed);
        return failed("cannot start the thread " + options_.thread_name + ": " + error.what());
    }
    set_up.wait();
    if (options_.real_time.wakeful_cores) report_.wakeful_cores = wakeful_cores_.request();

    if (options_.policy == RealTimePolicy::kEnforce && !report_.nothing_refused()) {
        stop();
        const RealTimeLack lack = report_.lacks().front();
        return system_lacks(lack.what + " (" + lack.cost + "); " + lack.remedy);
    }
    go_.store(true, std::memory_order_release);
    go_.notify_one();
    return {};
}

void FixedRateJob::stop() noexcept {
    stop_.store(true, std::memory_order_relaxed);
    go_.store(true, std::memory_order_release);
    go_.notify_one();
    if (thread_.joinable()) thread_.join();
    wakeful_cores_.release();
}

void FixedRateJob::run(PeriodicWork& work, std::latch& set_up) noexcept {
    name_this_thread(options_.thread_name.c_str());
    report_ = set_up_this_thread(options_.real_time);
    set_up.count_down();
    // No tick before the owner has checked the report: under kEnforce a refusal means that the job does not
    // run.
    go_.wait(false, std::memory_order_acquire);

    MonotonicClock clock;
    Pacer<MonotonicClock> pacer(clock, options_.pacing);
    run_fixed_rate(pacer, work, stop_);
    stats_ = pacer.stats();
    finished_.store(true, std::memory_order_release);
}

}  // namespace onggi::jobs
