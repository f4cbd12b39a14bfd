#include "engine/vk/timestamps.h"

#include <gtest/gtest.h>

namespace onggi::vk {
namespace {

TEST(TicksBetween, CountThroughTheClocksNewBeginning) {
    EXPECT_EQ(ticks_between(100, 140, 64), 40U);
    EXPECT_EQ(ticks_between(0xFFFF'FFF0, 0x10, 32), 0x20U);
    EXPECT_EQ(ticks_between(0xF'FFFF'FFFF, 0, 36), 1U) << "as Intel's clocks count";
    EXPECT_EQ(ticks_between(0xFFFF'FFFF'FFFF'FFFF, 1, 64), 2U);
}

TEST(TicksBetween, IgnoreInvalidBits) {
    EXPECT_EQ(ticks_between(0xABCD'0000'0000'0010, 0x1234'0000'0000'0030, 36), 0x20U);
}

}  // namespace
}  // namespace onggi::vk
