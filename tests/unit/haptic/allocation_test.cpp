// A program of its own: it counts every allocation of the process by replacing the allocation functions.
// Under AddressSanitizer and ThreadSanitizer these are taken; there the other suites watch instead.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "game/haptic/job.h"
#include "tests/support/scripted_device.h"

namespace {
std::atomic<std::uint64_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    void* memory = alignment <= alignof(std::max_align_t) ? std::malloc(size == 0 ? 1 : size)
                                                          : std::aligned_alloc(alignment, rounded);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
}  // namespace

void* operator new(std::size_t size) {
    return counted(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}

namespace onggi::haptic {
namespace {

TEST(AllocationCounter, SeesPlainAndAlignedAllocations) {
    const std::uint64_t before = allocations.load();
    // Called by name: a compiler may leave out the allocation of a new-expression, but not these.
    ::operator delete(::operator new(100));
    ::operator delete (::operator new (100, std::align_val_t{64}), std::align_val_t{64});
    EXPECT_EQ(allocations.load() - before, 2U);
}

TEST(HapticTick, AllocatesNothingInAHundredThousandTicks) {
    HapticState state;
    const HapticParameters parameters;
    const std::uint64_t before = allocations.load();
    for (std::uint64_t k = 0; k < 100'000; ++k)
        tick(state, test::scripted_tool(k), parameters);
    EXPECT_EQ(allocations.load(), before);
}

TEST(HapticWork, AllocatesNothingWhileItTicksPublishesRecordsRestartsAndObeys) {
    HapticWork work(HapticState(), HapticParameters{}, std::make_unique<test::ScriptedDevice>(),
                    {.run_ticks = 2500, .repeat = true});
    jobs::Period period{.dt_s = 0.001};
    std::uint64_t seen = 0;
    const std::uint64_t before = allocations.load();
    for (std::uint64_t k = 0; k < 100'000; ++k) {
        period.index = period.tick = k;
        ASSERT_TRUE(work.tick(period));
        if (k % 16 == 0) seen += work.newest_snapshot().tick;
        if (k % 7001 == 0 && !work.send(Command::kFreshLump)) FAIL();
        TickRecord record;
        while (work.take_record(record))
            seen += record.flags;
        BlockHash hash;
        while (work.take_hash(hash))
            seen += hash.ticks;
    }
    EXPECT_EQ(allocations.load(), before);
    EXPECT_GT(seen, 0U);
    EXPECT_GT(work.runs(), 40U);
    EXPECT_EQ(work.dropped_records(), 0U);
}

}  // namespace
}  // namespace onggi::haptic
