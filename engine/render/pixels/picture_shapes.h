// Rasterisation common to the CPU backend's shapes: the lines that a shape covers, and the gradients of its
// values. Inline, so that the code is compiled for its caller's instruction set. Any thread; pure. Pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

struct PictureSize {
    int width = 0;
    int height = 0;

    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

// A target picture, row by row.
struct PictureCanvas {
    PictureSize size;
    std::span<std::uint32_t> pixels;  // alpha highest
    std::span<float> depth;           // depth buffer, in the device's format
    // Only these rows are drawn and read, so that threads may draw to other rows meanwhile. A pixel's bits do
    // not depend on them.
    RowSpan rows{0, size.height};

    // One after the last pixel of the rows.
    [[nodiscard]] std::ptrdiff_t end() const { return std::ptrdiff_t{rows.end} * size.width; }
};

// A vertex of a shape, with the values that are interpolated between vertices.
template <std::size_t kValues>
struct PictureCorner {
    vec2 at_px{0.0F};
    float away_mm = 0.0F;  // distance along the view; not positive: at the eye or behind it
    float depth = 1.0F;    // in the device's format
    std::array<float, kValues> values{};
};
}  // namespace onggi::render

namespace onggi::render::shapes {

// A value that changes linearly from pixel to pixel.
struct Slope {
    float first = 0.0F;
    float step = 0.0F;

    [[nodiscard]] float at(int i) const { return first + step * static_cast<float>(i); }
};

// 16.16 fixed point.
constexpr int kOne = 65536;
[[gnu::always_inline]] inline int fixed(float value) {
    return static_cast<int>(value * static_cast<float>(kOne));
}

// Returns the first pixel whose centre is at or after an edge.
[[gnu::always_inline]] inline int first_pixel(float edge, int most) {
    return static_cast<int>(std::clamp(std::ceil(edge - 0.5F), 0.0F, static_cast<float>(most)));
}

// Horizontal extent of a shape in each line of the picture; only lines top to end are valid.
struct Reach {
    explicit Reach(const PictureCanvas& canvas)
        : size(canvas.size),
          rows(canvas.rows),
          left_of(static_cast<std::size_t>(rows.end - rows.first)),
          right_of(left_of.size()) {}
    [[nodiscard]] int left(int y) const { return left_of[static_cast<std::size_t>(y - rows.first)]; }
    [[nodiscard]] int right(int y) const { return right_of[static_cast<std::size_t>(y - rows.first)]; }

    PictureSize size;
    RowSpan rows;  // of the canvas; the first entries below are of its first row
    std::vector<int> left_of;
    std::vector<int> right_of;
    int top = 0;
    int end = 0;
};

// A convex shape with three or four corners, and the gradients of its values.
template <std::size_t kValues>
struct Shape {
    std::array<const PictureCorner<kValues>*, 4> corners;
    std::size_t count = 3;
    std::array<float, kValues + 1> across;  // the last entry: depth
    std::array<float, kValues + 1> down;

    [[nodiscard]] float value(std::size_t corner, std::size_t number) const {
        return number < kValues ? corners[corner]->values[number] : corners[corner]->depth;
    }
    // Returns a value as a Slope, starting at this pixel.
    [[nodiscard]] Slope slope(std::size_t number, int x, int y) const {
        const vec2 from = corners[0]->at_px;
        return {value(0, number) + across[number] * (static_cast<float>(x) + 0.5F - from.x) +
                    down[number] * (static_cast<float>(y) + 0.5F - from.y),
                across[number]};
    }
    template <typename Is>
    [[nodiscard]] bool all(std::size_t number, Is is) const {
        for (std::size_t i = 0; i < count; ++i) {
            if (!is(corners[i]->values[number])) return false;
        }
        return true;
    }
};

// Twice the signed area; positive for clockwise corners in a picture with y down.
[[gnu::always_inline]] inline float area_of(vec2 a, vec2 b, vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Computes where an edge crosses the centres of lines. Both shapes at an edge get the same result, so no
// pixel is skipped or drawn twice between them.
[[gnu::always_inline]] inline void walk(vec2 from, vec2 to, const PictureSize& size, const RowSpan& rows,
                                        std::vector<int>& into) {
    const int end = std::min(first_pixel(to.y, size.height), rows.end);
    const int top = first_pixel(from.y, size.height);
    int y = std::max(top, rows.first);
    if (y >= end) return;
    const float lean = (to.x - from.x) / (to.y - from.y);
    const float first = from.x + (static_cast<float>(top) + 0.5F - from.y) * lean;
    constexpr float kMost = 1e9F;
    const auto in_fixed = [&](float px) {
        return static_cast<std::int64_t>(std::clamp(px, -kMost, kMost) * static_cast<float>(kOne));
    };
    const std::int64_t step = in_fixed(lean);
    const std::int64_t most = size.width;
    // Counted from the edge's own first line, so that the rows do not change the result.
    for (std::int64_t x = in_fixed(first) + kOne / 2 - 1 + (y - top) * step; y < end; ++y, x += step)
        into[static_cast<std::size_t>(y - rows.first)] =
            static_cast<int>(std::clamp(x >> 16, std::int64_t{0}, most));
}

// Computes the lines that a shape covers, and its extent in each.
template <std::size_t kValues>
[[gnu::always_inline]] inline void find_reach(const Shape<kValues>& shape, bool is_clockwise, Reach& reach) {
    float top = shape.corners[0]->at_px.y;
    float low = top;
    for (std::size_t i = 0; i < shape.count; ++i) {
        const vec2 from = shape.corners[i]->at_px;
        const vec2 to = shape.corners[i + 1 < shape.count ? i + 1 : 0]->at_px;
        top = std::min(top, from.y);
        low = std::max(low, from.y);
        // Clockwise: an edge that goes down is on the right.
        if (from.y < to.y)
            walk(from, to, reach.size, reach.rows, is_clockwise ? reach.right_of : reach.left_of);
        if (to.y < from.y)
            walk(to, from, reach.size, reach.rows, is_clockwise ? reach.left_of : reach.right_of);
    }
    reach.top = std::max(first_pixel(top, reach.size.height), reach.rows.first);
    reach.end = std::min(first_pixel(low, reach.size.height), reach.rows.end);
}

// Computes the gradients from the first three corners.
template <std::size_t kValues>
[[gnu::always_inline]] inline void find_slopes(Shape<kValues>& shape, float area) {
    const vec2 from = shape.corners[0]->at_px;
    const vec2 a = (shape.corners[1]->at_px - from) / area;
    const vec2 b = (shape.corners[2]->at_px - from) / area;
    for (std::size_t i = 0; i <= kValues; ++i) {
        const float of_a = shape.value(1, i) - shape.value(0, i);
        const float of_b = shape.value(2, i) - shape.value(0, i);
        shape.across[i] = of_a * b.y - of_b * a.y;
        shape.down[i] = of_b * a.x - of_a * b.x;
    }
}

// Prefetches pixels a few rows ahead: rows are too far apart for the hardware prefetcher.
[[gnu::always_inline]] inline void fetch_ahead(const PictureCanvas& canvas, int x, int y) {
    constexpr std::size_t kRows = 3;
    const std::size_t at =
        (static_cast<std::size_t>(y) + kRows) * static_cast<std::size_t>(canvas.size.width) +
        static_cast<std::size_t>(x);
    if (at >= canvas.pixels.size()) return;
    __builtin_prefetch(canvas.pixels.data() + at, 1);
    __builtin_prefetch(canvas.depth.data() + at, 1);
}

constexpr float kNoArea = 1e-5F;

}  // namespace onggi::render::shapes
