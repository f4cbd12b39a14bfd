#include "game/screens/force_trace.h"

#include <algorithm>

namespace onggi::screens {
namespace {

// A frame holds a whole number of ticks: over a single one the rate would tremble.
constexpr double kRateOverS = 0.25;
// A hand without a device that holds it back may press into the clay with tens of newtons.
constexpr std::array kSteps{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0};

}  // namespace

void ForceTrace::add(double time_s, double force_n, std::uint64_t ticks) {
    while (count_ > 0 && (count_ == kMost || at(0).time_s < time_s - kWindowS)) {
        first_ = (first_ + 1) % kMost;
        --count_;
    }
    double rate_hz = 0.0;
    for (std::size_t back = count_; back-- > 0;) {
        const Kept& before = kept(back);
        const double since_s = time_s - before.sample.time_s;
        if (since_s > 0.0 && ticks >= before.ticks)
            rate_hz = static_cast<double>(ticks - before.ticks) / since_s;
        if (since_s >= kRateOverS) break;
    }
    ring_[(first_ + count_) % kMost] = {{time_s, force_n, rate_hz}, ticks};
    ++count_;
    double most_n = 0.0;
    for (std::size_t place = 0; place < count_; ++place)
        most_n = std::max(most_n, at(place).force_n);
    full_n_ = kSteps.back();
    for (std::size_t step = kSteps.size(); step-- > 0;)
        if (most_n <= kSteps[step]) full_n_ = kSteps[step];
}

}  // namespace onggi::screens
