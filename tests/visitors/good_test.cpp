// Good pots (judge.h) by kind, with a table. The bounds hold over the kinds with which the hands were tuned, and
// over the reserved kinds, with which they were not. Writes a sheet of their pots to build/<preset>/good.png.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/places.h"
#include "tests/visitors/population.h"

namespace onggi::visitors {
namespace {

constexpr int kEach = 40;

// Throws the pots of the kinds [first, end) and prints their table. Returns them by kind.
std::vector<std::vector<Left>> throw_kinds(int first, int end) {
    std::vector<std::vector<Left>> all;
    fmt::print("{:14} {:>4} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>6}\n", "kind", "n", "pots", "good", "mean",
               "most", "ml", "mm", "s");
    for (int place = first; place < end; ++place) {
        const auto kind = static_cast<Kind>(place);
        all.push_back(throw_pots({.kind = kind, .count = kEach, .first_seed = 1001}));
        fmt::print("{}\n", row_for(kind, all.back()));
    }
    return all;
}

std::vector<std::vector<Left>> first_of_each(const std::vector<std::vector<Left>>& all) {
    std::vector<std::vector<Left>> rows;
    for (const auto& row : all)
        rows.emplace_back(row.begin(), row.begin() + 20);
    return rows;
}

TEST(GoodPots, AreThrownByTheKindsThatTheHandsWereTunedWith) {
    write_sheet(test::in_build("good.png"), first_of_each(throw_kinds(0, kReservedFrom)));
}

TEST(GoodPots, AreThrownByTheReservedKinds) {
    write_sheet(test::in_build("good_reserved.png"), first_of_each(throw_kinds(kReservedFrom, kKindCount)));
}

}  // namespace
}  // namespace onggi::visitors
