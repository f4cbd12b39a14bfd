// A clock that advances only on calls, for tests of waiting code. One thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace onggi::test {

class VirtualClock {
  public:
    [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }

    // Sleeps, and wakes `oversleep_ns` late, as kernels do. The next oversleep may be set for one sleep only.
    void sleep_until_ns(std::int64_t time_ns) noexcept {
        const std::int64_t wake_ns = std::max(now_ns_, time_ns + oversleep_ns + next_oversleep_ns_);
        next_oversleep_ns_ = 0;
        slept_ns += wake_ns - now_ns_;
        ++sleeps;
        now_ns_ = wake_ns;
    }
    void relax() noexcept {
        now_ns_ += kSpinStepNs;
        ++spins;
    }

    // Advances the clock by work of that duration.
    void pass(std::int64_t duration_ns) noexcept { now_ns_ += duration_ns; }
    void oversleep_once(std::int64_t by_ns) noexcept { next_oversleep_ns_ = by_ns; }

    static constexpr std::int64_t kSpinStepNs = 50;
    std::int64_t oversleep_ns = 0;
    std::int64_t slept_ns = 0;
    int sleeps = 0;
    int spins = 0;

  private:
    std::int64_t now_ns_ = 1'000'000'007;  // not a round number: nothing may rest on starting at zero
    std::int64_t next_oversleep_ns_ = 0;
};

}  // namespace onggi::test
