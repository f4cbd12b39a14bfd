// Vertex processing for the CPU backend, eight vertices at a time: projection, and the sky's part of their
// light. Inline, so that the code is compiled for its caller's instruction set. Any thread; pure. mm, pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/float8.h"
#include "engine/math/math.h"
#include "shaders/frame_data.h"
#include "shaders/sky.h"

namespace onggi::render {

// Returns the vertices that some triangles use, in ascending order.
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

[[gnu::always_inline]] inline Float8 dot(const Float8x3& a, const Float8x3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline Float8 dot(const Float8x3& a, const vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline Float8x3 scaled(const Float8x3& a, const Float8& by) {
    return {a.x * by, a.y * by, a.z * by};
}
[[gnu::always_inline]] inline Float8x3 normalised(const Float8x3& a) {
    return scaled(a, float8::inversesqrt(dot(a, a)));
}
// Reflects the direction to the eye at a surface with normal n.
[[gnu::always_inline]] inline Float8x3 mirrored(const Float8x3& n, const Float8x3& v) {
    const Float8 twice = 2.0F * dot(n, v);
    return {twice * n.x - v.x, twice * n.y - v.y, twice * n.z - v.z};
}
[[gnu::always_inline]] inline Float8x3 towards(const vec3& eye, const Float8x3& from) {
    return normalised({eye.x - from.x, eye.y - from.y, eye.z - from.z});
}

using Colour8 = std::array<Float8, 3>;

// The sky's light that a white surface facing n reflects diffusely.
[[gnu::always_inline]] inline void find_sky_diffuse(const shaders::FrameData& frame, const Float8x3& n,
                                                    Colour8& into) {
    for (int channel = 0; channel < 3; ++channel) {
        const auto of = [&](std::size_t number) { return frame.irradiance[number][channel]; };
        into[static_cast<std::size_t>(channel)] =
            shaders::sky_sum(of(0), of(1), of(2), of(3), of(4), of(5), of(6), of(7), of(8), n.x, n.y, n.z);
    }
}

// Radiance of the sky from a direction, blurred by a surface of this roughness.
template <typename Roughness>
[[gnu::always_inline]] inline void find_sky_radiance(const shaders::FrameData& frame, const Float8x3& d,
                                                     const Roughness& roughness, Colour8& into) {
    const Float8 height = shaders::sky_height(d.y);
    for (int channel = 0; channel < 3; ++channel) {
        const Float8 end = float8::select(d.y > 0.0F, frame.sky_zenith[channel], frame.sky_nadir[channel]);
        into[static_cast<std::size_t>(channel)] = float8::mix(frame.sky_horizon[channel], end, height);
    }
    for (int panel = 0; panel < shaders::kPanels; ++panel) {
        const vec4& direction = frame.panel_direction[panel];
        const auto soft = shaders::panel_seen_through(direction.w, roughness);
        const Float8 fraction =
            shaders::panel_fraction(direction.w, soft, float8::min(dot(d, vec3(direction)), 1.0F));
        for (int channel = 0; channel < 3; ++channel)
            into[static_cast<std::size_t>(channel)] += frame.panel_radiance[panel][channel] * fraction;
    }
}

// Rounds to a device's sub-pixel steps, so that shapes cover the same pixels as if the device drew them.
[[gnu::always_inline]] inline auto in_steps(const auto& px) {
    constexpr float kSteps = 256.0F;
    constexpr float kFarPx = 16384.0F;  // beyond any picture; twice this, in steps, is still an exact integer
    const auto from_far = float8::clamp(px + kFarPx, 0.0F, 2.0F * kFarPx);
    return float8::floats(float8::ints(from_far * kSteps + 0.5F)) / kSteps - kFarPx;
}

struct Placed8 {
    Float8x3 at;  // px, and depth
    Float8 away_mm;
};

[[gnu::always_inline]] inline Placed8 project(const shaders::FrameData& frame, const Float8x3& p) {
    const mat4& matrix = frame.view_projection;
    const vec2 half = 0.5F * vec2(frame.picture);
    const auto row = [&](int i) __attribute__((always_inline)) {
        return matrix[0][i] * p.x + matrix[1][i] * p.y + matrix[2][i] * p.z + matrix[3][i];
    };
    const Float8 z = row(2);
    const Float8 w = row(3);
    const Int8 is_before = (w > 0.0F) & (z >= 0.0F);  // beyond the near plane
    const Float8 fraction = 1.0F / float8::select(is_before, w, 1.0F);
    return {.at = {in_steps(half.x * (row(0) * fraction + 1.0F)),
                   in_steps(half.y * (row(1) * fraction + 1.0F)), z * fraction},
            .away_mm = float8::select(is_before, w, 0.0F)};
}

}  // namespace onggi::render
