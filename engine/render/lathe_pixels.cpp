#include "engine/render/lathe_pixels.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numbers>

#include "engine/render/pixel_blocks.h"
#include "engine/render/wide_vectors.h"

// No vector leaves this file by value, see pixel_blocks.h.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render {
namespace {

namespace value = lathe_value;
using shapes::Reach;
using shapes::Shape;

using blocks::any;
using blocks::Block;
using blocks::Block3;
using blocks::dot;
using blocks::floats;
using blocks::ints;
using blocks::Ints;
using blocks::kBlock;
using blocks::kNumbers;
using blocks::least;
using blocks::looked_up;
using blocks::most;
using blocks::root;
constexpr float kPi = std::numbers::pi_v<float>;

[[gnu::always_inline]] inline Block eased(const Block& share) {
    return share * share * (3.0F - 2.0F * share);
}

// What grows evenly over a triangle, as vectors of values: at its first corner, and from pixel to pixel.
constexpr std::size_t kValueBlocks = value::kCount / kBlock;
using Values = std::array<Block, kValueBlocks>;

[[gnu::always_inline]] inline Values values_of(const LatheCorner& corner) {
    Values values;
    static_assert(sizeof values == sizeof corner.values);
    std::memcpy(&values, corner.values.data(), sizeof values);
    return values;
}

// Pixels that wait to be shaded, side by side whichever triangles they are of: most rows of a triangle are
// narrower than a block.
struct Queue {
    static constexpr std::size_t kMost = 128;
    std::size_t count = 0;
    alignas(32) std::array<std::array<float, kMost>, value::kDepth> values;
    std::array<std::int32_t, kMost> at;  // of the picture; below 0: something is nearer

    [[nodiscard]] bool is_full() const { return count + kBlock > kMost; }
};

// Eight of them.
struct Pixels {
    const Queue& queue;
    std::size_t first;

    [[gnu::always_inline]] [[nodiscard]] Block operator[](std::size_t number) const {
        Block values;
        std::memcpy(&values, queue.values[number].data() + first, sizeof values);
        return values;
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
    const Ints texel = looked_up(look.slip.data(), up * look.slip_size.across + across);
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

[[gnu::always_inline]] inline Block key_seen(const LatheLook& look, const Pixels& own, bool is_near_spheres) {
    Block seen = own[value::kSeen];
    if (!is_near_spheres) return seen;
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

[[gnu::always_inline]] inline Shares shares_at(const LatheLook& look, const Pixels& own,
                                               bool is_near_spheres) {
    const shaders::LatheDraw& draw = look.draw;
    const Slip slip = slip_at(look, own);
    const Block3 n = normal_at(look, own, slip);
    const Block one_over_n = 1.0F / root(n.x * n.x + n.y * n.y + n.z * n.z);
    const Block3 v = own.three(value::kToEye);
    const Block n_l = dot(n, vec3(look.frame.key_direction)) * one_over_n;
    const Block n_v = most((n.x * v.x + n.y * v.y + n.z * v.z) * one_over_n, 0.05F);
    const Block seen = key_seen(look, own, is_near_spheres);

    // Y. Fujii's form of the Oren-Nayar model, as in the shader.
    const Block s = dot(v, vec3(look.frame.key_direction)) - n_l * n_v;
    const Block t = s > 0.0F ? most(n_l > n_v ? n_l : n_v, 0.1F) : Block{} + 1.0F;
    const Block n_h = most((n_v + n_l) * own[value::kHalf], 0.0F);
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

// The light of one channel.
[[gnu::always_inline]] inline Block light_of(const LatheLook& look, const Pixels& own, const Shares& shares,
                                             int channel) {
    const auto number = static_cast<std::size_t>(channel);
    const float key = look.frame.key_radiance[channel];
    const float dry = key * look.draw.dry[channel];
    const float wet = key * look.draw.wet[channel];
    return most(shares.tone * (own[value::kAmbient + number] +
                               (dry + (wet - dry) * own[value::kWater]) * shares.body) +
                    key * shares.gloss + own[value::kMirrored + number] * shares.mirror,
                0.0F);
}

// encode() of shaders/tone.glsl with the square root, to pixels.
[[gnu::always_inline]] inline Ints encoded(const Block3& light, ByteOrder order) {
    const Block3 under{light.x * 0.8F + 0.35F, light.y * 0.8F + 0.35F, light.z * 0.8F + 0.35F};
    const Block share = 1.0F / (under.x * under.y * under.z);
    const auto shown = [&](const Block& own, const Block& a, const Block& b) __attribute__((always_inline)) {
        return ints(root(least(own * a * b * share, 1.0F)) * 255.0F + 0.5F);
    };
    const Ints red = shown(light.x, under.y, under.z);
    const Ints green = shown(light.y, under.z, under.x);
    const Ints blue = shown(light.z, under.x, under.y);
    using blocks::kOpaque;
    return order == ByteOrder::kRedFirst ? kOpaque | blue << 16 | green << 8 | red
                                         : kOpaque | red << 16 | green << 8 | blue;
}

template <bool kNearSpheres>
[[gnu::always_inline]] inline void shade(Queue& queue, const LatheLook& look, const PictureCanvas& canvas) {
    for (std::size_t first = 0; first < queue.count; first += kBlock) {
        const Pixels own{queue, first};
        const Shares shares = shares_at(look, own, kNearSpheres);
        const Ints shown = encoded(
            {light_of(look, own, shares, 0), light_of(look, own, shares, 1), light_of(look, own, shares, 2)},
            look.order);
        const std::size_t end = std::min(queue.count - first, std::size_t{kBlock});
        for (std::size_t i = 0; i < end; ++i) {
            const std::int32_t at = queue.at[first + i];
            if (at >= 0) canvas.pixels[static_cast<std::size_t>(at)] = static_cast<std::uint32_t>(shown[i]);
        }
    }
    queue.count = 0;
}

// How a triangle's values grow, as vectors of values and one by one.
struct Growth {
    vec2 from;    // its first corner
    Values base;  // there
    Values across;
    Values down;
    alignas(32) std::array<Block, value::kCount> along;  // a row's first eight pixels

    [[gnu::always_inline]] Growth(const Shape<value::kCount>& shape, float area)
        : from(shape.corners[0]->at_px),
          base(values_of(*shape.corners[0])) {
        const vec2 to_1 = (shape.corners[1]->at_px - from) / area;
        const vec2 to_2 = (shape.corners[2]->at_px - from) / area;
        const Values of_1 = values_of(*shape.corners[1]);
        const Values of_2 = values_of(*shape.corners[2]);
        for (std::size_t i = 0; i < kValueBlocks; ++i) {
            const Block grown_1 = of_1[i] - base[i];
            const Block grown_2 = of_2[i] - base[i];
            across[i] = grown_1 * to_2.y - grown_2 * to_1.y;
            down[i] = grown_2 * to_1.x - grown_1 * to_2.x;
        }
        for (std::size_t i = 0; i < value::kCount; ++i)
            along[i] = across[i / kBlock][i % kBlock] * floats(kNumbers);
    }
    // At a pixel.
    [[gnu::always_inline]] void find(int x, int y, std::array<float, value::kCount>& found) const {
        const float right_by = static_cast<float>(x) + 0.5F - from.x;
        const float down_by = static_cast<float>(y) + 0.5F - from.y;
        for (std::size_t i = 0; i < kValueBlocks; ++i) {
            const Block values = base[i] + across[i] * right_by + down[i] * down_by;
            std::memcpy(found.data() + i * kBlock, &values, sizeof values);
        }
    }
};

// The part of a row from `x` on that a block holds; `end`: its last pixel's next.
template <std::size_t kValues>
[[gnu::always_inline]] inline void add(const Growth& growth, int x, int end, int y,
                                       const PictureCanvas& canvas, Queue& queue) {
    const std::ptrdiff_t wanted = static_cast<std::ptrdiff_t>(y) * canvas.size.width + x;
    const std::ptrdiff_t at =
        std::min(wanted, static_cast<std::ptrdiff_t>(canvas.pixels.size()) - std::ptrdiff_t{kBlock});
    const int early = static_cast<int>(wanted - at);  // pixels of the block before the part
    const int count = std::min(end - x + early, kBlock);
    alignas(32) std::array<float, value::kCount> first;
    growth.find(x - early, y, first);
    const Block here = first[value::kDepth] + growth.along[value::kDepth];
    Block depth;
    std::memcpy(&depth, canvas.depth.data() + at, sizeof depth);
    const Ints is_drawn = (here <= depth) & (kNumbers >= early) & (kNumbers < count);
    if (!any(is_drawn)) return;
    depth = is_drawn ? here : depth;
    std::memcpy(canvas.depth.data() + at, &depth, sizeof depth);
    const std::size_t before = queue.count;
    const Ints places = is_drawn ? kNumbers + static_cast<int>(at) : Ints{} - 1;
    std::memcpy(queue.at.data() + before, &places, sizeof places);
#pragma GCC unroll 24
    for (std::size_t i = 0; i < kValues; ++i) {
        const Block values = first[i] + growth.along[i];
        std::memcpy(queue.values[i].data() + before, &values, sizeof values);
    }
    queue.count = before + static_cast<std::size_t>(count);
}

// `area`: twice its own in the picture, below 0: its corners go counter-clockwise.
template <bool kNearSpheres>
[[gnu::always_inline]] inline void draw_triangle(const Shape<value::kCount>& shape, float area,
                                                 const LatheLook& look, Reach& reach,
                                                 const PictureCanvas& canvas, Queue& queue) {
    shapes::find_reach(shape, false, canvas.size, reach);
    const Growth growth(shape, area);
    for (int y = reach.top; y < reach.end; ++y) {
        const int left = reach.left[static_cast<std::size_t>(y)];
        const int end = reach.right[static_cast<std::size_t>(y)];
        if (end <= left) continue;
        shapes::fetch_ahead(canvas, left, y);
        for (int x = left; x < end; x += kBlock) {
            add<kNearSpheres ? value::kDepth : value::kPlain>(growth, x, end, y, canvas, queue);
            if (queue.is_full()) shade<kNearSpheres>(queue, look, canvas);
        }
    }
}

template <bool kNearSpheres>
[[gnu::always_inline]] inline void draw_some(std::span<const LatheCorner> corners,
                                             std::span<const std::uint16_t> indices, const LatheLook& look,
                                             Reach& reach, const PictureCanvas& canvas) {
    Queue queue{};  // the last block may be part of one
    Shape<value::kCount> shape;
    for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
        const LatheCorner& a = corners[indices[first]];
        const LatheCorner& b = corners[indices[first + 1]];
        const LatheCorner& c = corners[indices[first + 2]];
        if (std::min({a.away_mm, b.away_mm, c.away_mm}) <= 0.0F) continue;
        const float area = shapes::area_of(a.at_px, b.at_px, c.at_px);
        if (area > -shapes::kNoArea) continue;  // it looks away
        shape.corners = {&a, &b, &c, nullptr};
        draw_triangle<kNearSpheres>(shape, area, look, reach, canvas, queue);
    }
    shade<kNearSpheres>(queue, look, canvas);
}

[[gnu::always_inline]] inline void draw_all(std::span<const LatheCorner> corners,
                                            std::span<const std::uint16_t> indices, std::size_t plain,
                                            const LatheLook& look, const PictureCanvas& canvas) {
    if (canvas.pixels.size() < kBlock) return;
    Reach reach(canvas.size);
    draw_some<false>(corners, indices.first(plain), look, reach, canvas);
    draw_some<true>(corners, indices.subspan(plain), look, reach, canvas);
}

void draw_plain(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices,
                std::size_t plain, const LatheLook& look, const PictureCanvas& canvas) {
    draw_all(corners, indices, plain, look, canvas);
}

ONGGI_WIDE_VECTORS void draw_wide(std::span<const LatheCorner> corners,
                                  std::span<const std::uint16_t> indices, std::size_t plain,
                                  const LatheLook& look, const PictureCanvas& canvas) {
    draw_all(corners, indices, plain, look, canvas);
}

}  // namespace

void draw_lathe(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices,
                std::size_t plain, const LatheLook& look, const PictureCanvas& canvas) {
    static auto* const best = best_of(draw_plain, draw_wide);
    best(corners, indices, plain, look, canvas);
}

}  // namespace onggi::render
