// A few visitors of every kind, in every check.
#include <gtest/gtest.h>

#include "tests/visitors/population.h"

namespace onggi::visitors {
namespace {

constexpr int kEach = 3;

class FewVisitors : public ::testing::TestWithParam<int> {};

TEST_P(FewVisitors, LeavePotsThatStandAndHoldWater) {
    const auto all = throw_pots({.kind = static_cast<Kind>(GetParam()), .count = kEach, .first_seed = 41});
    EXPECT_EQ(fraction_of_pots(all), 1.0) << words_for(all);
    EXPECT_TRUE(all_untouched(all)) << words_for(all);
    for (const Left& left : all)
        EXPECT_EQ(left.ledger_error_mm3, 0.0);
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, FewVisitors, ::testing::Range(0, kEarlierKinds));

}  // namespace
}  // namespace onggi::visitors
