// A program of its own: it counts every allocation of the process by replacing the allocation functions.
// AddressSanitizer and ThreadSanitizer replace them themselves; there other suites check instead.
#include <gtest/gtest.h>

#include <memory>
#include <new>

#include "game/haptic/job.h"
#include "tests/support/allocation_count.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::haptic {
namespace {

TEST(AllocationCounter, SeesPlainAndAlignedAllocations) {
    const int before = test::allocation_count();
    // Called by name: a compiler may leave out the allocation of a new-expression, but not these.
    ::operator delete(::operator new(100));
    ::operator delete (::operator new (100, std::align_val_t{64}), std::align_val_t{64});
    EXPECT_EQ(test::allocation_count() - before, 2);
}

TEST(HapticTick, AllocatesNothingInAHundredThousandTicks) {
    HapticState state;
    const HapticParameters parameters;
    const int before = test::allocation_count();
    for (std::uint64_t k = 0; k < 100'000; ++k)
        tick(state, test::scripted_tool(k), parameters);
    EXPECT_EQ(test::allocation_count(), before);
}

TEST(HapticTick, OfTheStudioClayAllocatesNothing) {
    HapticState state = test::studio_start();
    const HapticParameters parameters;
    const int before = test::allocation_count();
    for (std::uint64_t k = 0; k < 9000; ++k)
        tick(state, test::studio_hand(k, 1000.0), parameters);
    EXPECT_EQ(test::allocation_count(), before);
    EXPECT_GT(state.studio()->splits(), 0U);
    EXPECT_GT(state.studio()->ledger().trimmings_mm3, 0.0);
}

// The main thread allocates the sent states, here before the count.
TEST(HapticWork, AllocatesNothingWhileItPutsStatesOnTheWheel) {
    HapticParameters parameters;
    HapticWork work(test::studio_start(), parameters, std::make_unique<test::StudioHand>(1000.0), {});
    jobs::Period period{.dt_s = 0.001};
    const auto run = [&](int ticks) {
        for (int k = 0; k < ticks; ++k) {
            if (!work.tick(period)) return false;
            ++period.index;
            ++period.tick;
            TickRecord record;
            while (work.take_record(record)) {
            }
        }
        return true;
    };
    ASSERT_TRUE(run(4000));
    for (int again = 0; again < 20; ++again) {
        if (!work.put(std::make_unique<HapticState>(test::studio_start()), 0)) FAIL();
        const int before = test::allocation_count();
        ASSERT_TRUE(run(500));
        ASSERT_EQ(test::allocation_count(), before);
    }
    EXPECT_EQ(work.newest_snapshot().states_put, 20U);
    EXPECT_EQ(work.state().ticks, 500U);
}

TEST(HapticWork, AllocatesNothingWhileItTicksPublishesRecordsRestartsAndObeys) {
    HapticWork work(HapticState(), HapticParameters{}, std::make_unique<test::ScriptedDevice>(),
                    {.run_ticks = 2500, .repeat = true});
    jobs::Period period{.dt_s = 0.001};
    std::uint64_t seen = 0;
    const int before = test::allocation_count();
    for (std::uint64_t k = 0; k < 100'000; ++k) {
        period.index = period.tick = k;
        ASSERT_TRUE(work.tick(period));
        if (k % 16 == 0) seen += work.newest_snapshot().tick;
        if (k % 7001 == 0 && !work.send(Command::kFreshLump)) FAIL();
        TickRecord record;
        while (work.take_record(record))
            seen += record.flags;
    }
    EXPECT_EQ(test::allocation_count(), before);
    EXPECT_GT(seen, 0U);
    EXPECT_GT(work.runs(), 40U);
    EXPECT_EQ(work.dropped_records(), 0U);
}

}  // namespace
}  // namespace onggi::haptic
