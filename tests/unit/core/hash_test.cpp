#include "engine/core/hash.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace onggi {
namespace {

TEST(StateHash, IsTheSameOnEveryMachineAndBuild) {
    StateHash hash;
    hash.add(std::array<float, 3>{1.0F, -0.0F, 60.0F});
    hash.add(4.0);
    // Computed independently from the definition; a change here makes every stored session unplayable.
    EXPECT_EQ(hash.value(), 0x6899f312ea2a3649ULL);
}

TEST(StateHash, TellsZeroFromMinusZeroAndLengthsApart) {
    const auto of = [](std::vector<float> values) {
        StateHash hash;
        hash.add(std::span<const float>(values));
        return hash.value();
    };
    EXPECT_NE(of({0.0F}), of({-0.0F}));
    EXPECT_NE(of({0.0F}), of({0.0F, 0.0F}));
    EXPECT_NE(of({1.0F, 2.0F}), of({2.0F, 1.0F}));
}

TEST(StateHash, ChangesWithEverySingleBit) {
    std::array<float, 5> values{};
    StateHash plain;
    plain.add(std::span<const float>(values));
    for (std::size_t bit = 0; bit < sizeof values * 8; ++bit) {
        std::array<float, 5> flipped = values;
        auto bytes = std::as_writable_bytes(std::span(flipped));
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
        StateHash hash;
        hash.add(std::span<const float>(flipped));
        EXPECT_NE(hash.value(), plain.value()) << "bit " << bit;
    }
}

}  // namespace
}  // namespace onggi
