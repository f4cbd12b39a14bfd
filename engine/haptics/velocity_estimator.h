// Estimates the tool's velocity from quantised encoder positions. One thread at a time; some tens of ns, no
// allocation. mm, s.
//
// One step of 0.055 mm between two ticks at 4 kHz reads as 220 mm/s, and a viscous force of that shakes the
// hand. So the velocity is the slope over a window of the past: the longest one, up to 15 ms, over which a
// straight line from its oldest position to the newest passes every position between within one step. A tool
// at rest or in even motion gets the whole window and little noise; a tool that turns around gets a short
// window and little delay. Source: F. Janabi-Sharifi, V. Hayward and C.-S. J. Chen, "Discrete-time adaptive
// windowing for velocity estimation", IEEE Trans. on Control Systems Technology 8(6), 2000: first-order
// adaptive windowing, end-fit.
// Differs: at most 15 positions are kept, about one per ms if ticks come faster, so that a tick costs the
//   same at every rate.
#pragma once

#include <array>
#include <cstddef>

#include "engine/math/math.h"

namespace onggi::haptics {

class VelocityEstimator {
  public:
    static constexpr double kWindowS = 0.015;

    // step_mm: of the encoder; 0: negligible.
    explicit VelocityEstimator(double step_mm = 0.0);

    // Takes the next position, dt_s after the last. Returns the velocity in mm/s; zero at the first call. A
    // position that is not finite is ignored.
    dvec3 update(const dvec3& position_mm, double dt_s) noexcept;
    void restart() noexcept { count_ = 0; }

  private:
    static constexpr std::size_t kMost = 15;
    struct Sample {
        dvec3 position_mm{0.0};
        double time_s = 0.0;
    };

    double step_mm_;
    double now_s_ = 0.0;
    std::array<Sample, kMost> samples_{};
    std::size_t newest_ = 0;
    std::size_t count_ = 0;
    dvec3 velocity_mm_s_{0.0};
};

}  // namespace onggi::haptics
