// What the light of vertices by the processor is made of, where that is the device: many side by side, and
// the sky's part of it. Inline, so that it becomes a part of whatever instructions its user is compiled for,
// and without branches, so that the compiler makes vectors of every loop. Any thread; pure. mm, pixels.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "engine/math/math.h"
#include "shaders/frame_data.h"

namespace onggi::render::lanes {

// Vertices that are lit side by side; every loop over them is one the compiler makes vectors of.
constexpr std::size_t kLanes = 64;
using Lanes = std::array<float, kLanes>;
struct Lanes3 {
    Lanes x;
    Lanes y;
    Lanes z;
};

// The vertices that some triangles need, in their order.
template <typename Index>
[[nodiscard]] std::vector<std::uint32_t> vertices_of(std::span<const Index> indices,
                                                     std::size_t vertex_count) {
    std::vector<std::uint8_t> is_used(vertex_count, 0);
    for (const Index index : indices)
        is_used[index] = 1;
    std::vector<std::uint32_t> used;
    used.reserve(vertex_count);
    for (std::size_t number = 0; number < vertex_count; ++number) {
        if (is_used[number] != 0) used.push_back(static_cast<std::uint32_t>(number));
    }
    return used;
}

[[gnu::always_inline]] inline float mixed(float a, float b, float share) {
    return a + (b - a) * share;
}

// e to a number that is not above 0: powers of two are put together from their bits, and what is left is a
// series of seven terms, wrong by less than 2e-5.
[[gnu::always_inline]] inline float exp_below_0(float number) {
    constexpr float kLeast = -87.0F;
    const float clamped = number > kLeast ? number : kLeast;
    const int twos = static_cast<int>(clamped * std::numbers::log2e_v<float>);
    const float t = clamped - static_cast<float>(twos) * std::numbers::ln2_v<float>;
    const float series =
        1.0F +
        t * (1.0F + t / 2.0F * (1.0F + t / 3.0F * (1.0F + t / 4.0F * (1.0F + t / 5.0F * (1.0F + t / 6.0F)))));
    return series * std::bit_cast<float>((twos + 127) << 23);
}

// sky_diffuse() of shaders/sky.glsl.
[[gnu::always_inline]] inline void light_softly(const shaders::FrameData& frame, const Lanes3& n, int channel,
                                                Lanes& into) {
    const auto term = [&](std::size_t number) { return frame.irradiance[number][channel]; };
    const std::array<float, 9> of{term(0), term(1), term(2), term(3), term(4),
                                  term(5), term(6), term(7), term(8)};
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = n.x[i];
        const float y = n.y[i];
        const float z = n.z[i];
        const float light = of[0] + of[1] * y + of[2] * z + of[3] * x + of[4] * (x * y) + of[5] * (y * z) +
                            of[6] * (3.0F * z * z - 1.0F) + of[7] * (x * z) + of[8] * (x * x - y * y);
        into[i] = std::max(light, 0.0F);
    }
}

// sky_radiance() of shaders/sky.glsl.
[[gnu::always_inline]] inline void mirror_sky(const shaders::FrameData& frame, const Lanes3& towards,
                                              const Lanes& roughness, std::array<Lanes, 3>& into) {
    for (int channel = 0; channel < 3; ++channel) {
        const float horizon = frame.sky_horizon[channel];
        const float zenith = frame.sky_zenith[channel];
        const float nadir = frame.sky_nadir[channel];
        Lanes& light = into[static_cast<std::size_t>(channel)];
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float height = std::min(std::abs(towards.y[i]), 1.0F);
            const float share = height * height * (3.0F - 2.0F * height);
            light[i] = mixed(horizon, towards.y[i] > 0.0F ? zenith : nadir, share);
        }
    }
    for (int panel = 0; panel < shaders::kPanels; ++panel) {
        const vec4 direction = frame.panel_direction[panel];
        const vec4 radiance = frame.panel_radiance[panel];
        const float sharpness = direction.w;
        Lanes weight;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float alpha = roughness[i] * roughness[i];
            const float blur = 2.0F / std::max(alpha * alpha, 1e-4F);
            const float soft = sharpness * blur / (sharpness + blur);
            const float cosine =
                direction.x * towards.x[i] + direction.y * towards.y[i] + direction.z * towards.z[i];
            weight[i] = soft / sharpness * exp_below_0(soft * (std::min(cosine, 1.0F) - 1.0F));
        }
        for (int channel = 0; channel < 3; ++channel) {
            const float of = radiance[channel];
            Lanes& light = into[static_cast<std::size_t>(channel)];
            for (std::size_t i = 0; i < kLanes; ++i)
                light[i] += of * weight[i];
        }
    }
}

// In the steps that a device has between two pixels, so that a shape covers the same ones as if it drew it.
[[gnu::always_inline]] inline float in_steps(float px) {
    constexpr float kSteps = 256.0F;
    constexpr float kFarPx = 16384.0F;  // beyond any picture; twice as much in steps is a whole number yet
    const float from_far = std::min(std::max(px + kFarPx, 0.0F), 2.0F * kFarPx);
    return static_cast<float>(static_cast<int>(from_far * kSteps + 0.5F)) / kSteps - kFarPx;
}

struct Corners3 {
    Lanes3 at;  // px, and depth
    Lanes away_mm;
};

[[gnu::always_inline]] inline void project(const shaders::FrameData& frame, const Lanes3& place,
                                           Corners3& corners) {
    const mat4& matrix = frame.view_projection;
    const vec2 half = 0.5F * vec2(frame.picture);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float px = place.x[i];
        const float py = place.y[i];
        const float pz = place.z[i];
        const float x = matrix[0][0] * px + matrix[1][0] * py + matrix[2][0] * pz + matrix[3][0];
        const float y = matrix[0][1] * px + matrix[1][1] * py + matrix[2][1] * pz + matrix[3][1];
        const float z = matrix[0][2] * px + matrix[1][2] * py + matrix[2][2] * pz + matrix[3][2];
        const float w = matrix[0][3] * px + matrix[1][3] * py + matrix[2][3] * pz + matrix[3][3];
        const bool is_before = w > 0.0F && z >= 0.0F;  // the nearest plane
        const float share = 1.0F / (is_before ? w : 1.0F);
        corners.at.x[i] = in_steps(half.x * (x * share + 1.0F));
        corners.at.y[i] = in_steps(half.y * (y * share + 1.0F));
        corners.at.z[i] = z * share;
        corners.away_mm[i] = is_before ? w : 0.0F;
    }
}

}  // namespace onggi::render::lanes
