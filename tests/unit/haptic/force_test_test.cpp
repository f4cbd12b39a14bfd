// The staff's force test of a device: the wanted force, the allowed force, and the measured response.
#include "game/haptic/force_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "game/haptic/job.h"

namespace onggi::haptic {
namespace {

using Stage = ForceTestReport::Stage;

constexpr double kRateHz = 1000.0;

double size_of(const dvec3& v) {
    return std::sqrt(glm::dot(v, v));
}

// A hand far from the clay, on a spring of 0.2 N/mm, that keeps the last force.
class SpringHand final : public haptic::ToolDevice {
  public:
    explicit SpringHand(double peak_force_n) : peak_force_n_(peak_force_n) {}

    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override {
        return {.name = "spring",
                .force_axes = 3,
                .peak_force_n = peak_force_n_,
                .continuous_force_n = peak_force_n_,
                .max_stiffness_n_per_mm = 0.1};
    }
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t, double) noexcept override {
        tool::ToolState tool;
        tool.position_mm = dvec3(170.0, 220.0, 120.0) + (told.empty() ? dvec3(0.0) : told.back() / 0.2);
        return tool;
    }
    [[nodiscard]] haptics::DeviceSigns signs() const noexcept override { return {.hand_is_there = is_held}; }
    void write(const dvec3& force_n) noexcept override { told.push_back(force_n); }

    bool is_held = true;
    std::vector<dvec3> told;

  private:
    double peak_force_n_;
};

struct Bench {
    explicit Bench(double peak_force_n = 3.3) {
        auto owned = std::make_unique<SpringHand>(peak_force_n);
        hand = owned.get();
        HapticParameters parameters;
        parameters.set_rate_hz(kRateHz);
        work = std::make_unique<HapticWork>(HapticState(clay::StudioClay(clay::StudioLump{})), parameters,
                                            std::move(owned), HapticJobOptions{.record_capacity = 1U << 15U});
    }
    void run(int ticks) {
        for (int k = 0; k < ticks; ++k) {
            const jobs::Period period{.dt_s = 1.0 / kRateHz};
            ASSERT_TRUE(work->tick(period));
        }
    }
    void tests_the_force(int ticks = 3000) {
        ASSERT_TRUE(work->send(Command::kTestForce));
        run(ticks);
    }
    [[nodiscard]] ForceTestReport report() { return work->newest_snapshot().force_test; }

    SpringHand* hand = nullptr;
    std::unique_ptr<HapticWork> work;
};

TEST(ForceTest, RequestsAtMostItsStatedForceAndOnlyDuringItsTime) {
    double largest_n = 0.0;
    dvec3 last_n(0.0);
    for (int k = -100; k < 2000; ++k) {
        const double time_s = k * 0.001;
        const dvec3 force_n = test_force_n(time_s);
        largest_n = std::max(largest_n, size_of(force_n));
        EXPECT_LT(size_of(force_n - last_n), 0.01) << "no jump at " << time_s;
        if (time_s < 0.0 || time_s > kTestPushes * kTestPushS) {
            EXPECT_EQ(size_of(force_n), 0.0) << time_s;
        }
        last_n = force_n;
    }
    EXPECT_NEAR(largest_n, kTestForceN, 1e-4);
    EXPECT_LE(largest_n, kTestForceN);
    EXPECT_LE(kTestForceN, haptics::kKioskContinuousForceN);
    EXPECT_EQ(size_of(test_force_n(std::nan(""))), 0.0);
}

TEST(ForceTest, PushesAlongEachAxisAndReportsTheHandsResponse) {
    Bench bench;
    bench.run(2000);
    bench.tests_the_force();
    const ForceTestReport report = bench.report();
    EXPECT_EQ(report.stage, Stage::kDone);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(report.given_n[axis], kTestForceN, 0.02) << axis;
        EXPECT_NEAR(report.moved_mm[axis], kTestForceN / 0.2, 0.2) << axis;
    }
    EXPECT_EQ(size_of(bench.hand->told.back()), 0.0);
}

TEST(ForceTest, WaitsForTheRampAfterAnAbsentHandAndLeavesItAbsent) {
    Bench bench;
    bench.run(2000);
    EXPECT_TRUE(bench.work->send(Command::kLetGo));
    bench.run(100);
    bench.tests_the_force(500);
    EXPECT_EQ(bench.report().stage, Stage::kWaits);
    bench.run(3000);
    EXPECT_EQ(bench.report().stage, Stage::kDone);
    EXPECT_NEAR(bench.report().given_n.y, kTestForceN, 0.02);
    EXPECT_EQ(bench.work->newest_snapshot().safety.presence, 0.0) << "the wheel is left alone again";
}

TEST(ForceTest, NeverExceedsTheDevicesLimit) {
    constexpr double kWeakN = 0.25;
    Bench bench(kWeakN);
    bench.run(2000);
    bench.tests_the_force();
    EXPECT_EQ(bench.report().stage, Stage::kDone);
    EXPECT_LE(bench.report().given_n.y, kWeakN * (1.0 + 1e-12));
    EXPECT_GT(bench.report().given_n.y, 0.0);
    for (const dvec3& told : bench.hand->told)
        ASSERT_LE(size_of(told), kWeakN * (1.0 + 1e-12));
}

TEST(ForceTest, GivesTheSameForcesToTheBitAndLeavesTheClayAlone) {
    Bench one;
    Bench other;
    Bench untested;
    for (Bench* bench : {&one, &other, &untested})
        bench->run(1500);
    one.tests_the_force();
    other.tests_the_force();
    untested.run(3000);
    EXPECT_EQ(one.hand->told, other.hand->told);
    EXPECT_NE(one.hand->told, untested.hand->told);
    TickRecord record;
    int records = 0;
    while (one.work->take_record(record)) {
        EXPECT_EQ(record.force_n, dvec3(0.0)) << "the recording has the clay's force";
        ++records;
    }
    EXPECT_EQ(records, 4500);
}

TEST(ForceTest, StopsForTheStopKeyAFreshLumpAndAReleasedHand) {
    Bench stopped;
    stopped.run(2000);
    stopped.tests_the_force(150);
    ASSERT_GT(size_of(stopped.hand->told.back()), 0.3);
    stopped.work->stop_force();
    stopped.run(2);
    EXPECT_EQ(size_of(stopped.hand->told.back()), 0.0);
    EXPECT_EQ(stopped.report().stage, Stage::kBroken);

    Bench fresh;
    fresh.run(2000);
    fresh.tests_the_force(150);
    EXPECT_TRUE(fresh.work->send(Command::kFreshLump));
    fresh.run(5);
    EXPECT_EQ(size_of(fresh.hand->told.back()), 0.0);
    EXPECT_EQ(fresh.report().stage, Stage::kBroken);

    Bench alone;
    alone.hand->is_held = false;
    alone.run(2000);
    alone.tests_the_force(3500);
    EXPECT_EQ(alone.report().stage, Stage::kNobody);
    for (const dvec3& told : alone.hand->told)
        ASSERT_EQ(size_of(told), 0.0);
}

}  // namespace
}  // namespace onggi::haptic
