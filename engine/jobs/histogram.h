// A histogram of durations with a fixed size: log-linear buckets, exact below 64, within 1/32 (3 %) above.
// One thread at a time. record() is a few ns, without allocation; fit for the tick.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace onggi::jobs {

class Histogram {
  public:
    // Negative values count as zero.
    void record(std::int64_t value) noexcept {
        const auto positive = static_cast<std::uint64_t>(std::max<std::int64_t>(value, 0));
        ++buckets_[bucket_of(positive)];
        ++count_;
        max_ = std::max(max_, positive);
    }

    [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
    [[nodiscard]] std::uint64_t max() const noexcept { return max_; }

    // The value that a `fraction` (0 < fraction <= 1) of the values do not exceed. Returns the bucket's upper
    // edge, at most 3 % too large and at most the largest value seen. 0 while empty.
    [[nodiscard]] std::uint64_t percentile(double fraction) const noexcept {
        if (count_ == 0) return 0;
        const double wanted = fraction * static_cast<double>(count_);
        std::uint64_t seen = 0;
        for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
            seen += buckets_[bucket];
            if (static_cast<double>(seen) < wanted || seen == 0) continue;
            return bucket + 1 == buckets_.size() ? max_ : std::min(upper_edge(bucket), max_);
        }
        return max_;
    }

  private:
    static constexpr unsigned kSubBits = 5;  // 32 buckets per octave
    static constexpr std::uint64_t kSubBuckets = 1U << kSubBits;
    static constexpr std::uint64_t kExact = 2 * kSubBuckets;
    static constexpr unsigned kMaxBits = 40;  // 2^40 ns are 18 minutes; larger values go into the last bucket
    static constexpr std::size_t kBuckets = kExact + (kMaxBits - kSubBits - 1) * kSubBuckets;

    static std::size_t bucket_of(std::uint64_t value) noexcept {
        if (value < kExact) return value;
        const auto shift = static_cast<unsigned>(std::bit_width(value)) - kSubBits - 1;
        const std::uint64_t bucket = shift * kSubBuckets + (value >> shift);
        return std::min<std::size_t>(bucket, kBuckets - 1);
    }

    // The largest value of a bucket: the inverse of bucket_of.
    static std::uint64_t upper_edge(std::size_t bucket) noexcept {
        if (bucket < kExact) return bucket;
        const std::uint64_t shift = bucket / kSubBuckets - 1;
        const std::uint64_t mantissa = bucket - shift * kSubBuckets;
        return ((mantissa + 1) << shift) - 1;
    }

    std::array<std::uint64_t, kBuckets> buckets_{};
    std::uint64_t count_ = 0;
    std::uint64_t max_ = 0;
};

}  // namespace onggi::jobs
