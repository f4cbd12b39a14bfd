// What voices are made of: parameters that glide, noise, filters, a sine without libm. Pure; one thread at a
// time; only + - x / and comparisons, so that every machine makes the same samples. One step is one sample.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>

namespace onggi::sound {

constexpr double kSampleRateHz = 48000.0;

// Follows its target with a time constant: a parameter that jumps is heard as a click.
class Glide {
  public:
    explicit Glide(double seconds, double start = 0.0)
        : fraction_(1.0 / (1.0 + seconds * kSampleRateHz)),
          value_(start) {}

    double towards(double target) noexcept {
        value_ += fraction_ * (target - value_);
        // What is nearly nothing is nothing: arithmetic on denormal numbers is slow.
        if (value_ < 1e-9 && value_ > -1e-9) value_ = 0.0;
        return value_;
    }
    [[nodiscard]] double value() const noexcept { return value_; }

  private:
    double fraction_;
    double value_;
};

// White noise, -1 to 1, the same from the same seed everywhere (Marsaglia's xorshift32, J. Stat. Soft. 8(14),
// 2003).
class Noise {
  public:
    explicit Noise(std::uint32_t seed) : state_(seed) {}

    double next() noexcept {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 17U;
        state_ ^= state_ << 5U;
        return static_cast<double>(state_) * (2.0 / 4294967295.0) - 1.0;
    }

  private:
    std::uint32_t state_;
};

// The sine of a phase in turns, 0 to 1: two parabolas and their correction, within 0.001 of the true one. A
// machine's own sine may differ in its last bit from another's.
[[nodiscard]] inline double sine_of_turns(double turns) noexcept {
    const double x = turns < 0.5 ? 4.0 * turns - 1.0 : 4.0 * turns - 3.0;  // -1 to 1 over each half
    const double arch = 1.0 - x * x;
    const double sine = arch * (0.775 + 0.225 * arch);
    return turns < 0.5 ? sine : -sine;
}

// A phase that turns at a frequency.
class Phase {
  public:
    double step(double frequency_hz) noexcept {
        turns_ += frequency_hz / kSampleRateHz;
        turns_ -= turns_ >= 1.0 ? 1.0 : 0.0;
        return turns_;
    }

  private:
    double turns_ = 0.0;
};

// Low-pass, band-pass and high-pass at once (Chamberlin's state-variable filter). Stable below a sixth of the
// sample rate; a higher frequency is held there.
class Filter {
  public:
    struct Out {
        double low = 0.0;
        double band = 0.0;
        double high = 0.0;
    };
    // damping: 2 is no resonance at all, 0.2 a narrow band.
    Out step(double input, double frequency_hz, double damping) noexcept {
        const double turn =
            std::numbers::pi * std::clamp(frequency_hz, 1.0, kSampleRateHz / 6.5) / kSampleRateHz;
        const double tuning = 2.0 * (turn - turn * turn * turn / 6.0);  // 2 sin(turn), to the third power
        low_ += tuning * band_;
        const double high = input - low_ - damping * band_;
        band_ += tuning * high;
        if (band_ < 1e-15 && band_ > -1e-15) band_ = 0.0;
        if (low_ < 1e-15 && low_ > -1e-15) low_ = 0.0;
        return {.low = low_, .band = band_, .high = high};
    }

  private:
    double low_ = 0.0;
    double band_ = 0.0;
};

}  // namespace onggi::sound
