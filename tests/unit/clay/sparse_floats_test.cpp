#include "game/clay/sparse_floats.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace onggi::clay {
namespace {

constexpr std::size_t kCount = std::size_t{4} << 20U;  // 16 MB
constexpr long kPageKb = 4;

std::vector<std::uint32_t> bits(const SparseFloats& floats) {
    std::vector<std::uint32_t> all;
    for (std::size_t at = 0; at < floats.size(); ++at)
        all.push_back(std::bit_cast<std::uint32_t>(floats.data()[at]));
    return all;
}

// The memory of these floats by the kernel's count. It counts per mapping and merges similar neighbours, so
// this mapping is made different during the query.
long memory_kb(const SparseFloats& floats) {
    const auto place = reinterpret_cast<std::uintptr_t>(floats.data());
    const std::uintptr_t page = static_cast<std::uintptr_t>(kPageKb) * 1024;
    const std::uintptr_t begin = place / page * page;
    const std::uintptr_t end = (place + floats.size() * sizeof(float) + page - 1) / page * page;
    EXPECT_EQ(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTFORK), 0);
    long found_kb = -1;
    std::ifstream maps("/proc/self/smaps");
    bool is_there = false;
    for (std::string line; found_kb < 0 && std::getline(maps, line);) {
        std::istringstream words(line);
        std::uintptr_t first = 0;
        char dash = 0;
        if (words >> std::hex >> first >> dash && dash == '-') is_there = first == begin;
        if (is_there && line.starts_with("Anonymous:")) found_kb = std::stol(line.substr(10));
    }
    EXPECT_EQ(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DOFORK), 0);
    return found_kb;
}

TEST(SparseFloats, AreCopiedByEveryBit) {
    SparseFloats floats(10'000);
    floats.data()[0] = -0.0F;
    floats.data()[4'321] = 2.5F;
    floats.data()[9'999] = -1e-40F;
    const SparseFloats copy(floats);
    EXPECT_EQ(bits(copy), bits(floats));

    SparseFloats other(10'000);
    other.data()[7'000] = 1.0F;  // where the copied ones have 0
    other = floats;
    EXPECT_EQ(bits(other), bits(floats));
    SparseFloats shorter(3);
    shorter = floats;
    EXPECT_EQ(bits(shorter), bits(floats));
    const SparseFloats moved(std::move(shorter));
    EXPECT_EQ(bits(moved), bits(floats));
    other = moved;
    EXPECT_EQ(bits(other), bits(floats));
}

// Most kernels map one shared zero page for reading, which takes no memory; those of some virtual machines do
// not.
long kb_for_reading() {
    const SparseFloats untouched(kCount);
    const long before_kb = memory_kb(untouched);
    float sum = 0.0F;
    for (std::size_t at = 0; at < kCount; ++at)
        sum += untouched.data()[at];
    EXPECT_EQ(sum, 0.0F);
    return memory_kb(untouched) - before_kb;
}

TEST(SparseFloats, TakeMemoryOnlyForWrittenPagesUntilAllIsCommitted) {
    const long reading_kb = kb_for_reading();
    SparseFloats floats(kCount);
    const long before_kb = memory_kb(floats);
#ifdef __aarch64__
    if (before_kb < 0) GTEST_SKIP() << "qemu-user tells no process how much memory it has";
#endif
    ASSERT_GE(before_kb, 0);
    floats.data()[kCount / 2] = 1.0F;
    EXPECT_LE(memory_kb(floats) - before_kb, 2 * kPageKb);

    const long written_kb = memory_kb(floats);
    SparseFloats copy(floats);
    // Kernels with large folios allocate up to 128 kB for each written page, and its floats lie in two.
    EXPECT_LE(memory_kb(copy), written_kb + reading_kb + 64 * kPageKb) << "the copy of a page is a page";
    copy.take_memory();
    constexpr long kAllKb = static_cast<long>(kCount * sizeof(float) / 1024);
    EXPECT_GE(memory_kb(copy), kAllKb);
    EXPECT_EQ(copy.data()[kCount / 2], 1.0F);
}

}  // namespace
}  // namespace onggi::clay
