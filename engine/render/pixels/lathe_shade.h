// How the clay's pixels are shaded by the processor, where that is the device: what shaders/lathe.frag does,
// eight at a time, out of a queue in which they wait. Inline, so that it becomes a part of whatever
// instructions its user is compiled for. Any thread; pure. Pixels, mm.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "engine/render/pixels/lathe_pixels.h"
#include "engine/render/pixels/load_pixels.h"
#include "engine/render/pixels/pixel_blocks.h"
#include "engine/render/shapes/detail_texture.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render::shading {

namespace value = lathe_value;
using blocks::Block;
using blocks::Block3;
using blocks::dot;
using blocks::eased;
using blocks::encoded;
using blocks::floats;
using blocks::ints;
using blocks::Ints;
using blocks::kBlock;
using blocks::least;
using blocks::LoadLayers;
using blocks::looked_up;
using blocks::most;
using blocks::root;
constexpr float kPi = std::numbers::pi_v<float>;

// Which pixels are drawn together.
enum class Pot { kPlain, kNearSpheres, kWithLoad };

// What a pixel that shows its load has besides: by how much that changes from it to the next ones, and by how
// many mm the place along the hatch does.
constexpr std::size_t kLoadWidth = value::kDepth;
constexpr std::size_t kHatchWidth = kLoadWidth + 1;

// Pixels that wait to be shaded, side by side whichever triangles they are of: most rows of a triangle are
// narrower than a block.
struct Queue {
    static constexpr std::size_t kMost = 128;
    std::size_t count = 0;
    alignas(32) std::array<std::array<float, kMost>, kHatchWidth + 1> values;
    std::array<std::int32_t, kMost>
        at;  // of the picture, below the slip's level; below 0: something is nearer

    [[nodiscard]] bool is_full() const { return count + kBlock > kMost; }
};

// Above a pixel's place: which level of the slip it shows.
constexpr int kLevelShift = 28;
static_assert(kSlipLevels <= 1 << (31 - kLevelShift));

// Eight of them.
struct Pixels {
    const Queue& queue;
    std::size_t first;

    [[gnu::always_inline]] [[nodiscard]] Block operator[](std::size_t number) const {
        Block values;
        std::memcpy(&values, queue.values[number].data() + first, sizeof values);
        return values;
    }
    [[gnu::always_inline]] [[nodiscard]] Ints slip_level() const {
        Ints places;
        std::memcpy(&places, queue.at.data() + first, sizeof places);
        return (places >> kLevelShift) & (kSlipLevels - 1);
    }
    [[gnu::always_inline]] [[nodiscard]] Block3 three(std::size_t number) const {
        return {(*this)[number], (*this)[number + 1], (*this)[number + 2]};
    }
};

// Numerator and denominator: ggx_fraction() of shaders/surface.glsl.
struct Fraction {
    Block over;
    Block under;
};
struct Lobe {
    Block a2;  // the roughness to the power of four
    Block k;   // half its square

    [[gnu::always_inline]] static Lobe of(const Block& roughness) {
        const Block alpha = roughness * roughness;
        return {alpha * alpha, alpha * 0.5F};
    }
    [[gnu::always_inline]] [[nodiscard]] Fraction fraction(const Block& n_h, const Block& n_v,
                                                           const Block& n_l) const {
        const Block d = n_h * n_h * (a2 - 1.0F) + 1.0F;
        const Block visible = (n_v * (1.0F - k) + k) * (n_l * (1.0F - k) + k);
        return {a2 * n_l, kPi * 4.0F * d * d * visible};
    }
};

// past_sphere() of shaders/surface.glsl.
[[gnu::always_inline]] inline Block past_sphere(const vec4& sphere, const vec4& key, const Block3& place) {
    const Block3 to{sphere.x - place.x, sphere.y - place.y, sphere.z - place.z};
    const Block along = dot(to, vec3(key));
    const Block gap = root(most(to.x * to.x + to.y * to.y + to.z * to.z - along * along, 0.0F)) - sphere.w;
    const Block width = most(along * key.w, 0.5F);
    const Block share = least(most((gap + width) / (2.0F * width), 0.0F), 1.0F);
    return along > 0.0F ? eased(share) : Block{} + 1.0F;
}

// What it has of the texture of slip, 0 to 1.
struct Slip {
    Block tone;
    Block lean_round;
    Block lean_up;
    Block film;
};
[[gnu::always_inline]] inline Slip slip_at(const LatheLook& look, const Pixels& own) {
    const Block away = 1.0F / own[value::kNear];
    const Ints across = ints(own[value::kSlip] * away) & (look.slip_size.across - 1);
    const Ints up = ints(own[value::kSlip + 1] * away) & (look.slip_size.up - 1);
    const Ints row = own.slip_level() * look.slip_size.up + up;
    const Ints texel = looked_up(look.slip.data(), row * look.slip_size.across + across);
    constexpr float kOneOver255 = 1.0F / 255.0F;
    const auto byte = [&](int shift) __attribute__((always_inline)) {
        return floats((texel >> shift) & 255) * kOneOver255;
    };
    return {byte(0), byte(8), byte(16), byte(24)};
}

// The way the wall looks there, not of unit length: the outline's own normal, leaned by dents and slip.
[[gnu::always_inline]] inline Block3 normal_at(const LatheLook& look, const Pixels& own, const Slip& slip) {
    const Ints place = ints(most(least(own[value::kNormal], shaders::kProfileTexels - 1.0F), 0.0F));
    const Ints word = looked_up(look.normals.data(), place);
    constexpr float kTwice = 2.0F / 65535.0F;
    const Block across = floats(word & 0xFFFF) * kTwice - 1.0F;
    const Block upward = floats((word >> 16) & 0xFFFF) * kTwice - 1.0F;
    const float streaks = look.draw.dry.w;
    const Block round = (slip.lean_round - 0.5F) * streaks;
    const Block up = (slip.lean_up - 0.5F) * streaks;
    const Block out_x = own[value::kOutward];
    const Block out_z = own[value::kOutward + 1];
    return {across * out_x - round * out_z, upward - across * own[value::kLean] + up,
            across * out_z + round * out_x};
}

template <Pot kPot>
[[gnu::always_inline]] inline Block key_seen(const LatheLook& look, const Pixels& own) {
    Block seen = own[value::kSeen];
    if constexpr (kPot == Pot::kPlain) return seen;
    const Block3 place = own.three(value::kPlace);
    for (const vec4& sphere : look.frame.spheres)
        seen *= past_sphere(sphere, look.frame.key_direction, place);
    return seen;
}

// How much of each light goes to the eye: of the key as the body throws it back, of the key as a mirror
// does, of the sky as a mirror does; and how light the body is.
struct Shares {
    Block body;
    Block gloss;
    Block mirror;
    Block tone;
};

template <Pot kPot>
[[gnu::always_inline]] inline Shares shares_at(const LatheLook& look, const Pixels& own) {
    const shaders::LatheDraw& draw = look.draw;
    const Slip slip = slip_at(look, own);
    const Block3 n = normal_at(look, own, slip);
    const Block one_over_n = 1.0F / root(n.x * n.x + n.y * n.y + n.z * n.z);
    const Block3 v = own.three(value::kToEye);
    const Block n_l = dot(n, vec3(look.frame.key_direction)) * one_over_n;
    const Block n_v = most((n.x * v.x + n.y * v.y + n.z * v.z) * one_over_n, 0.05F);
    const Block seen = key_seen<kPot>(look, own);

    // Y. Fujii's form of the Oren-Nayar model, as in the shader.
    const Block l_v = dot(v, vec3(look.frame.key_direction));
    const Block s = l_v - n_l * n_v;
    const Block t = s > 0.0F ? most(n_l > n_v ? n_l : n_v, 0.1F) : Block{} + 1.0F;
    const Block half =
        kPot == Pot::kWithLoad ? 1.0F / root(most(2.0F + 2.0F * l_v, 1e-4F)) : own[value::kHalf];
    const Block n_h = most((n_v + n_l) * half, 0.0F);
    const Block light_l = most(n_l, 0.0F);
    const Block water = own[value::kWater];
    const Fraction body =
        Lobe::of(draw.gloss.x + (draw.gloss.y - draw.gloss.x) * water).fraction(n_h, n_v, light_l);
    const Fraction sheen = Lobe::of(Block{} + draw.gloss.z).fraction(n_h, n_v, light_l);
    // The film lies thick in some places and thin in others; a glaze covers everything.
    const Block film =
        most(least(most(own[value::kFilm] * (0.62F + 1.5F * (slip.film - 0.5F)), 0.0F), 1.0F), draw.gloss.w);
    const float mirrors = draw.turn.z;  // straight on
    const Block past = 1.0F - n_v;
    const Block past_2 = past * past;
    const Block mirror = mirrors + (1.0F - mirrors) * 0.7F * (past_2 * past_2 * past);

    const Block body_sheen = body.under * sheen.under;
    const Block share = 1.0F / (body_sheen * t);
    const Block rough = 0.85F - 0.5F * water;
    // What the roughness takes of the light, 1 / (1 + 0.288 rough), by its first terms about the middle.
    const Block from_middle = rough - 0.6F;
    const Block left = 0.85266F - 0.20938F * from_middle + 0.05142F * from_middle * from_middle;
    const float width = draw.wet.w;
    const Block ease = most(n_l * draw.turn.w + 1.0F, 0.0F);
    const Block cosine = n_l > width ? n_l : width * 0.25F * ease * ease;
    const Block lit = cosine * (1.0F + 0.9F * rough * s * body_sheen * share) * left;
    const Block gloss = (body.over * sheen.under * (0.04F * kPi) * (1.0F - film) +
                         sheen.over * body.under * (mirrors * kPi) * film) *
                        (share * t);
    return {.body = most(lit, 0.0F) * seen,
            .gloss = gloss * seen,
            .mirror = mirror * (0.12F + 0.88F * film),
            .tone = 1.0F + draw.dry.w * (slip.tone - 0.5F) * 1.7F};
}

// The light of one channel; with `load` as another colour of the body, null: as it is.
[[gnu::always_inline]] inline Block light_of(const LatheLook& look, const Pixels& own, const Shares& shares,
                                             const LoadLayers* load, int channel) {
    const auto number = static_cast<std::size_t>(channel);
    const float key = look.frame.key_radiance[channel];
    const float dry = key * look.draw.dry[channel];
    const float wet = key * look.draw.wet[channel];
    Block body = shares.tone *
                 (own[value::kAmbient + number] + (dry + (wet - dry) * own[value::kWater]) * shares.body);
    if (load != nullptr) {
        const float own_dry = look.draw.dry[channel];
        const Block colour =
            most(shares.tone * (own_dry + (look.draw.wet[channel] - own_dry) * own[value::kWater]), 1e-4F);
        body *= load->over(colour, channel) / colour;
    }
    return most(body + key * shares.gloss + own[value::kMirrored + number] * shares.mirror, 0.0F);
}

// Where a place in the slip's texture, in texels, lies along the hatch: round the pot and up it.
struct HatchPerTexel {
    float round_mm;
    float up_mm;

    [[gnu::always_inline]] explicit HatchPerTexel(const SlipSize& size)
        : round_mm(120.0F / static_cast<float>(size.across)),
          up_mm(kSlipMm / static_cast<float>(size.up)) {}
};
[[gnu::always_inline]] inline Block hatch_at(const LatheLook& look, const Pixels& own) {
    const HatchPerTexel hatch(look.slip_size);
    const Block away = 1.0F / own[value::kNear];
    // It stands on the clay, whereas the slip's texture turns under it.
    const float turned_mm =
        (look.draw.turn.x + kSlipWidthsMore) * static_cast<float>(look.slip_size.across) * hatch.round_mm;
    return (own[value::kSlip] * hatch.round_mm + own[value::kSlip + 1] * hatch.up_mm) * away - turned_mm;
}

template <Pot kPot>
[[gnu::always_inline]] inline void shade(Queue& queue, const LatheLook& look, const PictureCanvas& canvas) {
    for (std::size_t first = 0; first < queue.count; first += kBlock) {
        const Pixels own{queue, first};
        const Shares shares = shares_at<kPot>(look, own);
        LoadLayers load;
        if constexpr (kPot == Pot::kWithLoad)
            load =
                LoadLayers::of({own[value::kLoad], own[kLoadWidth]}, {hatch_at(look, own), own[kHatchWidth]});
        const auto light = [&](int channel) __attribute__((always_inline)) {
            return light_of(look, own, shares, kPot == Pot::kWithLoad ? &load : nullptr, channel);
        };
        const Ints shown = encoded({light(0), light(1), light(2)}, look.order);
        const std::size_t end = std::min(queue.count - first, std::size_t{kBlock});
        for (std::size_t i = 0; i < end; ++i) {
            const std::int32_t at = queue.at[first + i];
            constexpr std::int32_t kPlace = (1 << kLevelShift) - 1;
            if (at >= 0)
                canvas.pixels[static_cast<std::size_t>(at & kPlace)] = static_cast<std::uint32_t>(shown[i]);
        }
    }
    queue.count = 0;
}

}  // namespace onggi::render::shading

#pragma GCC diagnostic pop
