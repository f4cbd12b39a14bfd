#include "engine/core/number_in.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace onggi {
namespace {

TEST(NumberIn, ParsesTheWholeTextOrFails) {
    EXPECT_EQ(number_in<int>("-17"), -17);
    EXPECT_EQ(number_in<int>("010"), 10);
    EXPECT_EQ(number_in<double>("1e-3"), 1e-3);
    EXPECT_EQ(number_in<std::uint64_t>("18446744073709551615"), UINT64_MAX);
    for (const char* text : {"", " 1", "1 ", "+1", "1x", "0x10", "1,5", "one"}) {
        EXPECT_FALSE(number_in<int>(text)) << text;
        EXPECT_FALSE(number_in<double>(text)) << text;
    }
    EXPECT_FALSE(number_in<int>("2147483648"));
    EXPECT_FALSE(number_in<std::uint64_t>("-1"));
    EXPECT_FALSE(number_in<double>("1e999"));
}

}  // namespace
}  // namespace onggi
