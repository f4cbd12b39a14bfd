// The whole population: at least two hundred visitors of every kind, then with an aim twice as bad, and with
// half and two and a half times the clay. Writes a sheet of their pots to build/<preset>/visitors.png.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/places.h"
#include "tests/visitors/population.h"

namespace onggi::visitors {
namespace {

struct Expected {
    Kind kind;
    int count;
    double pots;           // fraction
    double pots_at_worse;  // fraction, with a worse aim or other clay
};
constexpr std::array kExpected{
    Expected{Kind::kLesson, 60, 0.97, 0.90},    Expected{Kind::kLeftHand, 15, 0.95, 0.90},
    Expected{Kind::kTopFirst, 25, 0.95, 0.90},  Expected{Kind::kOutsidePull, 25, 0.95, 0.90},
    Expected{Kind::kBowl, 30, 0.95, 0.90},      Expected{Kind::kVase, 30, 0.95, 0.90},
    Expected{Kind::kScribble, 25, 0.85, 0.90},  Expected{Kind::kLiftsOften, 20, 0.95, 0.80},
    Expected{Kind::kHoldsStill, 20, 0.95, 0.90}};

TEST(AllVisitors, LeavePotsOneWouldKeep) {
    std::vector<std::vector<Left>> sheet;
    for (const Expected& expected : kExpected) {
        const auto all = throw_pots({.kind = expected.kind, .count = expected.count});
        const auto name = kKindNames[static_cast<std::size_t>(expected.kind)];
        EXPECT_GE(fraction_of_pots(all), expected.pots) << name << "\n" << words_for(all);
        EXPECT_TRUE(all_untouched(all)) << name << "\n" << words_for(all);
        if (expected.kind == Kind::kLesson) {
            EXPECT_LE(median_made_s(all), 45.0);
        }
        if (!all.front().visit.drawn_mm.empty()) {
            EXPECT_GE(fraction_within_mm(all, 6.0), 0.95) << name;
            EXPECT_LE(median_rms_mm(all), 3.0) << name;
        }
        sheet.push_back(
            std::vector<Left>(all.begin(), all.begin() + std::min<std::ptrdiff_t>(20, std::ssize(all))));
    }
    write_sheet(test::in_build("visitors.png"), sheet);
}

void expect_pots(double mass_g, const Skill& skill) {
    constexpr int kEach = 20;
    for (const Expected& expected : kExpected) {
        const auto all = throw_pots(
            {.kind = expected.kind, .count = kEach, .first_seed = 200, .mass_g = mass_g, .skill = skill});
        EXPECT_GE(fraction_of_pots(all), expected.pots_at_worse)
            << kKindNames[static_cast<std::size_t>(expected.kind)] << "\n"
            << words_for(all);
        EXPECT_TRUE(all_untouched(all)) << words_for(all);
    }
}

TEST(AllVisitors, LeavePotsWithAnAimTwiceAsBad) {
    expect_pots(1000.0, {.aim_mm = 9.6, .wander_mm = 3.0});
}

TEST(AllVisitors, LeavePotsOfHalfTheClay) {
    expect_pots(500.0, {});
}

TEST(AllVisitors, LeavePotsOfTwoAndAHalfTimesTheClay) {
    expect_pots(2500.0, {});
}

}  // namespace
}  // namespace onggi::visitors
