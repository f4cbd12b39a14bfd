// A device whose bus is stuck: the tick does not notice. The same job is run twice in one test, with a device
// that takes a report at once and with one that blocks for 5 ms in each; what a tick costs is compared.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "engine/haptics/hands.h"
#include "engine/haptics/hid/hid_device.h"
#include "engine/haptics/simulated_device.h"
#include "game/haptic/job.h"

namespace onggi::haptic {
namespace {

using namespace std::chrono_literals;

// A DualSense that reports every 4 ms, its stick held outwards, so that it has the tool.
class SlowPort final : public haptics::hid::HidPort {
  public:
    SlowPort(std::chrono::milliseconds write_takes, std::atomic<int>& writes)
        : write_takes_(write_takes),
          writes_(writes) {}
    Result<std::size_t> read(std::span<std::uint8_t> report, int timeout_ms) override {
        if (timeout_ms == 0) return std::size_t{0};
        std::this_thread::sleep_for(4ms);
        std::fill(report.begin(), report.end(), std::uint8_t{0});
        report[0] = 0x01;
        report[1] = ++reads_ % 2 == 0 ? 0xff : 0xf0;
        report[2] = report[3] = report[4] = 0x80;
        // Cross starts or stops the wheel every 24 ms, so that there is a new light to be told each time.
        report[8] = reads_ % 6 < 3 ? 0x28 : 0x08;
        return std::size_t{64};
    }
    Result<void> write(std::span<const std::uint8_t>) override {
        ++writes_;
        std::this_thread::sleep_for(write_takes_);
        return {};
    }
    Result<void> set_feature(std::span<const std::uint8_t>) override { return {}; }
    Result<std::size_t> get_feature(std::span<std::uint8_t>) override { return failed("none"); }
    bool is_there() override { return true; }
    void pause_ms(int) override {}

  private:
    std::chrono::milliseconds write_takes_;
    std::atomic<int>& writes_;
    std::uint8_t reads_ = 0;
};

class SlowBus final : public haptics::hid::HidBus {
  public:
    SlowBus(std::chrono::milliseconds write_takes, std::atomic<int>& writes)
        : write_takes_(write_takes),
          writes_(writes) {}
    Result<std::vector<haptics::HidDeviceInfo>> list() override {
        return std::vector<haptics::HidDeviceInfo>{
            {.path = "/dev/hidraw9", .may_open = true, .kind = haptics::HidKind::kDualSense}};
    }
    Result<std::unique_ptr<haptics::hid::HidPort>> open(const haptics::HidDeviceInfo&) override {
        return std::unique_ptr<haptics::hid::HidPort>(std::make_unique<SlowPort>(write_takes_, writes_));
    }

  private:
    std::chrono::milliseconds write_takes_;
    std::atomic<int>& writes_;
};

struct Cost {
    std::uint64_t p50_ns = 0;
    std::uint64_t p99_ns = 0;
    int writes = 0;
};

Cost cost_of_a_tick(std::chrono::milliseconds write_takes) {
    std::atomic<int> writes{0};
    std::vector<std::unique_ptr<haptics::Hand>> hands;
    auto mouse = std::make_unique<haptics::SimulatedDevice>();
    mouse->set_target({.position_mm = {90.0, 100.0, 0.0}, .wheel_button = true});
    hands.push_back(std::move(mouse));
    hands.push_back(
        std::make_unique<haptics::HidDevice>(haptics::HidDeviceOptions{.kind = haptics::HidKind::kDualSense},
                                             std::make_unique<SlowBus>(write_takes, writes)));
    HapticParameters parameters;
    parameters.set_rate_hz(1000.0);
    HapticJobOptions options;
    options.wait = jobs::WaitMode::kSleep;
    options.end_periods = 1000;
    options.real_time.fifo_priority = 0;  // refused: a test shares the machine with others
    options.real_time.lock_memory = false;
    options.real_time.wakeful_cores = false;
    HapticJob job(HapticState(), parameters, std::make_unique<haptics::Hands>(std::move(hands)), options);
    EXPECT_TRUE(job.start());
    TickRecord record;
    while (!job.finished()) {
        while (job.take_record(record)) {
        }
        std::this_thread::sleep_for(10ms);
    }
    job.stop();
    return {.p50_ns = job.stats().tick_ns.percentile(0.5),
            .p99_ns = job.stats().tick_ns.percentile(0.99),
            .writes = writes.load()};
}

TEST(ABlockedDevice, CostsTheTickNothing) {
    const Cost quick = cost_of_a_tick(0ms);
    const Cost blocked = cost_of_a_tick(5ms);
    std::printf(
        "tick p50/p99: %.1f/%.1f us beside a quick device, %.1f/%.1f us beside one that blocks 5 ms\n",
        static_cast<double>(quick.p50_ns) / 1e3, static_cast<double>(quick.p99_ns) / 1e3,
        static_cast<double>(blocked.p50_ns) / 1e3, static_cast<double>(blocked.p99_ns) / 1e3);
    EXPECT_GT(blocked.writes, 10) << "it was told something all the time";
    // Half of all ticks would take 5 ms if they waited; the machine's own unrest is far below a tenth of
    // that.
    EXPECT_LT(blocked.p50_ns, 2 * quick.p50_ns + 20'000U);
    EXPECT_LT(blocked.p50_ns, 500'000U);
}

}  // namespace
}  // namespace onggi::haptic
