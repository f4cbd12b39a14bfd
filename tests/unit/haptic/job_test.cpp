#include "game/haptic/job.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/scripted_device.h"
#include "tests/support/virtual_clock.h"

namespace onggi::haptic {
namespace {

using test::ScriptedDevice;
using test::VirtualClock;

// A HapticWork, and the device inside it.
struct JobBench {
    explicit JobBench(const HapticJobOptions& options = {})
        : JobBench(options, std::make_unique<ScriptedDevice>()) {}
    JobBench(const HapticJobOptions& options, std::unique_ptr<ScriptedDevice> owned)
        : device(*owned),
          work(HapticState(), HapticParameters{}, std::move(owned), options) {}

    // Runs on virtual time until the work is done, at most most_ticks.
    jobs::TickStats run(std::uint64_t most_ticks = 1'000'000, std::int64_t tick_ns = 1000) {
        jobs::Pacer pacer(clock, {.rate_hz = 1000.0, .wait = jobs::WaitMode::kSleep});
        bool more = true;
        for (std::uint64_t k = 0; more && k < most_ticks; ++k) {
            const jobs::Period period = pacer.wait_for_next();
            more = work.tick(period);
            clock.pass(tick_ns);
            pacer.finish(period);
        }
        return pacer.stats();
    }
    std::vector<TickRecord> take_records() {
        std::vector<TickRecord> records;
        TickRecord record;
        while (work.take_record(record))
            records.push_back(record);
        return records;
    }

    VirtualClock clock;
    ScriptedDevice& device;
    HapticWork work;
};

TEST(HapticWork, ReadsTicksAndWritesOnceAPeriod) {
    JobBench bench;
    bench.run(250);
    EXPECT_EQ(bench.device.reads, 250U);
    EXPECT_EQ(bench.device.writes, 250U);
    EXPECT_EQ(bench.device.last_tick, 249U);
    EXPECT_EQ(bench.work.state().ticks, 250U);
}

TEST(HapticWork, NeedsPunctualityWhereSomebodyFeelsIt) {
    struct Motors final : ScriptedDevice {
        explicit Motors(bool has) : has_(has) {}
        [[nodiscard]] haptics::DeviceCapabilities capabilities() const override {
            return {.name = "script", .force_axes = 3, .has_motors = has_};
        }
        bool has_;
    };
    for (const bool motors : {false, true}) {
        for (const bool spares : {false, true}) {
            const JobBench bench({.spares_the_core = spares}, std::make_unique<Motors>(motors));
            EXPECT_EQ(bench.work.needs_punctuality(), motors || !spares) << motors << ", " << spares;
        }
    }
}

TEST(HapticWork, TicksInBurstsOnlyWhileNobodyIsThereAndNoOtherDeviceIsPluggedIn) {
    struct Alone final : ScriptedDevice {
        [[nodiscard]] haptics::DeviceCapabilities capabilities() const override {
            return {.name = "script", .has_motors = false};
        }
        [[nodiscard]] haptics::DeviceSigns signs() const noexcept override { return {.is_alone = is_alone}; }
        bool is_alone = true;
    };
    auto owned = std::make_unique<Alone>();
    Alone& device = *owned;
    JobBench bench({.spares_the_core = true}, std::move(owned));
    const auto after = [&](Command command) {
        EXPECT_TRUE(bench.work.send(command));
        bench.run(1);
        return bench.work.ticks_at_once();
    };
    bench.run(1);
    EXPECT_EQ(bench.work.ticks_at_once(), 1U) << "somebody may be there";
    EXPECT_EQ(after(Command::kLetGo), 4U) << "4 ms at 1 kHz";
    device.is_alone = false;
    bench.run(1);
    EXPECT_EQ(bench.work.ticks_at_once(), 1U) << "a device has appeared";
    device.is_alone = true;
    bench.run(1);
    EXPECT_EQ(bench.work.ticks_at_once(), 4U);
    EXPECT_EQ(after(Command::kTakeHold), 1U) << "a visitor has touched";
}

TEST(HapticWork, EndsWithTheLastTickOfItsRun) {
    JobBench bench({.run_ticks = 1234});
    EXPECT_EQ(bench.run().ticks, 1234U);
    EXPECT_EQ(bench.work.state().ticks, 1234U);
    EXPECT_EQ(bench.work.runs(), 1U);
}

TEST(HapticWork, StartsAgainOnAFreshLumpUntilItsTimeIsUp) {
    JobBench bench({.run_ticks = 1000, .repeat = true, .end_periods = 2500});
    EXPECT_EQ(bench.run().ticks, 2500U);
    EXPECT_EQ(bench.work.runs(), 3U);
    EXPECT_EQ(bench.work.state().ticks, 500U);
    JobBench once({.run_ticks = 500});
    once.run();
    EXPECT_EQ(bench.work.state().hash(), once.work.state().hash());
}

TEST(HapticWork, EndsOnTimeAlthoughItSkipsPeriods) {
    JobBench bench({.run_ticks = 100'000, .end_periods = 1000});
    const jobs::TickStats stats = bench.run(1'000'000, 2'500'000);  // each tick takes two and a half periods
    EXPECT_LT(stats.ticks, 500U);
    EXPECT_GE(stats.ticks + stats.skipped_periods, 1000U);
    EXPECT_LE(stats.ticks + stats.skipped_periods, 1003U);
    EXPECT_DOUBLE_EQ(bench.device.longest_dt_s, 0.002);
    // No tick of the gesture is left out, however late: the clay is that of the ticks that ran.
    EXPECT_EQ(bench.device.last_tick + 1, stats.ticks);
    EXPECT_EQ(bench.work.newest_snapshot().skipped_periods, stats.skipped_periods);
}

TEST(HapticWork, KeepsARecordOfEveryTickThatReplaysToTheSameState) {
    JobBench bench({.run_ticks = 2500, .repeat = true, .end_periods = 6000});
    bench.run();
    const std::vector<TickRecord> records = bench.take_records();
    ASSERT_EQ(records.size(), 6000U);
    EXPECT_EQ(bench.work.dropped_records(), 0U);

    HapticState replayed;
    const HapticParameters parameters;
    for (const TickRecord& record : records) {
        if ((record.flags & TickRecord::kFreshLump) != 0) replayed.restart_from(HapticState());
        ASSERT_EQ(record.tick, replayed.ticks);
        const TickResult result = tick(replayed, record.tool, parameters);
        ASSERT_EQ(result.forces.total_n(), record.force_n);
    }
    EXPECT_EQ(replayed.hash(), bench.work.state().hash());
}

TEST(HapticWork, CountsUnreadRecords) {
    JobBench bench({.run_ticks = 100, .record_capacity = 64});
    bench.run();
    EXPECT_EQ(bench.work.dropped_records(), 36U);
    const std::vector<TickRecord> records = bench.take_records();
    ASSERT_EQ(records.size(), 64U);
    EXPECT_EQ(records.back().tick, 63U);
}

TEST(HapticWork, PublishesTheDataOfAPicture) {
    JobBench bench;
    EXPECT_EQ(bench.work.newest_snapshot().tick, 0U);
    EXPECT_EQ(bench.work.newest_snapshot().pot->outer_mm.size(), 2000U);
    bench.run(1700);
    const Snapshot& snapshot = bench.work.newest_snapshot();
    const HapticState& state = bench.work.state();
    EXPECT_EQ(snapshot.tick, 1700U);
    EXPECT_EQ(snapshot.run, 0U);
    EXPECT_EQ(snapshot.tool, test::scripted_tool(1699));
    EXPECT_TRUE(snapshot.wheel_turning);
    EXPECT_EQ(snapshot.wheel_direction, dvec2(state.wheel.heading().cosine, state.wheel.heading().sine));
    EXPECT_GT(snapshot.result.forces.contacts, 0);
    EXPECT_EQ(snapshot.result.limited_force_n, bench.device.last_force_n);
    EXPECT_TRUE(std::equal(snapshot.pot->outer_mm.begin(), snapshot.pot->outer_mm.end(),
                           state.paper()->radii_mm().begin()));
}

TEST(HapticWork, PutsOnAFreshLumpWhenTold) {
    JobBench bench;
    bench.run(1500);
    EXPECT_TRUE(bench.work.send(Command::kFreshLump));
    bench.run(1);
    EXPECT_EQ(bench.work.state().ticks, 1U);
    EXPECT_EQ(bench.work.runs(), 2U);
    EXPECT_NE(bench.take_records().back().flags & TickRecord::kFreshLump, 0U);
    EXPECT_EQ(bench.work.newest_snapshot().run, 1U);
}

// A script with one invalid tick.
class FaultyDevice final : public ScriptedDevice {
  public:
    tool::ToolState read_tool(std::uint64_t tick, double dt_s) noexcept override {
        tool::ToolState tool = ScriptedDevice::read_tool(tick, dt_s);
        if (tick == 4000) tool.position_mm.y = 1e9;
        return tool;
    }
};

TEST(HapticWork, TakesAFaultBackWhenTold) {
    JobBench bench({}, std::make_unique<FaultyDevice>());
    bench.run(4000);
    EXPECT_GT(bench.device.largest_force_n, 0.0);
    bench.run(1);
    EXPECT_EQ(bench.work.newest_snapshot().fault, haptics::Fault::kOutsideWorkspace);
    bench.device.largest_force_n = 0.0;
    bench.run(6000);
    EXPECT_EQ(bench.device.largest_force_n, 0.0);
    EXPECT_NE(bench.take_records().back().flags & TickRecord::kFault, 0U);

    EXPECT_TRUE(bench.work.send(Command::kRearmForce));
    bench.run(6000);
    EXPECT_EQ(bench.work.newest_snapshot().fault, haptics::Fault::kNone);
    EXPECT_GT(bench.device.largest_force_n, 0.0);
    EXPECT_LE(bench.device.largest_force_n, 3.3 * (1.0 + 1e-12));
}

}  // namespace
}  // namespace onggi::haptic
