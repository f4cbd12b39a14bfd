// Safety property 13: the tick makes no system call. It runs under a system call filter, with the time stamp
// counter disabled, counting allocations, locks and exceptions, and watching page faults. Each watch is
// proved to work by a device that does the forbidden thing in the middle of a tick. A program of its own.
#include <gtest/gtest.h>

#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "game/haptic/job.h"
#include "tests/haptics/quiet_watch.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::haptic {
namespace {

using test::Disturbances;

constexpr int kTicks = 4000;

// A job's whole work without its thread: ticks, snapshots, records, commands, the watchdog's beat.
class Loop {
  public:
    Loop(const HapticState& start, ToolDevices devices)
        : work_(start, {}, std::move(devices), {.run_ticks = 9000, .repeat = true}) {}

    void run() {
        for (int k = 0; k < kTicks; ++k) {
            if (k % 701 == 0) sent_ = work_.send(k % 1402 == 0 ? Command::kFreshLump : Command::kRearmForce);
            if (!work_.tick(period_)) std::abort();
            period_.skipped = k % 97 == 0 ? 1 : 0;
            period_.dt_s = period_.skipped > 0 ? 0.002 : 0.001;
            period_.index += 1 + period_.skipped;
            ++period_.tick;
            if (k % 16 == 0) seen_ += work_.newest_snapshot().tick;
            TickRecord record;
            while (work_.take_record(record))
                seen_ += record.flags;
        }
    }
    [[nodiscard]] std::uint64_t seen() const { return seen_; }

  private:
    HapticWork work_;
    jobs::Period period_{.dt_s = 0.001};
    std::uint64_t seen_ = 0;
    bool sent_ = false;
};

TEST(SafetyProperty13, TheTickOfThePapersClayMakesNoSystemCall) {
    Loop loop(HapticState(), std::make_unique<test::ScriptedDevice>());
    const Disturbances found = test::watch([&] { loop.run(); });
    EXPECT_TRUE(found.none()) << found.words();
    EXPECT_GT(loop.seen(), 0U);
}

TEST(SafetyProperty13, TheTickOfTheStudiosClayMakesNoSystemCall) {
    Loop loop(test::studio_start(), std::make_unique<test::StudioHand>(1000.0));
    const Disturbances found = test::watch([&] { loop.run(); });
    EXPECT_TRUE(found.none()) << found.words();
}

// Does something forbidden in the middle of every thousandth tick.
template <typename Offence>
class Offender final : public test::ScriptedDevice {
  public:
    explicit Offender(Offence offence) : offence_(std::move(offence)) {}
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double dt_s) noexcept override {
        if (++count_ % 1000 == 0) offence_();
        return ScriptedDevice::read_tool(tick, dt_s);
    }

  private:
    Offence offence_;
    int count_ = 0;
};

template <typename Offence>
Disturbances found_of(Offence offence) {
    Loop loop(HapticState(), std::make_unique<Offender<Offence>>(std::move(offence)));
    return test::watch([&] { loop.run(); });
}

TEST(TheWatch, SeesSystemCalls) {
    EXPECT_EQ(found_of([] { static_cast<void>(getppid()); }).system_calls, 4);
    // A log line, written to /dev/null here.
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> log(std::fopen("/dev/null", "w"), &std::fclose);
    ASSERT_NE(log, nullptr);
    std::setvbuf(log.get(), nullptr, _IOLBF, 256);
    EXPECT_GE(found_of([&] { std::fputs("a line\n", log.get()); }).system_calls, 4);
}

TEST(TheWatch, SeesAClockThatNeedsNoSystemCall) {
    const Disturbances found =
        found_of([] { static_cast<void>(std::chrono::steady_clock::now().time_since_epoch().count()); });
    EXPECT_GE(found.clock_reads + found.system_calls, 4) << found.words();
}

TEST(TheWatch, SeesMemoryTakenAndGiven) {
    EXPECT_GE(found_of([] { std::make_unique<std::string>(100, 'x').reset(); }).allocations, 8);
}

TEST(TheWatch, SeesLocks) {
    std::mutex mutex;
    EXPECT_EQ(found_of([&] { const std::lock_guard lock(mutex); }).locks, 4);
}

TEST(TheWatch, SeesExceptions) {
    EXPECT_EQ(found_of([] {
                  try {
                      throw std::runtime_error("none of that");
                  } catch (const std::runtime_error&) {
                  }
              }).exceptions,
              4);
}

TEST(TheWatch, SeesPagesThatAreNotThere) {
    constexpr std::size_t kPage = 4096;
    constexpr std::size_t kPages = 64;
    auto* pages = static_cast<volatile char*>(
        mmap(nullptr, kPage * kPages, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    ASSERT_NE(static_cast<volatile void*>(pages), MAP_FAILED);
    std::size_t next = 0;
    EXPECT_GE(found_of([&] { pages[kPage * (next++ % kPages)] = 1; }).page_faults, 1);
    munmap(const_cast<char*>(pages), kPage * kPages);
}

}  // namespace
}  // namespace onggi::haptic
