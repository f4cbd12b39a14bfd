#include "engine/render/pixels/shadow_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/render/pixels/wide_vectors.h"

namespace onggi::render {
namespace {

constexpr std::size_t kAcross = shaders::kMaskTexels;
using Row = std::array<float, kAcross>;

// A row of texels, where they lie on the ground; every loop over it is one the compiler makes vectors of.
struct Ground {
    Row x_mm;
    Row z_mm;
};

[[gnu::always_inline]] inline float smooth(float share) {
    const float s = std::clamp(share, 0.0F, 1.0F);
    return s * s * (3.0F - 2.0F * s);
}

// past_lathe() of the shader.
[[gnu::always_inline]] inline void shade_by_lathe(const shaders::FrameData& frame, const Ground& at,
                                                  Row& seen) {
    Row least;
    least.fill(1e3F);
    for (const vec4& step : frame.shadow_steps) {
        for (std::size_t i = 0; i < kAcross; ++i) {
            const float x = at.x_mm[i] + step.x;
            const float z = at.z_mm[i] + step.y;
            const float gap = (std::sqrt(x * x + z * z) - step.z) * step.w;
            least[i] = gap < least[i] ? gap : least[i];
        }
    }
    for (std::size_t i = 0; i < kAcross; ++i)
        seen[i] *= smooth(0.5F * least[i] + 0.5F);
}

// past_sphere() and sky_past_sphere() of the shader, for a ground that looks up.
[[gnu::always_inline]] inline void shade_by_sphere(const shaders::FrameData& frame, const vec4& sphere,
                                                   const Ground& at, Row& seen, Row& open) {
    const vec4 light = frame.key_direction;  // w: tangent of half its width
    const float square = sphere.w * sphere.w;
    for (std::size_t i = 0; i < kAcross; ++i) {
        const float x = sphere.x - at.x_mm[i];
        const float y = sphere.y;
        const float z = sphere.z - at.z_mm[i];
        const float distance2 = x * x + y * y + z * z;
        const float along = x * light.x + y * light.y + z * light.z;
        const float gap = std::sqrt(std::max(distance2 - along * along, 0.0F)) - sphere.w;
        const float width = std::max(along * light.w, 0.5F);
        const float past = smooth((gap + width) / (2.0F * width));
        seen[i] *= along > 0.0F ? past : 1.0F;
        const float nearness = 1.0F / std::sqrt(std::max(distance2, square));
        open[i] *= 1.0F - std::clamp(y * nearness, 0.0F, 1.0F) * square * nearness * nearness;
    }
}

// The shade about a foot, by how far from it.
float shade_of_foot(float from_foot_mm) {
    constexpr float kEndMm = 62.0F;
    constexpr float kFadeMm = 44.0F;
    if (from_foot_mm >= kEndMm) return 1.0F;
    const float shade = 0.55F * std::exp(-from_foot_mm * 0.09F) + 0.27F * std::exp(-from_foot_mm * 0.024F);
    return 1.0F - shade * smooth((kEndMm - from_foot_mm) / kFadeMm);
}

// Where the middles of a row's texels lie, from 0 to 1.
constexpr Row middles() {
    Row at{};
    for (std::size_t i = 0; i < kAcross; ++i)
        at[i] = (static_cast<float>(i) + 0.5F) / static_cast<float>(kAcross);
    return at;
}
constexpr Row kMiddles = middles();

// 0 at the mask's border, 1 a little inside.
[[gnu::always_inline]] inline float from_border(float at) {
    return std::min(at, 1.0F - at) * 8.0F;
}

[[gnu::always_inline]] inline std::uint32_t eight_bits(float share) {
    return static_cast<std::uint32_t>(static_cast<int>(std::clamp(share, 0.0F, 1.0F) * 255.0F + 0.5F));
}

[[gnu::always_inline]] inline void fill(const shaders::FrameData& frame, ShadowMask& mask) {
    const vec4 origin = frame.mask_origin;
    const vec4 axes = frame.mask_axes;
    const bool has_lathe = frame.lathe.x > 0.0F;
    for (std::size_t row = 0; row < kAcross; ++row) {
        const float v = kMiddles[row];
        Ground at;
        for (std::size_t i = 0; i < kAcross; ++i) {
            const float u = kMiddles[i];
            at.x_mm[i] = origin.x + u * axes.x + v * axes.z;
            at.z_mm[i] = origin.y + u * axes.y + v * axes.w;
        }
        Row seen;
        Row open;
        seen.fill(1.0F);
        open.fill(1.0F);
        for (const vec4& sphere : frame.spheres)
            shade_by_sphere(frame, sphere, at, seen, open);
        if (has_lathe) {
            shade_by_lathe(frame, at, seen);
            Row from_foot_mm;
            for (std::size_t i = 0; i < kAcross; ++i) {
                const float x = at.x_mm[i] - frame.lathe_foot.x;
                const float z = at.z_mm[i] - frame.lathe_foot.y;
                from_foot_mm[i] = std::max(std::sqrt(x * x + z * z) - frame.lathe.w, 0.0F);
            }
            for (std::size_t i = 0; i < kAcross; ++i)
                open[i] *= shade_of_foot(from_foot_mm[i]);
        }
        for (std::size_t i = 0; i < kAcross; ++i) {
            const float inside = smooth((std::min(from_border(kMiddles[i]), from_border(v)) - 0.1F) / 0.9F);
            mask[row * kAcross + i] = eight_bits(1.0F + (seen[i] - 1.0F) * inside) |
                                      (eight_bits(1.0F + (open[i] - 1.0F) * inside) << 16U);
        }
    }
}

void fill_plain(const shaders::FrameData& frame, ShadowMask& mask) {
    fill(frame, mask);
}

ONGGI_WIDE_VECTORS void fill_wide(const shaders::FrameData& frame, ShadowMask& mask) {
    fill(frame, mask);
}

std::uint32_t apart(std::uint32_t a, std::uint32_t b) {
    return a > b ? a - b : b - a;
}

}  // namespace

void fill_shadow_mask(const shaders::FrameData& frame, ShadowMask& mask) {
    static auto* const best = best_of(fill_plain, fill_wide);
    best(frame, mask);
}

void keep_what_is_alike(const ShadowMask& before, ShadowMask& now) {
    for (std::size_t i = 0; i < now.size(); ++i) {
        const std::uint32_t key = apart(before[i] & 0xFFFFU, now[i] & 0xFFFFU);
        const std::uint32_t sky = apart(before[i] >> 16U, now[i] >> 16U);
        now[i] = key <= 1 && sky <= 1 ? before[i] : now[i];
    }
}

}  // namespace onggi::render
