#include "engine/render/pixels/shadow_mask.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "engine/math/float8.h"
#include "engine/math/wide_vectors.h"
#include "shaders/shadow.h"
#include "shaders/surface.h"

namespace onggi::render {
namespace {

constexpr std::size_t kAcross = shaders::kMaskTexels;
static_assert(kAcross % kFloat8 == 0);

// Eight texels' places on the ground.
struct Ground8 {
    Float8 x;
    Float8 z;
    float y = 0.0F;
};
struct Up {
    float x = 0.0F;
    float y = 1.0F;
    float z = 0.0F;
};

[[gnu::always_inline]] inline Int8 eight_bits(const Float8& fraction) {
    return float8::ints(float8::clamp(fraction, 0.0F, 1.0F) * 255.0F + 0.5F);
}

// As shaders/mask.frag.
[[gnu::always_inline]] inline Int8 texels(const shaders::FrameData& frame, const Float8& u, float v) {
    const vec4& origin = frame.mask_origin;
    const vec4& axes = frame.mask_axes;
    const Ground8 at{.x = origin.x + u * axes.x + v * axes.z, .z = origin.y + u * axes.y + v * axes.w};
    Float8 seen = Float8{} + 1.0F;
    Float8 open = seen;
    for (const vec4& sphere : frame.spheres) {
        seen *= shaders::past_sphere(sphere, frame.key_direction, frame.key_direction.w, at);
        open *= shaders::sky_past_sphere(sphere, at, Up{});
    }
    if (frame.lathe.x > 0.0F) {
        Float8 least = Float8{} + 1e3F;
        for (const vec4& step : frame.shadow_steps)
            least = float8::min(least, shaders::ground_gap(step, at.x, at.z));
        seen *= shaders::ground_lit(least);
        const Float8 x = at.x - frame.lathe_foot.x;
        const Float8 z = at.z - frame.lathe_foot.y;
        open *= shaders::ground_open(float8::max(float8::sqrt(x * x + z * z) - frame.lathe.w, 0.0F));
    }
    const Float8 inside = shaders::inside_mask(u, v);
    return eight_bits(float8::mix(1.0F, seen, inside)) | eight_bits(float8::mix(1.0F, open, inside)) << 16;
}

[[gnu::always_inline]] inline void fill(const shaders::FrameData& frame, ShadowMask& mask) {
    constexpr auto kSide = static_cast<float>(kAcross);
    for (std::size_t row = 0; row < kAcross; ++row) {
        const float v = (static_cast<float>(row) + 0.5F) / kSide;
        for (std::size_t i = 0; i < kAcross; i += kFloat8) {
            const Float8 u = (float8::floats(kFirst8 + static_cast<int>(i)) + 0.5F) / kSide;
            const Int8 found = texels(frame, u, v);
            std::memcpy(&mask[row * kAcross + i], &found, sizeof found);
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
