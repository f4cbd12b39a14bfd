#include "engine/jobs/fixed_rate_job.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/comes_true.h"
#include "tests/support/virtual_clock.h"

namespace onggi::jobs {
namespace {

using test::VirtualClock;

// Takes a scripted time for each tick, and ends after the last.
class ScriptedWork final : public PeriodicWork {
  public:
    ScriptedWork(VirtualClock& clock, std::vector<std::int64_t> durations_ns)
        : clock_(clock),
          durations_ns_(std::move(durations_ns)) {}

    bool tick(const Period& period) noexcept override {
        indices.push_back(period.index);
        clock_.pass(durations_ns_[indices.size() - 1]);
        return indices.size() < durations_ns_.size();
    }

    std::vector<std::uint64_t> indices;

  private:
    VirtualClock& clock_;
    std::vector<std::int64_t> durations_ns_;
};

TEST(FixedRateLoop, RunsTheWorkOnceAPeriodUntilTheWorkIsDone) {
    VirtualClock clock;
    ScriptedWork work(clock, {1000, 3'200'000, 1000, 1000});
    Pacer pacer(clock, {.rate_hz = 1000.0, .wait = WaitMode::kSleep, .leave_rest = false});
    const std::atomic<bool> stop{false};
    run_fixed_rate(pacer, work, stop);
    // The second tick takes from period 1 into period 4: 2 and 3 are skipped.
    EXPECT_EQ(work.indices, (std::vector<std::uint64_t>{0, 1, 4, 5}));
    EXPECT_EQ(pacer.stats().ticks, 4U);
    EXPECT_EQ(pacer.stats().missed_deadlines(), 3U);
}

// Needs punctuality until a number of ticks have run.
class CalmingWork final : public PeriodicWork {
  public:
    CalmingWork(VirtualClock& clock, int punctual_ticks, int all_ticks)
        : clock_(clock),
          punctual_ticks_(punctual_ticks),
          all_ticks_(all_ticks) {}

    bool tick(const Period& /*period*/) noexcept override {
        clock_.pass(1000);
        return ++ticks_ < all_ticks_;
    }
    [[nodiscard]] bool needs_punctuality() const noexcept override { return ticks_ < punctual_ticks_; }

  private:
    VirtualClock& clock_;
    int punctual_ticks_;
    int all_ticks_;
    int ticks_ = 0;
};

TEST(FixedRateLoop, SpinsOnlyWhileTheWorkNeedsPunctuality) {
    const auto spins = [](WaitMode wait, int punctual_ticks) {
        VirtualClock clock;
        CalmingWork work(clock, punctual_ticks, 100);
        Pacer pacer(clock, {.rate_hz = 4000.0, .wait = wait});
        const std::atomic<bool> stop{false};
        run_fixed_rate(pacer, work, stop);
        EXPECT_EQ(pacer.stats().ticks, 100U);
        EXPECT_EQ(pacer.stats().missed_deadlines(), 0U);
        return clock.spins;
    };
    const int always = spins(WaitMode::kHybrid, 100);
    EXPECT_GT(always, 100 * 1000) << "the guard of 100 us in steps of 50 ns";
    EXPECT_NEAR(spins(WaitMode::kHybrid, 20), always / 5, 20);
    EXPECT_EQ(spins(WaitMode::kSleep, 100), 0) << "who may not spin does not, whatever is needed";
}

TEST(FixedRateLoop, DoesNotBeginWhenItIsStoppedBefore) {
    VirtualClock clock;
    ScriptedWork work(clock, {1000});
    Pacer pacer(clock, {.rate_hz = 1000.0});
    const std::atomic<bool> stop{true};
    run_fixed_rate(pacer, work, stop);
    EXPECT_TRUE(work.indices.empty());
}

class CountingWork final : public PeriodicWork {
  public:
    explicit CountingWork(int end = -1) : end_(end) {}
    bool tick(const Period& /*period*/) noexcept override {
        ++ticks;
        return ticks.load() != end_;
    }
    std::atomic<int> ticks{0};

  private:
    int end_;
};

// Requests nothing that a test machine may refuse.
FixedRateJobOptions modest_options() {
    FixedRateJobOptions options;
    options.pacing = {.rate_hz = 1000.0, .wait = WaitMode::kSleep};
    // 0 is no priority, and refused: a test shares the machine with others.
    options.real_time = {.core = {}, .fifo_priority = 0, .lock_memory = false, .wakeful_cores = false};
    return options;
}

TEST(FixedRateJob, EndsByItselfWhenTheWorkIsDone) {
    CountingWork work(20);
    FixedRateJob job(modest_options());
    EXPECT_TRUE(job.finished());
    ASSERT_TRUE(job.start(work));
    EXPECT_TRUE(test::comes_true([&] { return job.finished(); }));
    job.stop();
    EXPECT_EQ(work.ticks.load(), 20);
    EXPECT_EQ(job.stats().ticks, 20U);
    EXPECT_EQ(job.stats().tick_ns.count(), 20U);
}

TEST(FixedRateJob, EndsWhenStoppedAndCanBeStartedAgain) {
    CountingWork work;
    FixedRateJob job(modest_options());
    for (int round = 0; round < 3; ++round) {
        ASSERT_TRUE(job.start(work));
        EXPECT_FALSE(job.finished());
        job.stop();
        EXPECT_TRUE(job.finished());
        job.stop();  // does nothing
    }
}

TEST(FixedRateJob, RunsWithARefusalAndRecordsItUnderIgnore) {
    CountingWork work(1);
    FixedRateJob job(modest_options());
    ASSERT_TRUE(job.start(work));
    EXPECT_EQ(job.real_time().fifo.grant, Grant::kRefused);
    EXPECT_STREQ(job.real_time().scheduler(), "other");
    EXPECT_TRUE(test::comes_true([&] { return job.finished(); }));
    EXPECT_EQ(work.ticks.load(), 1);
}

TEST(FixedRateJob, RefusesToRunEvenOneTickUnderEnforce) {
    CountingWork work;
    FixedRateJobOptions options = modest_options();
    options.policy = RealTimePolicy::kEnforce;
    FixedRateJob job(options);
    const Result<void> started = job.start(work);
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().kind, ErrorKind::kSystemLacks);
    EXPECT_NE(started.error().message.find("SCHED_FIFO"), std::string::npos) << started.error().message;
    EXPECT_TRUE(job.finished());
    EXPECT_EQ(work.ticks.load(), 0);
}

}  // namespace
}  // namespace onggi::jobs
