// The whole haptic job on a real thread, with a main thread that does everything at once: reads snapshots,
// fetches records, sends commands and moves the hand. For ThreadSanitizer; nothing here depends on its speed.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "engine/jobs/clock.h"
#include "game/haptic/job.h"
#include "game/haptic/simulated_device.h"
#include "tests/support/patience.h"

namespace onggi::haptic {
namespace {

TEST(HapticJobUnderStress, HandsOverSnapshotsAndRecordsWhileTheHandMovesAndCommandsArrive) {
    constexpr std::uint64_t kTicks = 6000;
    HapticParameters parameters;
    parameters.set_rate_hz(4000.0);
    auto owned = std::make_unique<haptic::SimulatedDevice>();
    haptic::SimulatedDevice& device = *owned;
    device.set_target({.position_mm = {90.0, 100.0, 0.0}});
    HapticJobOptions options;
    options.wait = jobs::WaitMode::kSleep;
    options.end_periods = kTicks;
    // 0 is no priority, and refused: a test shares the machine with others.
    options.real_time = {.core = {}, .fifo_priority = 0, .lock_memory = false, .wakeful_cores = false};
    HapticJob job(HapticState(), parameters, std::move(owned), options);
    ASSERT_TRUE(job.start());

    HapticState replayed;
    std::uint64_t records = 0;
    std::uint64_t last_tick = 0;
    std::uint64_t last_run = 0;
    int frame = 0;
    const auto replay_records = [&] {
        TickRecord record;
        while (job.take_record(record)) {
            ++records;
            if ((record.flags & TickRecord::kFreshLump) != 0) replayed.restart_from(HapticState());
            const TickResult result = tick(replayed, record.tool, parameters);
            ASSERT_EQ(result.forces.total_n(), record.force_n);
        }
    };
    const std::int64_t bound_ns = jobs::MonotonicClock::now_ns() +
                                  std::chrono::nanoseconds(test::scaled(std::chrono::minutes(1))).count();
    while (!job.finished() && jobs::MonotonicClock::now_ns() < bound_ns) {
        ++frame;
        const double along = static_cast<double>(frame % 100) / 100.0;
        device.set_target({.position_mm = {75.0 - 20.0 * along, 20.0 + 150.0 * along, 0.0},
                           .radius_mm = 10.0,
                           .wheel_button = frame % 50 > 5});
        const Snapshot& snapshot = job.newest_snapshot();
        ASSERT_TRUE(snapshot.run > last_run || snapshot.tick >= last_tick);
        last_run = snapshot.run;
        last_tick = snapshot.tick;
        ASSERT_TRUE(std::all_of(snapshot.pot->outer_mm.begin(), snapshot.pot->outer_mm.end(),
                                [](float radius_mm) { return radius_mm >= 2.0F && radius_mm <= 60.0F; }));
        bool sent = true;
        if (frame % 1000 == 999) sent = job.send(Command::kFreshLump);
        if (frame % 70 == 0) sent = job.send(Command::kRearmForce) && sent;
        ASSERT_TRUE(sent);
        replay_records();
        jobs::MonotonicClock::sleep_until_ns(jobs::MonotonicClock::now_ns() + 300'000);
    }
    EXPECT_TRUE(job.finished());
    job.stop();
    replay_records();
    EXPECT_EQ(records, job.stats().ticks);
    EXPECT_EQ(job.dropped_records(), 0U);
    EXPECT_EQ(replayed.hash(), job.state().hash());
    EXPECT_GT(frame, 1);
}

}  // namespace
}  // namespace onggi::haptic
