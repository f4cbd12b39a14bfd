#include "engine/sound/synthesiser.h"

#include <cmath>

namespace onggi::sound {
namespace {

// Larger values make no audible difference, and the sound must stay moderate in the hall.
constexpr double kFastestRevMin = 300.0;
constexpr double kHardestPressN = 6.0;
constexpr double kFastestSlipMmS = 2000.0;
constexpr double kSlapEndsS = 0.6;
constexpr double kPluckEndsS = 0.35;
constexpr double kChimeToneS = 0.4;  // one of three tones
constexpr double kChimeEndsS = 3.0 * kChimeToneS;

double bounded(double value, double least, double most) {
    return std::isfinite(value) ? std::clamp(value, least, most) : 0.0;
}

// A soft limiter: linear for small samples, below 1 for large ones, with a continuous slope.
double limited(double sample) {
    const double size = sample < 0.0 ? -sample : sample;
    return sample / (1.0 + size);
}

}  // namespace

Synthesiser::Wanted Synthesiser::wanted_of(const SoundScene& scene) noexcept {
    const double press_n = bounded(scene.contact_n, 0.0, kHardestPressN);
    return {.rev_min = bounded(scene.rev_min, 0.0, kFastestRevMin),
            .motor_load = bounded(scene.motor_load, 0.0, 1.0),
            // Compressed: about half as loud again for each doubling, so that a light touch is audible and a
            // hard one not too loud.
            .press = press_n / (press_n + 1.5),
            .slip = bounded(std::abs(scene.slip_mm_s), 0.0, kFastestSlipMmS),
            .wetness = bounded(scene.wetness, 0.0, 1.0),
            .hardness = scene.is_hard_tool ? 1.0 : 0.0,
            .place = bounded(scene.place, -1.0, 1.0),
            .fire = scene.fire_burns ? 1.0 : 0.0,
            .volume = bounded(scene.volume, 0.0, 1.0)};
}

// A belt-driven wheel: a hum that rises with the speed, its overtones under load, and the head's own turn in
// it.
double Synthesiser::motor() noexcept {
    const double rev_min = rev_min_.value();
    const double hum_hz = 28.0 + 0.42 * rev_min;
    const double load = motor_load_.value();
    // The level rises smoothly from rest: the motor is audible from a tenth of a turn per second.
    const double level = rev_min / (rev_min + 40.0);
    const double once_a_turn = sine_of_turns(turn_.step(rev_min / 60.0));
    const double hum = sine_of_turns(hum_.step(hum_hz));
    const double second = sine_of_turns(second_.step(2.0 * hum_hz));
    const double fifth = sine_of_turns(fifth_.step(5.0 * hum_hz));
    const double tone = 0.55 * hum + (0.3 + 0.25 * load) * second + (0.04 + 0.12 * load) * fifth;
    const double bearing = rumble_.step(noise_.next(), 90.0 + 1.2 * rev_min, 0.9).band;
    return level * (1.0 + 0.12 * once_a_turn) * (0.1 * tone + 0.05 * bearing);
}

// The work under the hand or the tool. Wet work sounds dull and slowly modulated, like water; dry work bright
// and even; a hard edge adds a scrape. More force is louder and slightly higher.
double Synthesiser::rub(double noise) noexcept {
    const double press = press_.value();
    const double slip = slip_.value();
    const double wet = wetness_.value();
    const double hard = hardness_.value();
    const double level = press * slip / (slip + 250.0);

    const double skin_hz = (260.0 + 500.0 * (1.0 - wet)) * (0.7 + 0.6 * press) + 0.5 * slip;
    const double slow = squelch_.step(noise, 5.0 + 0.01 * slip, 0.5).band * 40.0;
    const double coming_and_going = 1.0 + wet * 0.7 * std::clamp(slow, -1.0, 1.0);
    const double skin = skin_.step(noise, skin_hz, 0.9 - 0.3 * wet).band * coming_and_going;

    const double edge_hz = 2100.0 + 0.9 * slip + 900.0 * press;
    const double quick = chatter_.step(noise, 45.0 + 0.05 * slip, 0.4).band * 12.0;
    const double edge = edge_.step(noise, edge_hz, 0.45).band * (1.0 + 0.6 * std::clamp(quick, -1.0, 1.0));

    return level * ((1.0 - 0.6 * hard) * 1.2 * skin + hard * (0.36 - 0.16 * wet) * edge);
}

// A lump on the wheel head: a thump of falling pitch, and a noise burst.
double Synthesiser::slap(double noise) noexcept {
    const double age = std::min(slap_age_s_, kSlapEndsS);
    slap_age_s_ = age + 1.0 / kSampleRateHz;
    const double rise = std::min(age / 0.004, 1.0);
    const double left = 1.0 - age / kSlapEndsS;
    const double fall = left * left * left * left * left * left;  // flat where it ends
    // A slap during another one starts from its current loudness.
    const double loudness = slap_loudness_.towards(rise * rise * fall);
    if (loudness == 0.0) return 0.0;
    const double thump = sine_of_turns(thump_.step(58.0 + 60.0 * fall));
    const double splat = splat_.step(noise, 300.0 + 1500.0 * fall, 1.2).low;
    return loudness * (0.55 * thump + 0.35 * fall * splat);
}

// A taut string: bright at first, then lower as it gives way.
double Synthesiser::pluck() noexcept {
    const double age = std::min(pluck_age_s_, kPluckEndsS);
    pluck_age_s_ = age + 1.0 / kSampleRateHz;
    const double left = 1.0 - age / kPluckEndsS;
    const double fall = left * left * left;
    const double loudness = pluck_loudness_.towards(std::min(age / 0.003, 1.0) * fall);
    if (loudness == 0.0) return 0.0;
    const double pitch_hz = 330.0 + 110.0 * left;
    return loudness * (0.16 * sine_of_turns(string_.step(pitch_hz)) +
                       0.08 * fall * sine_of_turns(overtone_.step(2.76 * pitch_hz)));
}

// Fire behind a door: low-pass noise with irregular modulation.
double Synthesiser::fire(double noise) noexcept {
    const double level = fire_.value();
    if (level == 0.0) return 0.0;
    const double slow = std::clamp(flicker_.step(noise, 3.0, 0.5).band * 60.0, -1.0, 1.0);
    return level * (1.0 + 0.45 * slow) * roar_.step(noise, 140.0 + 50.0 * slow, 0.9).low;
}

// Left, right, then both, each with its own tone, to reveal a dead or swapped loudspeaker.
Sample Synthesiser::chime() noexcept {
    if (chime_age_s_ >= kChimeEndsS) return {};
    const int tone = chime_age_s_ < kChimeToneS ? 0 : chime_age_s_ < 2.0 * kChimeToneS ? 1 : 2;
    const double fraction = chime_age_s_ / kChimeToneS - tone;
    chime_age_s_ += 1.0 / kSampleRateHz;
    const double hill = 4.0 * fraction * (1.0 - fraction);  // zero value and slope at both ends
    const auto heard =
        static_cast<float>(0.25 * hill * hill * sine_of_turns(chime_.step(440.0 + 220.0 * tone)));
    return {.left = tone == 1 ? 0.0F : heard, .right = tone == 0 ? 0.0F : heard};
}

void Synthesiser::render(const SoundScene& scene, std::span<Sample> block) noexcept {
    const Wanted wanted = wanted_of(scene);
    if (scene.slaps != slaps_ && knows_slaps_) slap_age_s_ = 0.0;
    slaps_ = scene.slaps;
    knows_slaps_ = true;
    if (scene.is_plucked && !was_plucked_) pluck_age_s_ = 0.0;
    was_plucked_ = scene.is_plucked;
    if (scene.chimes != chimes_ && knows_chimes_) chime_age_s_ = 0.0;
    chimes_ = scene.chimes;
    knows_chimes_ = true;
    for (Sample& sample : block) {
        rev_min_.towards(wanted.rev_min);
        motor_load_.towards(wanted.motor_load);
        press_.towards(wanted.press);
        slip_.towards(wanted.slip);
        wetness_.towards(wanted.wetness);
        hardness_.towards(wanted.hardness);
        const double place = place_.towards(wanted.place);
        fire_.towards(wanted.fire);
        const double volume = volume_.towards(wanted.volume);

        const double noise = noise_.next();
        const double middle = motor() + slap(noise) + pluck() + fire(noise);
        const double side = rub(noise);
        const Sample test = chime();
        const auto out = [&](double wheel, float tone) {
            return static_cast<float>(limited(volume * (wheel + static_cast<double>(tone))));
        };
        sample.left = out(middle + side * (1.0 - 0.35 * place), test.left);
        sample.right = out(middle + side * (1.0 + 0.35 * place), test.right);
    }
}

}  // namespace onggi::sound
