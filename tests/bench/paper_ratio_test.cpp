// The tick's cost depends on the contact, not on the number of elements: tests its ratio to the scan. Only in
// Release builds. The best of several rounds counts, because a busy machine can only make a round slower.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/bench/paper_tick_case.h"

namespace onggi::bench {
namespace {

constexpr int kRounds = 10;

// The median time of a tick, which single interruptions do not change.
double median_s(PaperTickCase& wall, double (PaperTickCase::*tick)(), int ticks) {
    std::vector<double> times_s;
    for (int i = 0; i < ticks; ++i)
        times_s.push_back((wall.*tick)());
    const auto middle = times_s.begin() + ticks / 2;
    std::nth_element(times_s.begin(), middle, times_s.end());
    return *middle;
}

double best_ratio(int element_count, double tool_radius_mm, int ticks) {
    PaperTickCase wall(element_count, tool_radius_mm);
    EXPECT_TRUE(wall.both_agree());
    double best = 0.0;
    for (int round = 0; round < kRounds; ++round) {
        const double clay_s = median_s(wall, &PaperTickCase::tick_clay, ticks);
        const double scan_s = median_s(wall, &PaperTickCase::tick_scan, ticks);
        best = std::max(best, scan_s / clay_s);
    }
    std::printf("%d elements, tool of %g mm: %.1f times faster\n", element_count, tool_radius_mm, best);
    return best;
}

TEST(PaperTick, IsTwelveTimesFasterThanTheScanAtTheSizeOfThePaper) {
    EXPECT_GE(best_ratio(2000, 5.0, 2000), 12.0);
}

TEST(PaperTick, IsThirtyTimesFasterThanTheScanWithTwoHundredThousandElements) {
    EXPECT_GE(best_ratio(200000, 5.0, 100), 30.0);
    EXPECT_GE(best_ratio(200000, 20.0, 100), 30.0);
}

}  // namespace
}  // namespace onggi::bench
