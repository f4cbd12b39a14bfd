// Compressed bytes are restored to the bit.
#include "game/record/packed_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <stdexcept>

namespace onggi::record {
namespace {

std::vector<std::byte> noise(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::byte> bytes(count);
    for (std::byte& byte : bytes)
        byte = static_cast<std::byte>(random() & 0xffU);
    return bytes;
}

TEST(PackedBytes, OfEverySizeComeBack) {
    constexpr std::size_t kChunk = std::size_t{64} << 10U;
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{7}, kChunk - 1, kChunk,
                                   kChunk + 1, 3 * kChunk, 3 * kChunk + 5}) {
        const auto bytes = noise(size, 1);
        for (const std::size_t like_size : {std::size_t{0}, size / 2, size, size + 9}) {
            const auto like = noise(like_size, 2);
            EXPECT_EQ(unpack(pack(bytes, like), like), bytes) << size << " like " << like_size;
        }
    }
}

TEST(PackedBytes, TakeTheRoomOfTheirDifferences) {
    const auto like = noise(1'000'000, 3);
    auto bytes = like;
    const auto other = noise(20'000, 4);
    std::copy(other.begin(), other.end(), bytes.begin() + 500'000);
    const PackedBytes packed = pack(bytes, like);
    EXPECT_LT(packed.deflated.size(), 25'000U);
    EXPECT_LE(packed.deflated.capacity(), packed.deflated.size() + 16);
    EXPECT_EQ(unpack(packed, like), bytes);
}

// A dent's row is moved as a whole when its mean goes into the radii. The bytes before the numbers are not a
// multiple of a word.
TEST(PackedBytes, TakeLittleRoomWhereAllNumbersMoved) {
    constexpr std::size_t kHead = 3;
    constexpr std::size_t kNumbers = 100'000;
    std::mt19937 random(6);
    std::vector<float> numbers(kNumbers);
    for (float& number : numbers)
        number = std::uniform_real_distribution(0.5F, 1.0F)(random);
    const auto with_head = [&] {
        auto bytes = noise(kHead, 7);
        const auto body = std::as_bytes(std::span(numbers));
        bytes.insert(bytes.end(), body.begin(), body.end());
        return bytes;
    };
    const auto like = with_head();
    for (float& number : numbers)
        number -= 0.037F;
    const auto bytes = with_head();
    const PackedBytes packed = pack(bytes, like);
    EXPECT_LT(packed.deflated.size(), kNumbers / 2) << "of " << bytes.size();
    EXPECT_EQ(unpack(packed, like), bytes);
}

TEST(PackedBytes, ThrowIfTheyAreTruncated) {
    const auto bytes = noise(100'000, 5);
    PackedBytes packed = pack(bytes, {});
    packed.deflated.resize(packed.deflated.size() / 2);
    EXPECT_THROW(static_cast<void>(unpack(packed, {})), std::runtime_error);
}

}  // namespace
}  // namespace onggi::record
