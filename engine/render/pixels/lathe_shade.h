// Shades queued pixels of the lathe for the CPU backend, eight at a time, with the formulas of
// shaders/lathe.h. Inline, so that the code is compiled for its caller's instruction set. Any thread; pure.
// Pixels, mm.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "engine/render/pixels/encode8.h"
#include "engine/render/pixels/lathe_pixels.h"
#include "engine/render/shapes/detail_texture.h"
#include "shaders/lathe.h"
#include "shaders/load.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render::shading {

namespace value = lathe_value;
using float8::floats;
using float8::ints;
using float8::looked_up;
using float8::max;

// Variants of the shading; a draw uses one.
enum class Pot { kPlain, kNearSpheres, kWithLoad, kMarked };

// Additional values of pixels that show the load: the screen-space derivatives of the load and of the
// position along the hatch in mm.
constexpr std::size_t kLoadWidth = value::kDepth;
constexpr std::size_t kHatchWidth = kLoadWidth + 1;

// Pixels waiting to be shaded, from any number of triangles: most rows of a triangle are narrower than a
// block.
struct Queue {
    static constexpr std::size_t kMost = 128;
    std::size_t count = 0;
    alignas(32) std::array<std::array<float, kMost>, kHatchWidth + 1> values;
    std::array<std::int32_t, kMost>
        at;  // index in the picture, with the streaks' level in the upper bits; negative: occluded

    [[nodiscard]] bool is_full() const { return count + kFloat8 > kMost; }
};

// The streaks' level is stored above the pixel's index.
constexpr int kLevelShift = 28;
static_assert(kStreakLevels <= 1 << (31 - kLevelShift));

// Eight queued pixels.
struct Pixels {
    const Queue& queue;
    std::size_t first;

    [[gnu::always_inline]] [[nodiscard]] Float8 operator[](std::size_t number) const {
        Float8 values;
        std::memcpy(&values, queue.values[number].data() + first, sizeof values);
        return values;
    }
    [[gnu::always_inline]] [[nodiscard]] Int8 streak_level() const {
        Int8 places;
        std::memcpy(&places, queue.at.data() + first, sizeof places);
        return (places >> kLevelShift) & (kStreakLevels - 1);
    }
    [[gnu::always_inline]] [[nodiscard]] Float8x3 three(std::size_t number) const {
        return {(*this)[number], (*this)[number + 1], (*this)[number + 2]};
    }
};

// The streaks' texture at a pixel, 0 to 1.
struct Streaks {
    Float8 tone;
    Float8 lean_round;
    Float8 lean_up;
    Float8 film;
};
[[gnu::always_inline]] inline Streaks streaks_at(const LatheLook& look, const Pixels& own) {
    const Float8 away = 1.0F / own[value::kNear];
    const Int8 across = ints(own[value::kStreak] * away) & (look.streak_size.across - 1);
    const Int8 up = ints(own[value::kStreak + 1] * away) & (look.streak_size.up - 1);
    const Int8 row = own.streak_level() * look.streak_size.up + up;
    const Int8 texel = looked_up(look.streaks.data(), row * look.streak_size.across + across);
    constexpr float kOneOver255 = 1.0F / 255.0F;
    const auto byte = [&](int shift) __attribute__((always_inline)) {
        return floats((texel >> shift) & 255) * kOneOver255;
    };
    return {byte(0), byte(8), byte(16), byte(24)};
}

// The marks at a pixel.
struct Painted {
    Float8x3 roots;  // square roots of light
    Float8 cover;
    Float8 lean_round;  // counter-clockwise from above
    Float8 lean_up;
};
// Bilinear; there are no marks beyond the end of the outside.
[[gnu::always_inline]] inline Painted painted_at(const LatheLook& look, const Pixels& own) {
    const vec4& marks = look.draw.marks;
    const Float8 away = 1.0F / own[value::kNear];
    // Streak coordinates run clockwise from above, two texture widths per turn, plus a positive offset.
    const float columns_a_texel =
        -0.5F * static_cast<float>(kMarkColumns) / static_cast<float>(look.streak_size.across);
    constexpr float kNotBelow0 = kMarkColumns * 8.0F;
    const Float8 across = own[value::kStreak] * away * columns_a_texel + (kNotBelow0 - 0.5F);
    const Float8 up = float8::clamp(own[value::kPlace + 1] * marks.x - 0.5F, 0.0F, kMarkRows - 1.0F);
    const Int8 left = ints(across);
    const Int8 low = ints(up);
    const Float8 to_right = across - floats(left);
    const Float8 to_high = up - floats(low);
    const auto* const words = reinterpret_cast<const std::uint32_t*>(look.marks.data());
    constexpr float kOneOver255 = 1.0F / 255.0F;
    const auto byte = [&](const Int8& word, int shift) __attribute__((always_inline)) {
        return floats((word >> shift) & 255) * kOneOver255;
    };
    Painted found{};
    const auto add = [&](int step_across, int step_up, const Float8& weight) __attribute__((always_inline)) {
        const Int8 column = (left + step_across) & (kMarkColumns - 1);
        const Int8 next = low + step_up;
        const Int8 row = next - ((next >= kMarkRows) & 1);
        const Int8 at = (row * kMarkColumns + column) * 2;
        const Int8 colour = looked_up(words, at);
        const Int8 lean = looked_up(words, at + 1);
        const Float8 cover = byte(colour, 24) * weight;
        found.roots.x += byte(colour, 0) * cover;
        found.roots.y += byte(colour, 8) * cover;
        found.roots.z += byte(colour, 16) * cover;
        found.cover += cover;
        found.lean_round += byte(lean, 0) * weight;
        found.lean_up += byte(lean, 8) * weight;
    };
    add(0, 0, (1.0F - to_right) * (1.0F - to_high));
    add(1, 0, to_right * (1.0F - to_high));
    add(0, 1, (1.0F - to_right) * to_high);
    add(1, 1, to_right * to_high);
    const Float8 one_over = 1.0F / max(found.cover, 1e-4F);
    const float along_a_texel = shaders::kStreakMm / static_cast<float>(look.streak_size.up);
    const Float8 along = own[value::kStreak + 1] * away * along_a_texel;
    const Float8 is_outside = float8::select(along > marks.y, 0.0F, 1.0F);
    return {.roots = {found.roots.x * one_over, found.roots.y * one_over, found.roots.z * one_over},
            .cover = found.cover * is_outside,
            .lean_round = shaders::lathe_mark_lean(found.lean_round, marks.w) * is_outside,
            .lean_up = shaders::lathe_mark_lean(found.lean_up, marks.w) * is_outside};
}

// The wall's normal, not normalised: the outline's normal, tilted by dents, streaks and marks.
template <Pot kPot>
[[gnu::always_inline]] inline Float8x3 normal_at(const LatheLook& look, const Pixels& own,
                                                 const Streaks& streaks, const Painted& painted) {
    const Int8 place = ints(float8::clamp(own[value::kNormal], 0.0F, shaders::kProfileTexels - 1.0F));
    const Int8 word = looked_up(look.normals.data(), place);
    constexpr float kTwice = 2.0F / 65535.0F;
    const Float8 across = floats(word & 0xFFFF) * kTwice - 1.0F;
    const Float8 upward = floats((word >> 16) & 0xFFFF) * kTwice - 1.0F;
    Float8 round = shaders::lathe_lean(look.draw.dry.w, streaks.lean_round);
    Float8 up = shaders::lathe_lean(look.draw.dry.w, streaks.lean_up);
    if constexpr (kPot == Pot::kMarked) {
        round -= painted.lean_round;
        up += painted.lean_up;
    }
    const Float8 out_x = own[value::kOutward];
    const Float8 out_z = own[value::kOutward + 1];
    return {across * out_x - round * out_z, upward - across * own[value::kLean] + up,
            across * out_z + round * out_x};
}

template <Pot kPot>
[[gnu::always_inline]] inline Float8 key_seen(const LatheLook& look, const Pixels& own) {
    Float8 seen = own[value::kSeen];
    if constexpr (kPot == Pot::kPlain) return seen;
    const Float8x3 place = own.three(value::kPlace);
    for (const vec4& sphere : look.frame.spheres)
        seen *= shaders::past_sphere(sphere, look.frame.key_direction, look.frame.key_direction.w, place);
    return seen;
}

// Weights of the light that goes to the eye: key light reflected diffusely, key light reflected specularly,
// sky light reflected specularly; and the brightness of the body.
struct Fractions {
    Float8 body;
    Float8 gloss;
    Float8 mirror;
    Float8 tone;
};

template <Pot kPot>
[[gnu::always_inline]] inline Fractions fractions_at(const LatheLook& look, const Pixels& own,
                                                     const Painted& painted) {
    const shaders::LatheDraw& draw = look.draw;
    const Streaks streaks = streaks_at(look, own);
    const Float8x3 n = normal_at<kPot>(look, own, streaks, painted);
    const Float8 one_over_n = float8::inversesqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    const Float8x3 v = own.three(value::kToEye);
    const vec3 key(look.frame.key_direction);
    const Float8 n_l = (n.x * key.x + n.y * key.y + n.z * key.z) * one_over_n;
    const Float8 n_v = max((n.x * v.x + n.y * v.y + n.z * v.z) * one_over_n, 0.05F);
    const Float8 l_v = v.x * key.x + v.y * key.y + v.z * key.z;
    const Float8 seen = key_seen<kPot>(look, own);

    const Float8 s = shaders::fujii_s(l_v, n_l, n_v);
    const Float8 t = shaders::fujii_t(s, n_l, n_v);
    const Float8 half = kPot == Pot::kWithLoad ? shaders::half_of(l_v) : own[value::kHalf];
    const Float8 n_h = max((n_v + n_l) * half, 0.0F);
    const Float8 light_l = max(n_l, 0.0F);
    const Float8 water = own[value::kWater];
    const Float8 film = shaders::lathe_film(own[value::kFilm], streaks.film, draw.gloss.w);
    const Float8 roughness = shaders::lathe_roughness(draw.gloss.x, draw.gloss.y, water);
    const Float8 body_under = shaders::ggx_under(n_h, n_v, light_l, roughness);
    const Float8 sheen_under = shaders::ggx_under(n_h, n_v, light_l, draw.gloss.z);
    const Float8 body_sheen = body_under * sheen_under;
    const Float8 fraction = 1.0F / (body_sheen * t);
    const Float8 rough = shaders::lathe_rough(water);
    const Float8 lit = shaders::lathe_lit(shaders::soft_cosine(n_l, draw.wet.w, draw.turn.w), rough, s,
                                          body_sheen, fraction, shaders::lathe_left(rough));
    const float mirrors = draw.turn.z;  // reflectance at normal incidence
    const Float8 gloss = shaders::lathe_gloss(shaders::ggx_over(light_l, roughness), body_under,
                                              shaders::ggx_over(light_l, draw.gloss.z), sheen_under, mirrors,
                                              film, fraction * t);
    return {.body = lit * seen,
            .gloss = gloss * seen,
            .mirror = shaders::lathe_mirror(mirrors, n_v, film),
            .tone = shaders::lathe_tone(draw.dry.w, streaks.tone)};
}

// The load display, blended over the lathe's own colour.
struct LoadLayers {
    Float8 red;
    Float8 dark;
    Float8 pale;

    [[gnu::always_inline]] [[nodiscard]] Float8 over(const Float8& own, int channel) const {
        return shaders::with_load(own, red, dark, pale, shaders::kLoadRed[channel],
                                  shaders::kLoadDark[channel], shaders::kLoadPale[channel]);
    }
};

// The light of one channel. `load` and `painted` replace the body's colour; null: no change.
[[gnu::always_inline]] inline Float8 light_of(const LatheLook& look, const Pixels& own,
                                              const Fractions& fractions, const LoadLayers* load,
                                              const Painted* painted, int channel) {
    const auto number = static_cast<std::size_t>(channel);
    const float key = look.frame.key_radiance[channel];
    const float dry = key * look.draw.dry[channel];
    const float wet = key * look.draw.wet[channel];
    Float8 body = fractions.tone *
                  (own[value::kAmbient + number] + (dry + (wet - dry) * own[value::kWater]) * fractions.body);
    if (load != nullptr || painted != nullptr) {
        const float own_dry = look.draw.dry[channel];
        const Float8 colour =
            max(fractions.tone * (own_dry + (look.draw.wet[channel] - own_dry) * own[value::kWater]), 1e-4F);
        if (load != nullptr) {
            body *= load->over(colour, channel) / colour;
        } else {
            const Float8& root = channel == 0   ? painted->roots.x
                                 : channel == 1 ? painted->roots.y
                                                : painted->roots.z;
            body *= shaders::lathe_marked(colour, root, painted->cover) / colour;
        }
    }
    return max(body + key * fractions.gloss + own[value::kMirrored + number] * fractions.mirror, 0.0F);
}

// mm along the hatch per texel of the streaks' texture, around the pot and up.
struct HatchPerTexel {
    float round_mm;
    float up_mm;

    [[gnu::always_inline]] explicit HatchPerTexel(const StreakSize& size)
        : round_mm(shaders::kStreakRoundMm / static_cast<float>(size.across)),
          up_mm(shaders::kStreakMm / static_cast<float>(size.up)) {}
};
[[gnu::always_inline]] inline Float8 hatch_at(const LatheLook& look, const Pixels& own) {
    const HatchPerTexel hatch(look.streak_size);
    const Float8 away = 1.0F / own[value::kNear];
    // The hatch stands still on the lathe, whereas the streaks' texture turns.
    const float turned_mm =
        (look.draw.turn.x + kStreakWidthsMore) * static_cast<float>(look.streak_size.across) * hatch.round_mm;
    return (own[value::kStreak] * hatch.round_mm + own[value::kStreak + 1] * hatch.up_mm) * away - turned_mm;
}

template <Pot kPot>
[[gnu::always_inline]] inline void shade(Queue& queue, const LatheLook& look, const PictureCanvas& canvas) {
    for (std::size_t first = 0; first < queue.count; first += kFloat8) {
        const Pixels own{queue, first};
        Painted painted;
        if constexpr (kPot == Pot::kMarked) painted = painted_at(look, own);
        const Fractions fractions = fractions_at<kPot>(look, own, painted);
        LoadLayers load;
        if constexpr (kPot == Pot::kWithLoad) {
            const Float8 shown = own[value::kLoad];
            load = {.red = shaders::load_red(shown),
                    .dark = shaders::load_dark(shown, hatch_at(look, own), own[kHatchWidth]),
                    .pale = shaders::load_pale(shown, own[kLoadWidth])};
        }
        const auto light = [&](int channel) __attribute__((always_inline)) {
            return light_of(look, own, fractions, kPot == Pot::kWithLoad ? &load : nullptr,
                            kPot == Pot::kMarked ? &painted : nullptr, channel);
        };
        const Int8 pixels = encoded({light(0), light(1), light(2)}, look.order);
        const std::size_t end = std::min(queue.count - first, std::size_t{kFloat8});
        for (std::size_t i = 0; i < end; ++i) {
            const std::int32_t at = queue.at[first + i];
            constexpr std::int32_t kPlace = (1 << kLevelShift) - 1;
            if (at >= 0)
                canvas.pixels[static_cast<std::size_t>(at & kPlace)] = static_cast<std::uint32_t>(pixels[i]);
        }
    }
    queue.count = 0;
}

}  // namespace onggi::render::shading

#pragma GCC diagnostic pop
