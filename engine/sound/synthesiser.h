// The sound of a potter's wheel out of nothing: motor, something wet under a hand, the scrape of a tool, a
// lump slapped down, a fire. Pure: the same scenes in the same order give the same samples, however they are
// cut into blocks. One thread at a time; no allocation, no lock, no libm.
#pragma once

#include <cstdint>
#include <span>

#include "engine/sound/sound_scene.h"
#include "engine/sound/voice_parts.h"

namespace onggi::sound {

// Two channels, -1 to 1.
struct Sample {
    float left = 0.0F;
    float right = 0.0F;
};

class Synthesiser {
  public:
    // The next block at 48 kHz. What the scene says is glided to, over some tens of ms: nothing clicks. Never
    // beyond +-1; exactly silent some seconds after everything has come to rest. What is not finite in a
    // scene counts as nothing.
    void render(const SoundScene& scene, std::span<Sample> block) noexcept;

  private:
    // The scene as the voices use it: bounded, and free of what is no number.
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
    Filter skin_;     // the hand on what turns
    Filter squelch_;  // how it comes and goes
    Filter edge_;     // the scrape
    Filter chatter_;  // how that comes and goes
    Filter roar_;     // the fire
    Filter flicker_;  // how it comes and goes
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
