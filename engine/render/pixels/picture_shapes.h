// The shapes that the processor draws where it is the device: which lines of the picture they reach, and how
// what they show grows over them. Inline, so that they become a part of whatever instructions their user is
// compiled for. Any thread; pure. Pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"

namespace onggi::render {

struct PictureSize {
    int width = 0;
    int height = 0;

    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

// What is drawn into, row by row.
struct PictureCanvas {
    PictureSize size;
    std::span<std::uint32_t> pixels;  // alpha highest
    std::span<float> depth;           // as the device has it, of what is there already
};

// A corner of a shape, with what grows evenly from it to the next.
template <std::size_t kValues>
struct PictureCorner {
    vec2 at_px{0.0F};
    float away_mm = 0.0F;  // along the view; not above 0: at the eye or behind it
    float depth = 1.0F;    // as the device has it
    std::array<float, kValues> values{};
};
}  // namespace onggi::render

namespace onggi::render::shapes {

// Something that grows evenly from pixel to pixel.
struct Slope {
    float first = 0.0F;
    float step = 0.0F;

    [[nodiscard]] float at(int i) const { return first + step * static_cast<float>(i); }
};

// Sixteen bits behind the point.
constexpr int kOne = 65536;
[[gnu::always_inline]] inline int fixed(float value) {
    return static_cast<int>(value * static_cast<float>(kOne));
}

// The pixel whose middle is the first at or after an edge.
[[gnu::always_inline]] inline int first_pixel(float edge, int most) {
    return static_cast<int>(std::clamp(std::ceil(edge - 0.5F), 0.0F, static_cast<float>(most)));
}

// From where to where a shape reaches in each line of the picture; only its own lines are good.
struct Reach {
    explicit Reach(const PictureSize& size)
        : left(static_cast<std::size_t>(size.height)),
          right(static_cast<std::size_t>(size.height)) {}
    std::vector<int> left;
    std::vector<int> right;
    int top = 0;
    int end = 0;
};

// A convex shape of three or four corners, and how its values grow from pixel to pixel.
template <std::size_t kValues>
struct Shape {
    std::array<const PictureCorner<kValues>*, 4> corners;
    std::size_t count = 3;
    std::array<float, kValues + 1> across;  // the last: depth
    std::array<float, kValues + 1> down;

    [[nodiscard]] float value(std::size_t corner, std::size_t number) const {
        return number < kValues ? corners[corner]->values[number] : corners[corner]->depth;
    }
    // Of a value, from this pixel on.
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

// Twice the area; above 0 where the corners go clockwise in a picture whose y points down.
[[gnu::always_inline]] inline float area_of(vec2 a, vec2 b, vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Where an edge passes the lines it reaches. The same for both shapes at it, so no pixel is left out between
// them and none is drawn twice.
[[gnu::always_inline]] inline void walk(vec2 from, vec2 to, const PictureSize& size, std::vector<int>& into) {
    const int end = first_pixel(to.y, size.height);
    int y = first_pixel(from.y, size.height);
    if (y >= end) return;
    const float lean = (to.x - from.x) / (to.y - from.y);
    const float first = from.x + (static_cast<float>(y) + 0.5F - from.y) * lean;
    constexpr float kMost = 1e9F;
    const auto in_fixed = [&](float px) {
        return static_cast<std::int64_t>(std::clamp(px, -kMost, kMost) * static_cast<float>(kOne));
    };
    const std::int64_t step = in_fixed(lean);
    const std::int64_t most = size.width;
    for (std::int64_t x = in_fixed(first) + kOne / 2 - 1; y < end; ++y, x += step)
        into[static_cast<std::size_t>(y)] = static_cast<int>(std::clamp(x >> 16, std::int64_t{0}, most));
}

// Which lines a shape reaches, and how far.
template <std::size_t kValues>
[[gnu::always_inline]] inline void find_reach(const Shape<kValues>& shape, bool is_clockwise,
                                              const PictureSize& size, Reach& reach) {
    float top = shape.corners[0]->at_px.y;
    float low = top;
    for (std::size_t i = 0; i < shape.count; ++i) {
        const vec2 from = shape.corners[i]->at_px;
        const vec2 to = shape.corners[i + 1 < shape.count ? i + 1 : 0]->at_px;
        top = std::min(top, from.y);
        low = std::max(low, from.y);
        // Clockwise, what goes down is on the right.
        if (from.y < to.y) walk(from, to, size, is_clockwise ? reach.right : reach.left);
        if (to.y < from.y) walk(to, from, size, is_clockwise ? reach.left : reach.right);
    }
    reach.top = first_pixel(top, size.height);
    reach.end = first_pixel(low, size.height);
}

// From the first three corners.
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

// Asks for what a shape will draw over some rows later: they are too far apart for a processor to guess the
// next.
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
