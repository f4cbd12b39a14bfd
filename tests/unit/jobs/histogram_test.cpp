#include "engine/jobs/histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace onggi::jobs {
namespace {

TEST(Histogram, IsEmptyAtFirst) {
    const Histogram histogram;
    EXPECT_EQ(histogram.count(), 0U);
    EXPECT_EQ(histogram.max(), 0U);
    EXPECT_EQ(histogram.percentile(0.5), 0U);
}

TEST(Histogram, IsExactForSmallValues) {
    Histogram histogram;
    for (int value = 1; value <= 60; ++value)
        histogram.record(value);
    EXPECT_EQ(histogram.percentile(0.5), 30U);
    EXPECT_EQ(histogram.percentile(0.999), 60U);
    EXPECT_EQ(histogram.max(), 60U);
}

TEST(Histogram, TellsAnySingleValueExactly) {
    for (std::int64_t value = 1; value < (std::int64_t{1} << 45); value = value * 3 + 1) {
        Histogram histogram;
        histogram.record(value);
        EXPECT_EQ(histogram.percentile(0.5), static_cast<std::uint64_t>(value));
    }
}

TEST(Histogram, IsWithinThreePercentAboveTheTruthAtEveryPercentile) {
    std::mt19937_64 random(7);
    std::lognormal_distribution<double> durations(std::log(400.0), 2.5);  // ns to s, as ticks and stalls are
    Histogram histogram;
    std::vector<std::uint64_t> all;
    for (int i = 0; i < 100'000; ++i) {
        const double duration = durations(random);
        all.push_back(static_cast<std::uint64_t>(duration));
        histogram.record(static_cast<std::int64_t>(duration));
    }
    std::sort(all.begin(), all.end());
    for (const double fraction : {0.01, 0.25, 0.5, 0.9, 0.99, 0.999, 0.9999, 1.0}) {
        const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(all.size()))) - 1;
        EXPECT_GE(histogram.percentile(fraction), all[rank]) << fraction;
        EXPECT_LE(static_cast<double>(histogram.percentile(fraction)),
                  static_cast<double>(all[rank]) * 33.0 / 32.0 + 1)
            << fraction;
    }
    EXPECT_EQ(histogram.max(), all.back());
}

TEST(Histogram, CountsValuesBeyondItsRangeInTheLastBucket) {
    Histogram histogram;
    histogram.record(5);
    histogram.record(std::int64_t{1} << 60);
    EXPECT_EQ(histogram.max(), std::uint64_t{1} << 60);
    EXPECT_EQ(histogram.percentile(0.5), 5U);
    EXPECT_GE(histogram.percentile(1.0), std::uint64_t{1} << 39);
}

TEST(Histogram, TakesANegativeDurationForZero) {
    Histogram histogram;
    histogram.record(-3);
    EXPECT_EQ(histogram.count(), 1U);
    EXPECT_EQ(histogram.max(), 0U);
}

}  // namespace
}  // namespace onggi::jobs
