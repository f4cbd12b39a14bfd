// Synthesises the sound of a potter's wheel: motor, something wet under a hand, the scrape of a tool, a
// slapped lump, a fire. Pure: the same scenes in the same order give the same samples, whatever the block
// size. One thread at a time; no allocation, no lock, no libm.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <span>

namespace onggi::sound {

// The scene to synthesise, in physical terms; the main thread sets it once a frame. Plain values; any thread.
struct SoundScene {
    double rev_min = 0.0;     // of the wheel: actual speed, not the requested one; under load it sounds lower
    double motor_load = 0.0;  // 0 idle to 1 nearly stalled
    double contact_n = 0.0;   // normal force of the tool
    double slip_mm_s = 0.0;   // speed of the surface under the tool
    double wetness = 0.0;     // 0 leather-dry to 1 dripping
    bool is_hard_tool = false;  // true: scrapes; false: a hand or soft tool
    double place = 0.0;         // stereo position of the tool, -1 left to 1 right
    std::uint32_t slaps = 0;    // counts lumps thrown on the wheel; each increase sounds once
    bool is_plucked = false;    // a taut string gives way; sounds once at each change to true
    std::uint32_t chimes = 0;   // counts loudspeaker tests; each increase sounds left, right, then both
    bool fire_burns = false;    // a pot is fired: a low, unsteady roar
    double volume = 0.5;        // 0 silent to 1
};

// The building blocks of voices: smoothed parameters, noise, filters, a sine without libm. Pure; one thread
// at a time; only + - x / and comparisons, so that every machine computes the same samples. One step is one
// sample.

constexpr double kSampleRateHz = 48000.0;

// Follows its target with a time constant, because a jump would be audible as a click.
class Glide {
  public:
    explicit Glide(double seconds, double start = 0.0)
        : fraction_(1.0 / (1.0 + seconds * kSampleRateHz)),
          value_(start) {}

    double towards(double target) noexcept {
        value_ += fraction_ * (target - value_);
        // Flush tiny values to zero: arithmetic on denormal numbers is slow.
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

// The sine of a phase in turns, 0 to 1: two parabolas and a correction, with an error below 0.001. libm's
// sine may differ between machines in the last bit.
[[nodiscard]] inline double sine_of_turns(double turns) noexcept {
    const double x = turns < 0.5 ? 4.0 * turns - 1.0 : 4.0 * turns - 3.0;  // -1 to 1 over each half
    const double arch = 1.0 - x * x;
    const double sine = arch * (0.775 + 0.225 * arch);
    return turns < 0.5 ? sine : -sine;
}

// An oscillator's phase.
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
// sample rate; higher frequencies are clamped.
class Filter {
  public:
    struct Out {
        double low = 0.0;
        double band = 0.0;
        double high = 0.0;
    };
    // damping: 2 is no resonance, 0.2 a narrow band.
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

// Two channels, -1 to 1.
struct Sample {
    float left = 0.0F;
    float right = 0.0F;
};

class Synthesiser {
  public:
    // The next block at 48 kHz. Parameters move to the scene's values within some tens of ms, so nothing
    // clicks. Samples stay within +-1, and become exactly 0 some seconds after everything is at rest. Values
    // that are not finite count as 0.
    void render(const SoundScene& scene, std::span<Sample> block) noexcept;

  private:
    // The scene's values, clamped and finite.
    struct Wanted {
        double rev_min, motor_load, press, slip, wetness, hardness, place, fire, volume;
    };
    static Wanted wanted_of(const SoundScene& scene) noexcept;
    double motor() noexcept;
    double rub(double noise) noexcept;
    double slap(double noise) noexcept;
    double pluck() noexcept;
    double fire(double noise) noexcept;
    Sample chime() noexcept;

    Glide rev_min_{0.06};
    Glide motor_load_{0.08};
    Glide press_{0.03};
    Glide slip_{0.05};
    Glide wetness_{0.2};
    Glide hardness_{0.05};
    Glide place_{0.08};
    Glide fire_{0.25};
    Glide volume_{0.015};

    Noise noise_{0x6f6e6767U};
    Phase hum_, second_, fifth_, turn_;
    Filter rumble_;
    Filter skin_;     // the hand on the material
    Filter squelch_;  // its modulation
    Filter edge_;     // the scrape
    Filter chatter_;  // its modulation
    Filter roar_;     // the fire
    Filter flicker_;  // its modulation
    std::uint32_t slaps_ = 0;
    bool knows_slaps_ = false;
    double slap_age_s_ = 1e9;
    Glide slap_loudness_{0.001};
    Phase thump_;
    Filter splat_;
    bool was_plucked_ = false;
    double pluck_age_s_ = 1e9;
    Glide pluck_loudness_{0.001};
    Phase string_;
    Phase overtone_;
    std::uint32_t chimes_ = 0;
    bool knows_chimes_ = false;
    double chime_age_s_ = 1e9;
    Phase chime_;
};

}  // namespace onggi::sound
