// Good pots (judge.h) by kind, with a table. The bounds hold over the kinds with which the hands were tuned, and
// over the reserved kinds, with which they were not. Writes a sheet a kind to
// build/<preset>/good_<kind>.png.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/places.h"
#include "tests/visitors/population.h"

namespace onggi::visitors {
namespace {

constexpr int kEach = 40;

// Reports with --gtest_filter=*: a row a kind.
class GoodPots : public ::testing::TestWithParam<int> {
  protected:
    static void throw_and_report() {
        const auto kind = static_cast<Kind>(GetParam());
        const auto all = throw_pots({.kind = kind, .count = getenv("EACH") ? atoi(getenv("EACH")) : kEach, .first_seed = 1001});
        fmt::print("{}\n", row_for(kind, all));
        if (getenv("WHY")) for (auto& l : all) if (!l.verdict.is_good) fmt::print("   % {} {} ; {:.0f} high {:.0f} ml\n", l.seed, l.verdict.why_not_good, l.verdict.height_mm, l.verdict.capacity_ml);
        EXPECT_TRUE(all_untouched(all)) << words_for(all);
        if (!getenv("EACH")) write_sheet(test::in_build(fmt::format("good_{}.png", GetParam())),
                    {{all.begin(), all.begin() + kEach / 2}, {all.begin() + kEach / 2, all.end()}});
    }
};

TEST_P(GoodPots, AreThrownByMostOfAKind) {
    throw_and_report();
}

std::string name_of(const ::testing::TestParamInfo<int>& info) {
    std::string name(kKindNames[static_cast<std::size_t>(info.param)]);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Open, GoodPots, ::testing::Range(0, kReservedFrom), name_of);
INSTANTIATE_TEST_SUITE_P(Reserved, GoodPots, ::testing::Range(kReservedFrom, kKindCount), name_of);

}  // namespace
}  // namespace onggi::visitors
