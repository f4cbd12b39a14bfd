#include "engine/render/shapes/lathe_sectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace onggi::render {
namespace {

constexpr float kHalfTurn = std::numbers::pi_v<float>;

// A chord of a circle lies off it by r (1 - cos(half its angle)).
float angle_of_chord(float radius_px, float error_px) {
    // Light is interpolated between the vertices too, which bears no more.
    constexpr float kWidest = 18.0F * kHalfTurn / 180.0F;
    const float cosine = 1.0F - error_px / std::max(radius_px, 1e-3F);
    return cosine > 0.0F ? std::min(2.0F * std::acos(cosine), kWidest) : kWidest;
}

// How many sectors there are in a radian, by the angle from the line of sight.
float density(const LatheSeen& seen, float from_sight_rad, float error_px) {
    const float across = std::abs(std::sin(from_sight_rad));
    const float down = std::cos(from_sight_rad) * std::sin(seen.pitch_rad);
    // Walls that lean turn away up to some forty degrees before or behind a right angle.
    constexpr float kAtAll = 0.64F;  // sines
    constexpr float kWhole = 0.80F;
    const float fraction = std::clamp((across - kAtAll) / (kWhole - kAtAll), 0.0F, 1.0F);
    const float rim_px = seen.rim_px * std::hypot(across, down);
    return 1.0F / angle_of_chord(std::max(seen.widest_px * fraction, rim_px), error_px);
}

}  // namespace

std::vector<float> even_sectors(const Lathe& lathe, int sectors) {
    // A lathe's own sectors run the other way, counter-clockwise.
    const float start = lathe.cut ? kHalfTurn - lathe.cut->towards_rad : 0.0F;
    const float sweep = lathe.cut ? kHalfTurn : 2.0F * kHalfTurn;
    std::vector<float> angles;
    angles.reserve(static_cast<std::size_t>(sectors) + 1);
    for (int i = 0; i <= sectors; ++i)
        angles.push_back(start + sweep * static_cast<float>(i) / static_cast<float>(sectors));
    return angles;
}

std::vector<float> seen_sectors(const LatheSeen& seen, const SectorBudget& budget) {
    // The sum of the density up to each of some angles, over half a turn.
    constexpr std::size_t kSteps = 180;
    constexpr float kStep = kHalfTurn / static_cast<float>(kSteps);
    std::array<float, kSteps + 1> sum{};
    for (std::size_t i = 0; i < kSteps; ++i)
        sum[i + 1] = sum[i] + kStep * density(seen, (static_cast<float>(i) + 0.5F) * kStep, budget.error_px);
    // By twos, so that a pot that widens by a hair is not cut anew in every frame.
    constexpr int kFewest = 8;
    const int wanted = (static_cast<int>(std::ceil(sum[kSteps])) + 1) / 2 * 2;
    const int half = std::clamp(wanted, kFewest, std::max(budget.max_sectors / 2, kFewest));
    std::vector<float> to_side;
    to_side.reserve(static_cast<std::size_t>(half) + 1);
    std::size_t at = 0;
    for (int i = 0; i <= half; ++i) {
        const float fraction = sum[kSteps] * static_cast<float>(i) / static_cast<float>(half);
        while (at + 1 < kSteps && sum[at + 1] < fraction)
            ++at;
        const float within = (fraction - sum[at]) / (sum[at + 1] - sum[at]);
        to_side.push_back((static_cast<float>(at) + std::clamp(within, 0.0F, 1.0F)) * kStep);
    }
    std::vector<float> angles;
    angles.reserve(2 * static_cast<std::size_t>(half) + 1);
    for (const float angle : to_side)
        angles.push_back(seen.azimuth_rad + angle);
    for (int i = half; i-- > 0;)
        angles.push_back(seen.azimuth_rad + 2.0F * kHalfTurn - to_side[static_cast<std::size_t>(i)]);
    return angles;
}

}  // namespace onggi::render
