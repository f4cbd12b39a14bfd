#include "game/sharing/share_limits.h"

#include <gtest/gtest.h>

namespace onggi::sharing {
namespace {

constexpr RateRules kRules{.most_tokens = 10.0, .tokens_per_s = 2.0, .miss_costs = 4.0, .most_addresses = 64};

AddressKey someone(std::uint8_t a, std::uint8_t b = 0) {
    return key_of_ipv4({10, 0, b, a});
}

TEST(ShareLimits, GivesEachAddressItsShareAndNoMore) {
    ShareLimits limits(kRules);
    int granted = 0;
    for (int i = 0; i < 100; ++i)
        granted += limits.allows(someone(1), 5.0) ? 1 : 0;
    EXPECT_EQ(granted, 10);
    EXPECT_TRUE(limits.allows(someone(2), 5.0)) << "another's bucket is its own";
    EXPECT_FALSE(limits.allows(someone(1), 5.4));
    EXPECT_TRUE(limits.allows(someone(1), 5.6)) << "one token in half a second";
    EXPECT_FALSE(limits.allows(someone(1), 5.6));
    granted = 0;
    for (int i = 0; i < 100; ++i)
        granted += limits.allows(someone(1), 1000.0) ? 1 : 0;
    EXPECT_EQ(granted, 10) << "a bucket is never fuller than full";
}

TEST(ShareLimits, CountsAMissAsSeveralRequests) {
    ShareLimits limits(kRules);
    int guesses = 0;
    while (limits.allows(someone(1), 0.0)) {
        limits.missed(someone(1), 0.0);
        ++guesses;
    }
    EXPECT_EQ(guesses, 2);
}

TEST(ShareLimits, RememberNoMoreAddressesThanTheyMay) {
    ShareLimits limits(kRules);
    for (int b = 0; b < 200; ++b) {
        for (int a = 0; a < 200; ++a)
            ASSERT_TRUE(
                limits.allows(someone(static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)), b * 1e-3));
        ASSERT_LE(limits.addresses(), kRules.most_addresses);
    }
}

TEST(ShareLimits, ForgetIdleAddressesFirst) {
    ShareLimits limits(kRules);
    while (limits.allows(someone(1), 0.0)) {
    }
    // All other buckets are full again when space is needed.
    for (int a = 2; a < 64; ++a)
        ASSERT_TRUE(limits.allows(someone(static_cast<std::uint8_t>(a)), 0.0));
    for (int a = 64; a < 70; ++a)
        ASSERT_TRUE(limits.allows(someone(static_cast<std::uint8_t>(a)), 0.9));
    EXPECT_TRUE(limits.allows(someone(1), 0.9)) << "1.8 tokens";
    EXPECT_FALSE(limits.allows(someone(1), 0.9)) << "and not a new bucket of ten";
}

TEST(ShareLimits, TakeAHouseOfIpv6AsOneAndMappedIpv4AsItself) {
    const AddressKey one = key_of_ipv6({0xfd, 0, 0, 0, 0, 0, 0, 1, 9, 9, 9, 9, 9, 9, 9, 1});
    const AddressKey other = key_of_ipv6({0xfd, 0, 0, 0, 0, 0, 0, 1, 7, 7, 7, 7, 7, 7, 7, 2});
    const AddressKey far = key_of_ipv6({0xfd, 0, 0, 0, 0, 0, 0, 2, 9, 9, 9, 9, 9, 9, 9, 1});
    EXPECT_EQ(one, other);
    EXPECT_NE(one, far);
    EXPECT_EQ(key_of_ipv6({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 10, 0, 0, 7}), someone(7));
}

}  // namespace
}  // namespace onggi::sharing
