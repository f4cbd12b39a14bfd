#include "engine/render/pixels/prop_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "engine/math/wide_vectors.h"
#include "engine/render/pixels/encode8.h"

// No vector leaves this file by value, see float8.h.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render {
namespace {

using shapes::Reach;
using shapes::Shape;
using shapes::Slope;

// Adds one channel to a block of pixels.
[[gnu::always_inline]] inline void add_channel(const Slope& slope, const Float8& numbers, int shift,
                                               Int8& pixels) {
    constexpr float kMost = 255.0F;
    // In a sliver, rounding may push values beyond those of its corners.
    const Float8 value = float8::clamp((slope.first + 0.5F) + slope.step * numbers, 0.0F, kMost);
    pixels |= float8::ints(value) << shift;
}

// Draws a row of a shape from pixel `first` on. Pixels of a block outside the row are written back unchanged.
[[gnu::always_inline]] inline void draw_row(const std::array<Slope, 4>& slopes, std::ptrdiff_t first,
                                            int count, const PictureCanvas& canvas) {
    const auto last = static_cast<std::ptrdiff_t>(canvas.pixels.size()) - kFloat8;
    for (std::ptrdiff_t block = first; block < first + count; block += kFloat8) {
        const std::ptrdiff_t at = std::min(block, last);
        const Int8 numbers = kFirst8 + static_cast<int>(at - first);
        const Float8 in_row = float8::floats(numbers);
        const Float8 here = slopes[3].first + slopes[3].step * in_row;
        Float8 depth;
        Int8 pixels;
        std::memcpy(&depth, canvas.depth.data() + at, sizeof depth);
        std::memcpy(&pixels, canvas.pixels.data() + at, sizeof pixels);
        const Int8 is_drawn = (here < depth) & (numbers >= 0) & (numbers < count);
        depth = is_drawn ? here : depth;
        Int8 drawn = Int8{} + kOpaque;
        add_channel(slopes[0], in_row, 0, drawn);
        add_channel(slopes[1], in_row, 8, drawn);
        add_channel(slopes[2], in_row, 16, drawn);
        pixels = is_drawn ? drawn : pixels;
        std::memcpy(canvas.depth.data() + at, &depth, sizeof depth);
        std::memcpy(canvas.pixels.data() + at, &pixels, sizeof pixels);
    }
}

[[gnu::always_inline]] inline void draw(const Shape<3>& shape, const Reach& reach,
                                        const PictureCanvas& canvas) {
    for (int y = reach.top; y < reach.end; ++y) {
        const int left = reach.left[static_cast<std::size_t>(y)];
        const int count = reach.right[static_cast<std::size_t>(y)] - left;
        if (count <= 0) continue;
        shapes::fetch_ahead(canvas, left, y);
        draw_row({shape.slope(0, left, y), shape.slope(1, left, y), shape.slope(2, left, y),
                  shape.slope(3, left, y)},
                 static_cast<std::ptrdiff_t>(y) * canvas.size.width + left, count, canvas);
    }
}

bool is_behind_eye(const std::array<const PropCorner*, 3>& corners) {
    return std::any_of(corners.begin(), corners.end(),
                       [](const PropCorner* corner) { return corner->away_mm <= 0.0F; });
}

std::array<const PropCorner*, 3> triangle(std::span<const PropCorner> corners,
                                          std::span<const std::uint32_t> indices, std::size_t first) {
    return {&corners[indices[first]], &corners[indices[first + 1]], &corners[indices[first + 2]]};
}

[[gnu::always_inline]] inline void draw_all(std::span<const PropCorner> corners,
                                            std::span<const std::uint32_t> indices,
                                            const PictureCanvas& canvas) {
    if (canvas.pixels.size() < kFloat8) return;
    Reach reach(canvas.size);
    Shape<3> shape;
    for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
        const auto own = triangle(corners, indices, first);
        if (is_behind_eye(own)) continue;
        shape.corners = {own[0], own[1], own[2], nullptr};
        const float area = shapes::area_of(own[0]->at_px, own[1]->at_px, own[2]->at_px);
        if (std::abs(area) < shapes::kNoArea) continue;
        shapes::find_slopes(shape, area);
        shapes::find_reach(shape, area > 0.0F, canvas.size, reach);
        draw(shape, reach, canvas);
    }
}

void draw_plain(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                const PictureCanvas& canvas) {
    draw_all(corners, indices, canvas);
}

ONGGI_WIDE_VECTORS void draw_wide(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                                  const PictureCanvas& canvas) {
    draw_all(corners, indices, canvas);
}

}  // namespace

void draw_triangles(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                    const PictureCanvas& canvas) {
    static auto* const best = best_of(draw_plain, draw_wide);
    best(corners, indices, canvas);
}

void want_triangles(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                    const TileGrid& grid, std::span<std::uint8_t> wanted) {
    for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
        const auto own = triangle(corners, indices, first);
        if (is_behind_eye(own)) continue;
        const vec2 low = glm::min(glm::min(own[0]->at_px, own[1]->at_px), own[2]->at_px);
        const vec2 high = glm::max(glm::max(own[0]->at_px, own[1]->at_px), own[2]->at_px);
        want_tiles(grid, rect_about(low, high), wanted);
    }
}

}  // namespace onggi::render
