#include "engine/haptics/watchdog.h"

#include <gtest/gtest.h>

#include "tests/support/comes_true.h"

namespace onggi::haptics {
namespace {

constexpr std::int64_t kMs = 1'000'000;

class Silenced final : public HapticDevice {
  public:
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] DeviceCapabilities capabilities() const override { return {}; }
    [[nodiscard]] HandSample read(std::uint64_t, double) noexcept override { return {}; }
    void write(const dvec3&) noexcept override {}
    void silence() noexcept override { ++times; }

    std::atomic<int> times{0};
};

struct WatchdogTest : testing::Test {
    Silenced device;
};

TEST_F(WatchdogTest, LetsTheDeviceGoWhenTheLoopStandsStill) {
    Watchdog watchdog(device, {});
    std::int64_t now_ns = 7 * kMs;
    for (int k = 0; k < 100; ++k, now_ns += kMs) {
        watchdog.beat();
        (void)watchdog.round(now_ns);
    }
    EXPECT_EQ(device.times, 0);
    std::int64_t silent_ns = 0;
    while (device.times == 0 && silent_ns < 100 * kMs) {
        silent_ns += kMs;
        (void)watchdog.round(now_ns += kMs);
    }
    EXPECT_LE(silent_ns, 6 * kMs);
    EXPECT_EQ(watchdog.silences(), 1U);
    // It repeats the call at every check, in case one is lost; it still counts as one silence.
    (void)watchdog.round(now_ns += kMs);
    EXPECT_EQ(device.times, 2);
    EXPECT_EQ(watchdog.silences(), 1U);
}

TEST_F(WatchdogTest, ForgivesALoopThatBeatsAgain) {
    Watchdog watchdog(device, {});
    watchdog.beat();
    std::int64_t now_ns = 0;
    for (int k = 0; k < 20; ++k)
        (void)watchdog.round(now_ns += kMs);
    const int before = device.times;
    EXPECT_GT(before, 0);
    for (int k = 0; k < 20; ++k) {
        watchdog.beat();
        (void)watchdog.round(now_ns += kMs);
    }
    EXPECT_EQ(device.times, before);
}

TEST_F(WatchdogTest, WaitsForALoopThatIsSlowByDesign) {
    Watchdog watchdog(device, {.rate_hz = 100.0});
    std::int64_t now_ns = 0;
    for (int k = 0; k < 1000; ++k) {
        if (k % 10 == 0) watchdog.beat();
        (void)watchdog.round(now_ns += kMs);
    }
    EXPECT_EQ(device.times, 0);
}

TEST_F(WatchdogTest, LooksLessOftenAtALoopThatRestsAndAtOnceAgainAtOneThatDoesNot) {
    Watchdog watchdog(device, {});
    watchdog.rest(true);
    std::int64_t now_ns = 0;
    for (int k = 0; k < 1000; ++k) {
        if (k % 2 == 0) watchdog.beat();  // late by one look
        EXPECT_EQ(watchdog.round(now_ns), Watchdog::kLookAtRestNs);
        now_ns += Watchdog::kLookAtRestNs;
    }
    EXPECT_EQ(device.times, 0);
    watchdog.rest(false);
    watchdog.beat();
    EXPECT_EQ(watchdog.round(now_ns), kMs);
    for (int k = 0; k < 6; ++k)
        (void)watchdog.round(now_ns += kMs);
    EXPECT_EQ(device.times, 1);
}

TEST_F(WatchdogTest, WaitsForTheFirstBeatAndTheFirstPicture) {
    Watchdog watchdog(device, {});
    for (int k = 0; k < 10'000; ++k)
        (void)watchdog.round(k * kMs);
    EXPECT_EQ(device.times, 0);
    EXPECT_FALSE(watchdog.picture_stands_still());
}

TEST_F(WatchdogTest, TellsAPictureThatStandsStillFromASlowOne) {
    Watchdog watchdog(device, {});
    std::int64_t now_ns = 0;
    for (int k = 0; k < 10'000; ++k) {
        if (k % 1500 == 0) watchdog.picture_is_alive();
        (void)watchdog.round(now_ns += kMs);
        ASSERT_FALSE(watchdog.picture_stands_still());
    }
    for (int k = 0; k < 2000; ++k)
        (void)watchdog.round(now_ns += kMs);
    EXPECT_TRUE(watchdog.picture_stands_still());
    watchdog.picture_is_alive();
    (void)watchdog.round(now_ns += kMs);
    EXPECT_FALSE(watchdog.picture_stands_still());
}

TEST_F(WatchdogTest, WorksOnItsOwnThread) {
    Watchdog watchdog(device, {});
    watchdog.beat();
    jobs::IoThread thread;
    ASSERT_TRUE(thread.start(watchdog, "onggi-watchdog"));
    EXPECT_TRUE(test::comes_true([&] { return device.times > 0; }));
    thread.stop();
}

}  // namespace
}  // namespace onggi::haptics
