// Measures samples for tests: level, brightness and smoothness. Simple and slow.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "engine/sound/synthesiser.h"

namespace onggi::testing {

inline std::vector<double> left_of(std::span<const sound::Sample> samples) {
    std::vector<double> left;
    left.reserve(samples.size());
    for (const sound::Sample& sample : samples)
        left.push_back(static_cast<double>(sample.left));
    return left;
}

// dB of full scale.
inline double level_db(std::span<const double> samples) {
    double sum = 0.0;
    for (const double sample : samples)
        sum += sample * sample;
    return 10.0 * std::log10(sum / static_cast<double>(samples.size()) + 1e-18);
}

// The amplitude at one frequency (Goertzel's algorithm).
inline double amount_of(std::span<const double> samples, double frequency_hz) {
    const double turn = 2.0 * std::acos(-1.0) * frequency_hz / sound::kSampleRateHz;
    double before = 0.0;
    double last = 0.0;
    for (const double sample : samples) {
        const double now = sample + 2.0 * std::cos(turn) * last - before;
        before = last;
        last = now;
    }
    const double power = last * last + before * before - 2.0 * std::cos(turn) * last * before;
    return 2.0 * std::sqrt(std::max(power, 0.0)) / static_cast<double>(samples.size());
}

// Where the sound's power lies, Hz: the mean frequency between 20 and 10,000 Hz, a tone every 20 Hz.
inline double brightness_hz(std::span<const double> samples) {
    double weighted = 0.0;
    double all = 0.0;
    for (double frequency_hz = 20.0; frequency_hz < 10'000.0; frequency_hz += 20.0) {
        const double amount = amount_of(samples, frequency_hz);
        weighted += amount * amount * frequency_hz;
        all += amount * amount;
    }
    return weighted / all;
}

// The largest step from one sample to the next: a click is one that stands out.
inline double largest_step(std::span<const double> samples) {
    double largest = 0.0;
    for (std::size_t at = 1; at < samples.size(); ++at)
        largest = std::max(largest, std::abs(samples[at] - samples[at - 1]));
    return largest;
}

}  // namespace onggi::testing
