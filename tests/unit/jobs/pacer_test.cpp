#include "engine/jobs/pacer.h"

#include <gtest/gtest.h>

#include "engine/jobs/frame_pacer.h"
#include "tests/support/virtual_clock.h"

namespace onggi::jobs {
namespace {

using test::VirtualClock;

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kUs = 1'000;

// Runs one period with work of that duration.
Period do_one(Pacer<VirtualClock>& pacer, VirtualClock& clock, std::int64_t work_ns) {
    const Period period = pacer.wait_for_next();
    clock.pass(work_ns);
    pacer.finish(period);
    return period;
}

struct APacer : testing::Test {
    VirtualClock clock;
    Pacer<VirtualClock> pacer{clock, {.rate_hz = 1000.0, .wait = WaitMode::kSleep}};
};

struct ARestlessPacer : testing::Test {
    VirtualClock clock;
    Pacer<VirtualClock> pacer{clock, {.rate_hz = 1000.0, .wait = WaitMode::kSleep, .leave_rest = false}};
};

struct AFramePacer : testing::Test {
    VirtualClock clock;
    FramePacer<VirtualClock> pacer{clock, 60.0};
};

TEST_F(APacer, StartsEachTickAtItsDeadlineWhenNotLate) {
    const std::int64_t start_ns = clock.now_ns();
    for (int k = 0; k < 5000; ++k) {
        const Period period = do_one(pacer, clock, 10 * kUs);
        EXPECT_EQ(period.index, static_cast<std::uint64_t>(k));
        EXPECT_EQ(period.tick, static_cast<std::uint64_t>(k));
        EXPECT_EQ(period.start_ns, start_ns + (k + 1) * kMs);
        EXPECT_EQ(period.skipped, 0U);
        EXPECT_DOUBLE_EQ(period.dt_s, 0.001);
    }
    EXPECT_EQ(pacer.stats().missed_deadlines(), 0U);
    EXPECT_EQ(pacer.stats().wake_latency_ns.max(), 0U);
    EXPECT_EQ(pacer.stats().tick_ns.max(), static_cast<std::uint64_t>(10 * kUs));
    EXPECT_EQ(clock.sleeps, 5000);
}

TEST(Pacer, DoesNotDriftAtARateWhosePeriodIsNoWholeNumberOfNanoseconds) {
    VirtualClock clock;
    Pacer pacer(clock, {.rate_hz = 3000.0, .wait = WaitMode::kSleep});
    const std::int64_t first_ns = pacer.deadline_ns(0);
    EXPECT_EQ(pacer.deadline_ns(3000) - first_ns, 1000 * kMs);
    constexpr std::uint64_t kDay = 3000ULL * 86400ULL;
    EXPECT_NEAR(static_cast<double>(pacer.deadline_ns(kDay) - first_ns), 86400e9, 1.0);
}

TEST(Pacer, SpinsOnlyTheLastStretchBeforeADeadline) {
    for (const double rate_hz : {1000.0, 4000.0, 10000.0}) {
        VirtualClock clock;
        clock.oversleep_ns = 8 * kUs;
        Pacer pacer(clock, {.rate_hz = rate_hz, .wait = WaitMode::kHybrid});
        const std::int64_t start_ns = clock.now_ns();
        for (int k = 0; k < 1000; ++k) {
            do_one(pacer, clock, kUs);
        }
        // On time to one step of the spin although every sleep ends late ...
        EXPECT_LT(pacer.stats().wake_latency_ns.max(), static_cast<std::uint64_t>(VirtualClock::kSpinStepNs));
        EXPECT_GT(clock.spins, 0);
        // ... and asleep for more than half of the time all the same.
        EXPECT_GT(clock.slept_ns * 2, clock.now_ns() - start_ns) << rate_hz;
    }
}

TEST(Pacer, GuardsBetweenFortyAndAHundredAndFiftyMicroseconds) {
    EXPECT_EQ(default_guard_ns(100.0), 150 * kUs);
    EXPECT_EQ(default_guard_ns(1000.0), 150 * kUs);
    EXPECT_EQ(default_guard_ns(4000.0), 100 * kUs);
    EXPECT_EQ(default_guard_ns(10000.0), 40 * kUs);
}

TEST_F(APacer, RunsALateTickAtOnceAndCountsItAsNotMissedWhenItStillEndsInTime) {
    do_one(pacer, clock, 10 * kUs);
    clock.oversleep_once(700 * kUs);
    const Period late = do_one(pacer, clock, 10 * kUs);
    EXPECT_EQ(late.index, 1U);
    EXPECT_EQ(late.start_ns, late.deadline_ns + 700 * kUs);
    EXPECT_EQ(pacer.stats().missed_deadlines(), 0U);
    EXPECT_EQ(pacer.stats().wake_latency_ns.max(), static_cast<std::uint64_t>(700 * kUs));
    // The next one is on time again: lateness does not accumulate.
    EXPECT_EQ(do_one(pacer, clock, 10 * kUs).start_ns, late.deadline_ns + kMs);
}

TEST_F(APacer, SkipsAndCountsThePeriodsThatWentByAndNeverReplaysThem) {
    do_one(pacer, clock, 10 * kUs);
    clock.oversleep_once(5 * kMs + 300 * kUs);
    const Period after = do_one(pacer, clock, 10 * kUs);
    EXPECT_EQ(after.index, 6U);  // deadlines 1 to 5 passed while it slept
    EXPECT_EQ(after.tick, 1U);   // the work ran once for all of them
    EXPECT_EQ(after.skipped, 5U);
    EXPECT_EQ(after.start_ns - after.deadline_ns, 300 * kUs);
    EXPECT_EQ(pacer.stats().skipped_periods, 5U);
    EXPECT_EQ(pacer.stats().missed_deadlines(), 5U);
    // The latency is relative to the awaited deadline, not to the nearest.
    EXPECT_EQ(pacer.stats().wake_latency_ns.max(), static_cast<std::uint64_t>(5 * kMs + 300 * kUs));
    const Period next = do_one(pacer, clock, 10 * kUs);
    EXPECT_EQ(next.index, 7U);
    EXPECT_EQ(next.start_ns, next.deadline_ns);
}

TEST_F(APacer, GathersPeriodsAndRunsThemOneAfterTheOther) {
    const std::int64_t start_ns = clock.now_ns();
    pacer.gather(4);
    for (int k = 0; k < 400; ++k) {
        const Period period = do_one(pacer, clock, 10 * kUs);
        EXPECT_EQ(period.index, static_cast<std::uint64_t>(k));
        EXPECT_EQ(period.tick, static_cast<std::uint64_t>(k));
        EXPECT_EQ(period.start_ns, start_ns + (k / 4 * 4 + 4) * kMs + k % 4 * 10 * kUs);
        EXPECT_EQ(period.skipped, 0U);
        EXPECT_DOUBLE_EQ(period.dt_s, 0.001);
    }
    EXPECT_EQ(clock.sleeps, 100);
    EXPECT_EQ(pacer.stats().missed_deadlines(), 0U);
    pacer.gather(1);
    EXPECT_EQ(do_one(pacer, clock, 10 * kUs).start_ns, start_ns + 401 * kMs) << "at once at its full rate";
}

TEST_F(ARestlessPacer, SkipsWhatAGatheringLoopMissed) {
    pacer.gather(4);
    for (int k = 0; k < 3; ++k)
        static_cast<void>(do_one(pacer, clock, 10 * kUs));
    static_cast<void>(do_one(pacer, clock, 6500 * kUs));  // 2 periods beyond the next 4
    const Period late = pacer.wait_for_next();
    EXPECT_EQ(late.index, 6U);
    EXPECT_EQ(late.skipped, 2U);
    EXPECT_DOUBLE_EQ(late.dt_s, 0.002);
    pacer.finish(late);
    EXPECT_EQ(do_one(pacer, clock, 0).index, 7U);
    EXPECT_EQ(pacer.stats().skipped_periods, 2U);
}

TEST_F(APacer, ClampsTimeToTwoTicksHoweverManyWereSkipped) {
    do_one(pacer, clock, 10 * kUs);
    clock.oversleep_once(1 * kMs);
    EXPECT_DOUBLE_EQ(do_one(pacer, clock, 10 * kUs).dt_s, 0.002);
    clock.oversleep_once(400 * kMs);
    EXPECT_DOUBLE_EQ(do_one(pacer, clock, 10 * kUs).dt_s, 0.002);
    EXPECT_DOUBLE_EQ(do_one(pacer, clock, 10 * kUs).dt_s, 0.001);
}

TEST_F(ARestlessPacer, CountsATickThatEndsAfterTheNextDeadlineAsMissed) {
    do_one(pacer, clock, kMs);  // ends exactly one period after its deadline: in time
    EXPECT_EQ(pacer.stats().missed_deadlines(), 0U);
    do_one(pacer, clock, kMs + 1);
    EXPECT_EQ(pacer.stats().overrun_periods, 1U);
    EXPECT_EQ(pacer.stats().missed_deadlines(), 1U);
    // Starts late, but within its own period, and ends in it.
    const Period next = do_one(pacer, clock, 10 * kUs);
    EXPECT_EQ(next.start_ns, next.deadline_ns + 1);
    EXPECT_EQ(pacer.stats().missed_deadlines(), 1U);
}

TEST_F(ARestlessPacer, CountsEveryPeriodOfAStallOnceWhereverItFalls) {
    // Work of 2.5 periods: its own period overruns, the next is skipped.
    do_one(pacer, clock, 2 * kMs + 500 * kUs);
    const Period next = do_one(pacer, clock, 10 * kUs);
    EXPECT_EQ(next.index, 2U);
    EXPECT_EQ(pacer.stats().overrun_periods, 1U);
    EXPECT_EQ(pacer.stats().skipped_periods, 1U);
    EXPECT_EQ(pacer.stats().ticks + pacer.stats().skipped_periods, next.index + 1);
}

TEST(Pacer, LeavesATenthOfTheCoreEvenWhenEveryTickTakesTooLong) {
    for (const WaitMode wait : {WaitMode::kSleep, WaitMode::kHybrid}) {
        for (const std::int64_t work_us : {95, 100, 150, 990, 5000}) {
            VirtualClock clock;
            Pacer pacer(clock, {.rate_hz = 10000.0, .wait = wait});
            const std::int64_t start_ns = clock.now_ns();
            while (clock.now_ns() - start_ns < 1000 * kMs)
                do_one(pacer, clock, work_us * kUs);
            const double asleep =
                static_cast<double>(clock.slept_ns) / static_cast<double>(clock.now_ns() - start_ns);
            EXPECT_GE(asleep, 0.098) << work_us << " us";
            EXPECT_LE(asleep, 0.15) << work_us << " us: rests, but does not doze";
        }
    }
}

TEST_F(ARestlessPacer, TakesNoRestIfNotRequested) {
    for (int k = 0; k < 100; ++k)
        do_one(pacer, clock, 2 * kMs);
    EXPECT_EQ(clock.sleeps, 1);  // before the first deadline only
}

TEST_F(AFramePacer, KeepsSixtyFramesASecondAndSaysHowLongTheyTook) {
    const std::int64_t start_ns = clock.now_ns();
    for (int frame = 0; frame < 600; ++frame) {
        pacer.wait();
        clock.pass(9 * kMs);
        pacer.finish();
    }
    EXPECT_EQ(pacer.frames(), 600U);
    EXPECT_NEAR(static_cast<double>(clock.now_ns() - start_ns), 10e9, 17e6);
    EXPECT_EQ(pacer.work_ns().max(), static_cast<std::uint64_t>(9 * kMs));
    EXPECT_NEAR(static_cast<double>(pacer.interval_ns().max()), 1e9 / 60.0, 10.0);
    EXPECT_EQ(pacer.interval_ns().count(), 599U);
}

TEST_F(AFramePacer, DrawsOneFrameAfterTheOtherWhenTheyTakeTooLong) {
    for (int frame = 0; frame < 10; ++frame) {
        pacer.wait();
        clock.pass(30 * kMs);
        pacer.finish();
    }
    EXPECT_EQ(pacer.interval_ns().max(), static_cast<std::uint64_t>(30 * kMs));
    EXPECT_EQ(clock.sleeps, 1);
}

TEST(FramePacer, GoesByTheBeatOfADisplayThatIsSlowerOrFaster) {
    for (const std::int64_t beat_ns : {20 * kMs, 14 * kMs}) {
        VirtualClock clock;
        FramePacer pacer(clock, 60.0);
        const std::int64_t start_ns = clock.now_ns();
        for (int frame = 1; frame <= 100; ++frame) {
            clock.sleep_until_ns(start_ns + frame * beat_ns);  // the driver's own wait
            pacer.wait(true);
            EXPECT_EQ(clock.now_ns(), start_ns + frame * beat_ns);
            clock.pass(5 * kMs);
            pacer.finish();
        }
        // Without further refreshes it continues from the last one.
        pacer.wait();
        EXPECT_NEAR(static_cast<double>(clock.now_ns() - start_ns),
                    static_cast<double>(100 * beat_ns) + 1e9 / 60.0, 10.0);
    }
}

TEST_F(AFramePacer, DoesNotBelieveADriverThatHasShownEverythingAtOnce) {
    for (int frame = 0; frame < 100; ++frame) {
        pacer.wait(true);
        clock.pass(kMs);
        pacer.finish();
    }
    EXPECT_NEAR(static_cast<double>(pacer.interval_ns().max()), 0.75e9 / 60.0, 10.0);
}

TEST(DisplayBeat, RetriesAfterLongerAndLongerPauses) {
    DisplayBeat beat;
    std::int64_t now_ns = 0;
    ASSERT_TRUE(beat.is_asked(now_ns));
    for (const int pause_s : {1, 2, 4, 8, 16, 32, 64, 128, 256, 256}) {
        beat.was_not_told(now_ns);
        EXPECT_FALSE(beat.is_asked(now_ns + pause_s * kNsPerSecond - 1)) << pause_s;
        now_ns += pause_s * kNsPerSecond;
        EXPECT_TRUE(beat.is_asked(now_ns)) << pause_s;
    }
    beat.was_told();
    beat.was_not_told(now_ns);
    EXPECT_TRUE(beat.is_asked(now_ns + kNsPerSecond)) << "from the beginning";
}

}  // namespace
}  // namespace onggi::jobs
