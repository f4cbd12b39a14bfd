#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "game/app/command_line/live_loop.h"
#include "game/app/command_line/stats.h"
#include "tests/support/scripted_device.h"

namespace onggi::app {
namespace {

// A run that requests nothing a test machine may refuse, and does not occupy a core.
LiveRun modest_run(std::uint64_t tick_count, std::optional<double> seconds) {
    return {.start = {},
            .devices = std::make_unique<test::ScriptedDevice>(),
            .tick_count = tick_count,
            .seconds = seconds,
            .wait = jobs::WaitMode::kSleep,
            // 0 is no priority, and refused: a test shares the machine with others.
            .real_time = {.core = {}, .fifo_priority = 0, .lock_memory = false, .wakeful_cores = false}};
}

Result<FrameOutcome> draw_nothing(const haptic::Snapshot& /*snapshot*/) {
    return FrameOutcome::kDrawn;
}

TEST(LiveLoop, PlaysEveryTickOfAPathOnce) {
    const auto report = run_live(modest_run(300, std::nullopt), draw_nothing);
    ASSERT_TRUE(report);
    EXPECT_EQ(report.value().ticks.ticks, 300U);
    EXPECT_EQ(report.value().lumps, 1U);
    EXPECT_GE(report.value().frames, 2U);
    EXPECT_EQ(report.value().dropped_records, 0U);
    // The same ticks in simulated time make the same clay, however late some of them were.
    haptic::HapticState thrown;
    for (std::uint64_t k = 0; k < 300; ++k)
        haptic::tick(thrown, test::scripted_tool(k), haptic::HapticParameters{});
    EXPECT_EQ(report.value().state.hash(), thrown.hash());
}

TEST(LiveLoop, StartsAgainOnAFreshLumpUntilItsTimeIsUp) {
    const auto report = run_live(modest_run(100, 0.25), draw_nothing);
    ASSERT_TRUE(report);
    const jobs::TickStats& ticks = report.value().ticks;
    EXPECT_GE(ticks.ticks + ticks.skipped_periods, 250U);
    EXPECT_EQ(report.value().lumps, (ticks.ticks + 99) / 100);
}

TEST(LiveLoop, ShowsSnapshotsThatGoForward) {
    std::set<std::uint64_t> seen;
    std::uint64_t last = 0;
    const auto report = run_live(modest_run(300, std::nullopt), [&](const haptic::Snapshot& snapshot) {
        EXPECT_GE(snapshot.tick, last);
        EXPECT_EQ(snapshot.pot->outer_mm.size(), 2000U);
        last = snapshot.tick;
        seen.insert(last);
        return Result<FrameOutcome>(FrameOutcome::kDrawn);
    });
    ASSERT_TRUE(report);
    EXPECT_GE(seen.size(), 2U);
}

TEST(LiveLoop, EndsWithTheWindowAndReportsItsStatistics) {
    int frame = 0;
    const auto report =
        run_live(modest_run(1'000'000, std::nullopt), [&](const haptic::Snapshot& /*snapshot*/) {
            ++frame;
            return Result<FrameOutcome>(frame < 4 ? FrameOutcome::kDrawn : FrameOutcome::kClosed);
        });
    ASSERT_TRUE(report);
    EXPECT_EQ(report.value().frames, 3U);
    EXPECT_LT(report.value().ticks.ticks, 1'000'000U);
}

TEST(LiveLoop, TakesTheForceAwayWhenTheWindowsStopKeyIsPressed) {
    bool was_pressed = false;
    const auto report = run_live(modest_run(300, std::nullopt), [&](const haptic::Snapshot& /*snapshot*/) {
        const auto outcome = was_pressed ? FrameOutcome::kDrawn : FrameOutcome::kStopped;
        was_pressed = true;
        return Result<FrameOutcome>(outcome);
    });
    ASSERT_TRUE(report);
    EXPECT_EQ(report.value().state.safety.fault, haptics::Fault::kStopped);
    EXPECT_GE(report.value().frames, 1U);
}

TEST(LiveLoop, CountsOnlyTheFramesThatWereDrawn) {
    const auto report = run_live(modest_run(100, std::nullopt), [](const haptic::Snapshot& /*snapshot*/) {
        return Result<FrameOutcome>(FrameOutcome::kNotShown);
    });
    ASSERT_TRUE(report);
    EXPECT_EQ(report.value().frames, 0U);
    EXPECT_GT(report.value().frame_ns.count(), 0U);
}

TEST(LiveLoop, EndsWithTheErrorOfAFrame) {
    const auto report =
        run_live(modest_run(1'000'000, std::nullopt), [](const haptic::Snapshot& /*snapshot*/) {
            return Result<FrameOutcome>(failed("the device was lost"));
        });
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().message, "the device was lost");
}

TEST(LiveStats, HaveTheDocumentedFields) {
    LiveReport report;
    report.rate_hz = 4000.0;
    report.ticks.ticks = 90;
    report.ticks.skipped_periods = 8;
    report.ticks.overrun_periods = 2;
    report.ticks.tick_ns.record(350);
    report.ticks.wake_latency_ns.record(2'000);
    report.frames = 3;
    report.frame_ns.record(8'000'000);
    report.real_time.core.core = 1;
    report.real_time.pinning.grant = jobs::Grant::kGranted;
    report.real_time.fifo.grant = jobs::Grant::kGranted;

    const nlohmann::ordered_json stats = live_stats(report);
    EXPECT_EQ(stats["ticks"], 90);
    EXPECT_EQ(stats["rate_hz"], 4000.0);
    EXPECT_EQ(stats["tick_ns"]["p50"], 350.0);
    EXPECT_EQ(stats["missed_deadlines"], 10);
    for (const char* fraction : {"p50", "p99", "p999", "max"})
        EXPECT_EQ(stats["wake_latency_us"][fraction], 2.0) << fraction;
    EXPECT_EQ(stats["frames"], 3);
    for (const char* fraction : {"p50", "p99", "max"})
        EXPECT_EQ(stats["frame_ms"][fraction], 8.0) << fraction;
    EXPECT_EQ(stats["haptic_core"], 1);
    EXPECT_EQ(stats["scheduler"], "fifo");
    EXPECT_NEAR(stats["clay_volume_mm3"].get<double>(), 2261946.7, 0.1);
    EXPECT_TRUE(stats["ledger_error"].is_null());
}

TEST(LiveStats, ListRefusals) {
    LiveReport report;
    report.real_time.core.core = 1;
    report.real_time.pinning.grant = jobs::Grant::kRefused;
    report.real_time.fifo.grant = jobs::Grant::kRefused;
    const nlohmann::ordered_json stats = live_stats(report);
    EXPECT_EQ(stats["scheduler"], "other");
    EXPECT_EQ(stats["haptic_core"], -1);
    EXPECT_EQ(stats["memory_locked"], false);
}

}  // namespace
}  // namespace onggi::app
