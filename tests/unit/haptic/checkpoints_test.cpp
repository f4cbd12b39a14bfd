// Compressed checkpoints: each is restored to the bit, however many between them were dropped.
#include "game/haptic/checkpoints.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <random>

namespace onggi::haptic {
namespace {

using Bytes = std::vector<std::byte>;

// A sequence of states in which a range of numbers changes, and sometimes the length.
class Growing {
  public:
    Bytes next() {
        if (count_ % 5 == 3) numbers_.insert(numbers_.begin() + 300, 64, 0.25F);
        if (count_ % 11 == 7) numbers_.erase(numbers_.begin() + 100, numbers_.begin() + 150);
        const std::size_t from = count_++ * 37 % 1000;
        for (std::size_t i = from; i < from + 100; ++i)
            numbers_[i] += std::uniform_real_distribution(-1.0F, 1.0F)(random_);
        Bytes bytes(numbers_.size() * sizeof(float) + count_ % 4);
        std::memcpy(bytes.data(), numbers_.data(), numbers_.size() * sizeof(float));
        return bytes;
    }

  private:
    std::mt19937 random_{7};
    std::vector<float> numbers_ = std::vector<float>(6'000, 1.0F);
    std::size_t count_ = 0;
};

void expect_all(const Checkpoints& kept, const std::map<std::uint64_t, Bytes>& put) {
    for (auto at = put.begin(); at != put.end(); ++at) {
        const std::uint64_t tick = kept.tick_before(at->first);
        ASSERT_LE(tick, at->first);
        ASSERT_EQ(kept.bytes_before(at->first), put.at(tick)) << "of tick " << tick;
    }
}

TEST(Checkpoints, ReturnTheirStatesToTheBit) {
    Growing growing;
    Checkpoints kept(std::size_t{1} << 30U);
    std::map<std::uint64_t, Bytes> put;
    for (std::uint64_t tick = 5; tick < 400; tick += 10) {
        put[tick] = growing.next();
        kept.keep(tick, put[tick]);
    }
    EXPECT_EQ(kept.count(), put.size());
    EXPECT_EQ(kept.tick_before(204), 195U);
    EXPECT_EQ(kept.tick_before(205), 205U);
    EXPECT_LT(kept.bytes(), put.rbegin()->second.size() * put.size() / 8) << "equal parts are stored once";
    expect_all(kept, put);
}

TEST(Checkpoints, ThinOutEvenlyWhereTheRoomIsFull) {
    constexpr std::size_t kRoom = 120'000;
    Growing growing;
    Checkpoints kept(kRoom);
    std::map<std::uint64_t, Bytes> put;
    for (std::uint64_t tick = 0; tick < 1500; tick += 10) {
        put[tick] = growing.next();
        kept.keep(tick, put[tick]);
        ASSERT_LE(kept.bytes(), kRoom) << tick;
    }
    ASSERT_GT(kept.count(), 15U);
    ASSERT_LT(kept.count(), 100U);
    EXPECT_EQ(kept.tick_before(9), 0U) << "the first stays";
    EXPECT_EQ(kept.newest_tick(), 1490U);
    std::uint64_t farthest = 0;
    for (const auto& [tick, bytes] : put)
        farthest = std::max(farthest, tick - kept.tick_before(tick));
    EXPECT_LE(farthest, 4 * 1500 / kept.count());
    expect_all(kept, put);
}

TEST(Checkpoints, GoOnFromWhereTheyWereTakenBackTo) {
    Growing growing;
    Checkpoints kept(100'000);
    std::map<std::uint64_t, Bytes> put;
    for (const std::uint64_t back : {900U, 333U, 17U, 2U}) {
        for (std::uint64_t tick = put.empty() ? 0 : put.rbegin()->first + 1; tick < 1000; tick += 10) {
            put[tick] = growing.next();
            kept.keep(tick, put[tick]);
        }
        kept.forget_after(back);
        put.erase(put.upper_bound(kept.newest_tick()), put.end());
        ASSERT_LE(kept.newest_tick(), back);
        ASSERT_EQ(kept.bytes_before(5000), put.rbegin()->second);
        expect_all(kept, put);
    }
    kept.clear();
    EXPECT_EQ(kept.count(), 0U);
    EXPECT_EQ(kept.bytes(), 0U);
}

}  // namespace
}  // namespace onggi::haptic
