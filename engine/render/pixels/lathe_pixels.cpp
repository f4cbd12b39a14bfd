#include "engine/render/pixels/lathe_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/math/wide_vectors.h"
#include "engine/render/pixels/lathe_shade.h"

// No vector leaves this file by value, see float8.h.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render {
namespace {

using float8::any;
using float8::floats;
using shading::Pot;
using shading::Queue;
using shading::shade;

namespace value = lathe_value;
using shapes::Reach;
using shapes::Shape;

// Values that are interpolated linearly over a triangle, packed into vectors.
constexpr std::size_t kValueVectors = value::kCount / kFloat8;
using Values = std::array<Float8, kValueVectors>;

[[gnu::always_inline]] inline Values values_of(const LatheCorner& corner) {
    Values values;
    static_assert(sizeof values == sizeof corner.values);
    std::memcpy(&values, corner.values.data(), sizeof values);
    return values;
}

// Selects the level of the streaks: the one with one to two texels per pixel.
[[gnu::always_inline]] inline int streak_level(const Shape<value::kCount>& shape, float area) {
    const LatheCorner& first = *shape.corners[0];
    const auto texels_up = [](const LatheCorner& corner) {
        return corner.values[value::kStreak + 1] * corner.away_mm;
    };
    const vec2 to_1 = shape.corners[1]->at_px - first.at_px;
    const vec2 to_2 = shape.corners[2]->at_px - first.at_px;
    const float grown_1 = texels_up(*shape.corners[1]) - texels_up(first);
    const float grown_2 = texels_up(*shape.corners[2]) - texels_up(first);
    const float a_pixel =
        std::abs(grown_1 * to_2.y - grown_2 * to_1.y) + std::abs(grown_2 * to_1.x - grown_1 * to_2.x);
    const float least = 1.5F * std::abs(area);
    return (a_pixel > least ? 1 : 0) + (a_pixel > 2.0F * least ? 1 : 0) + (a_pixel > 4.0F * least ? 1 : 0);
}

// The gradients of a triangle's values, packed and for each value.
struct Growth {
    vec2 from;    // its first corner
    int level;    // level of the streaks, shifted to its position in Queue::at
    Values base;  // values at `from`
    Values across;
    Values down;
    alignas(32) std::array<Float8, value::kCount> along;  // offsets of eight pixels in a row

    [[gnu::always_inline]] Growth(const Shape<value::kCount>& shape, float area)
        : from(shape.corners[0]->at_px),
          level(streak_level(shape, area) << shading::kLevelShift),
          base(values_of(*shape.corners[0])) {
        const vec2 to_1 = (shape.corners[1]->at_px - from) / area;
        const vec2 to_2 = (shape.corners[2]->at_px - from) / area;
        const Values of_1 = values_of(*shape.corners[1]);
        const Values of_2 = values_of(*shape.corners[2]);
        for (std::size_t i = 0; i < kValueVectors; ++i) {
            const Float8 grown_1 = of_1[i] - base[i];
            const Float8 grown_2 = of_2[i] - base[i];
            across[i] = grown_1 * to_2.y - grown_2 * to_1.y;
            down[i] = grown_2 * to_1.x - grown_1 * to_2.x;
        }
        for (std::size_t i = 0; i < value::kCount; ++i)
            along[i] = across[i / kFloat8][i % kFloat8] * floats(kFirst8);
    }
    // Computes the values at a pixel.
    [[gnu::always_inline]] void find(int x, int y, std::array<float, value::kCount>& found) const {
        const float right_by = static_cast<float>(x) + 0.5F - from.x;
        const float down_by = static_cast<float>(y) + 0.5F - from.y;
        for (std::size_t i = 0; i < kValueVectors; ++i) {
            const Float8 values = base[i] + across[i] * right_by + down[i] * down_by;
            std::memcpy(found.data() + i * kFloat8, &values, sizeof values);
        }
    }
};

// Screen-space derivatives of the load and of the hatch position for a block, like fwidth() in a shader.
[[gnu::always_inline]] inline void add_widths(const Growth& growth,
                                              const std::array<float, value::kCount>& first,
                                              const LatheLook& look, Queue& queue, std::size_t at) {
    const shading::HatchPerTexel hatch(look.streak_size);
    const auto of = [](const Values& grown, std::size_t number) {
        return grown[number / kFloat8][number % kFloat8];
    };
    const auto along = [&](const Values& grown) {
        return of(grown, value::kStreak) * hatch.round_mm + of(grown, value::kStreak + 1) * hatch.up_mm;
    };
    const Float8 near = first[value::kNear] + growth.along[value::kNear];
    const Float8 place = ((first[value::kStreak] + growth.along[value::kStreak]) * hatch.round_mm +
                          (first[value::kStreak + 1] + growth.along[value::kStreak + 1]) * hatch.up_mm) /
                         near;
    const Float8 width = (float8::abs(along(growth.across) - place * of(growth.across, value::kNear)) +
                          float8::abs(along(growth.down) - place * of(growth.down, value::kNear))) /
                         near;
    std::memcpy(queue.values[shading::kHatchWidth].data() + at, &width, sizeof width);
    const Float8 load_width =
        Float8{} + (std::abs(of(growth.across, value::kLoad)) + std::abs(of(growth.down, value::kLoad)));
    std::memcpy(queue.values[shading::kLoadWidth].data() + at, &load_width, sizeof load_width);
}

// Queues one block: the pixels of a row from `x` on that fit in it. `end`: one after the row's last pixel.
template <Pot kPot>
[[gnu::always_inline]] inline void add(const Growth& growth, int x, int end, int y, const LatheLook& look,
                                       const PictureCanvas& canvas, Queue& queue) {
    const std::ptrdiff_t wanted = static_cast<std::ptrdiff_t>(y) * canvas.size.width + x;
    const std::ptrdiff_t at =
        std::min(wanted, static_cast<std::ptrdiff_t>(canvas.pixels.size()) - std::ptrdiff_t{kFloat8});
    const int early = static_cast<int>(wanted - at);  // pixels of the block before `x`
    const int count = std::min(end - x + early, kFloat8);
    alignas(32) std::array<float, value::kCount> first;
    growth.find(x - early, y, first);
    const Float8 here = first[value::kDepth] + growth.along[value::kDepth];
    Float8 depth;
    std::memcpy(&depth, canvas.depth.data() + at, sizeof depth);
    const Int8 is_drawn = (here <= depth) & (kFirst8 >= early) & (kFirst8 < count);
    if (!any(is_drawn)) return;
    depth = is_drawn ? here : depth;
    std::memcpy(canvas.depth.data() + at, &depth, sizeof depth);
    const std::size_t before = queue.count;
    const Int8 places = is_drawn ? kFirst8 + (static_cast<int>(at) | growth.level) : Int8{} - 1;
    std::memcpy(queue.at.data() + before, &places, sizeof places);
    constexpr std::size_t kValues = kPot == Pot::kPlain ? value::kPlain : value::kDepth;
#pragma GCC unroll 24
    for (std::size_t i = 0; i < kValues; ++i) {
        const Float8 values = first[i] + growth.along[i];
        std::memcpy(queue.values[i].data() + before, &values, sizeof values);
    }
    if constexpr (kPot == Pot::kWithLoad) add_widths(growth, first, look, queue, before);
    queue.count = before + static_cast<std::size_t>(count);
}

// `area`: twice the signed area in the picture; negative, because the corners are counter-clockwise.
template <Pot kPot>
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
        for (int x = left; x < end; x += kFloat8) {
            add<kPot>(growth, x, end, y, look, canvas, queue);
            if (queue.is_full()) shade<kPot>(queue, look, canvas);
        }
    }
}

template <Pot kPot>
[[gnu::always_inline]] inline void draw_some(std::span<const LatheCorner> corners,
                                             std::span<const std::uint16_t> indices, const LatheLook& look,
                                             Reach& reach, const PictureCanvas& canvas) {
    Queue queue{};  // zeroed: the last block of eight may be partial
    Shape<value::kCount> shape;
    for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
        const LatheCorner& a = corners[indices[first]];
        const LatheCorner& b = corners[indices[first + 1]];
        const LatheCorner& c = corners[indices[first + 2]];
        if (std::min({a.away_mm, b.away_mm, c.away_mm}) <= 0.0F) continue;
        const float area = shapes::area_of(a.at_px, b.at_px, c.at_px);
        if (area > -shapes::kNoArea) continue;  // faces away
        shape.corners = {&a, &b, &c, nullptr};
        draw_triangle<kPot>(shape, area, look, reach, canvas, queue);
    }
    shade<kPot>(queue, look, canvas);
}

[[gnu::always_inline]] inline void draw_all(std::span<const LatheCorner> corners,
                                            std::span<const std::uint16_t> indices, std::size_t plain,
                                            const LatheLook& look, const PictureCanvas& canvas) {
    if (canvas.pixels.size() < kFloat8) return;
    Reach reach(canvas.size);
    if (look.shows_load) {
        draw_some<Pot::kWithLoad>(corners, indices, look, reach, canvas);
        return;
    }
    if (!look.marks.empty()) {
        draw_some<Pot::kMarked>(corners, indices, look, reach, canvas);
        return;
    }
    draw_some<Pot::kPlain>(corners, indices.first(plain), look, reach, canvas);
    draw_some<Pot::kNearSpheres>(corners, indices.subspan(plain), look, reach, canvas);
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
