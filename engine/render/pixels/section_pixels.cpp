#include "engine/render/pixels/section_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/render/pixels/light_lanes.h"
#include "engine/render/pixels/load_pixels.h"
#include "engine/render/pixels/pixel_blocks.h"

// No vector leaves this file by value, see pixel_blocks.h.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render {
namespace {

namespace value = section_value;
using shapes::Reach;
using shapes::Shape;
using shapes::Slope;

using blocks::any;
using blocks::Block;
using blocks::encoded;
using blocks::floats;
using blocks::fraction;
using blocks::Ints;
using blocks::kBlock;
using blocks::kNumbers;
using blocks::LoadLayers;
using blocks::magnitude;
using blocks::most;
using blocks::smooth_step;
using blocks::Spread;

// Eight pixels of a row: what is known of them, and how it grows to either side.
struct Pixels {
    const std::array<Slope, value::kCount + 1>& slopes;
    const Shape<value::kCount>& shape;
    Block in_row;  // how far along
    Block near;

    [[gnu::always_inline]] [[nodiscard]] Block at(std::size_t number) const {
        return slopes[number].first + slopes[number].step * in_row;
    }
    // With the width of fwidth() in a shader.
    [[gnu::always_inline]] [[nodiscard]] Spread spread(std::size_t number) const {
        const Block found = at(number) / near;
        const Block across = shape.across[number] - found * shape.across[value::kNear];
        const Block down = shape.down[number] - found * shape.down[value::kNear];
        return {.value = found, .width = most((magnitude(across) + magnitude(down)) / near, 1e-5F)};
    }
};

// Pale, hatched at 45 degrees, with a line where they end; a longer line every ten millimetres of height is a
// scale.
[[gnu::always_inline]] inline Ints shown(const Pixels& own, const SectionLook& look) {
    constexpr float kHatchMm = 3.0F;
    constexpr float kFarMm = 2100.0F;  // whole hatches and scales away: no place is below 0
    const Spread from_axis = own.spread(value::kFromAxis);
    const Spread up = own.spread(value::kUp);
    const Spread load = own.spread(value::kLoad);
    const Spread through = own.spread(value::kThrough);
    const Spread along{from_axis.value + up.value + kFarMm, from_axis.width + up.width};

    const Block lines = magnitude(fraction(along.value / kHatchMm) - 0.5F);
    const Block hatch = 1.0F - 0.30F * (1.0F - smooth_step(lines, Block{} + 0.12F, kHatchMm / along.width));
    const Block border = through.value < 0.5F ? through.value : 1.0F - through.value;
    const Block within = 0.25F + 0.75F * smooth_step(border, Block{}, 1.0F / (1.5F * through.width));
    const Block mark = magnitude(fraction((up.value + kFarMm) * 0.1F + 0.5F) - 0.5F) * 10.0F;
    const Block scale = 0.35F + 0.65F * smooth_step(mark / up.width, Block{} + 0.5F, Block{} + 1.0F);
    LoadLayers layers{};
    if (look.shows_load) layers = LoadLayers::of(load, along);
    const auto light = [&](int channel) __attribute__((always_inline)) {
        const Block own_colour = look.colour[channel] * hatch;
        const Block colour = look.shows_load ? layers.over(own_colour, channel) : own_colour;
        return most(colour * within * scale, 0.0F);
    };
    return encoded({light(0), light(1), light(2)}, look.order);
}

void draw(const Shape<value::kCount>& shape, const Reach& reach, const SectionLook& look,
          const PictureCanvas& canvas) {
    const auto last = static_cast<std::ptrdiff_t>(canvas.pixels.size()) - kBlock;
    std::array<Slope, value::kCount + 1> slopes;
    for (int y = reach.top; y < reach.end; ++y) {
        const int left = reach.left[static_cast<std::size_t>(y)];
        const int count = reach.right[static_cast<std::size_t>(y)] - left;
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * canvas.size.width + left;
        for (std::size_t number = 0; number < slopes.size(); ++number)
            slopes[number] = shape.slope(number, left, y);
        for (std::ptrdiff_t block = first; block < first + count; block += kBlock) {
            const std::ptrdiff_t at = std::min(block, last);
            const Ints numbers = kNumbers + static_cast<int>(at - first);
            const Block in_row = floats(numbers);
            const Block here = slopes[value::kCount].first + slopes[value::kCount].step * in_row;
            Block depth;
            std::memcpy(&depth, canvas.depth.data() + at, sizeof depth);
            const Ints is_drawn = (here <= depth) & (numbers >= 0) & (numbers < count);
            if (!any(is_drawn)) continue;
            const Block near = slopes[value::kNear].first + slopes[value::kNear].step * in_row;
            Ints pixels;
            std::memcpy(&pixels, canvas.pixels.data() + at, sizeof pixels);
            depth = is_drawn ? here : depth;
            pixels = is_drawn ? shown({slopes, shape, in_row, near}, look) : pixels;
            std::memcpy(canvas.depth.data() + at, &depth, sizeof depth);
            std::memcpy(canvas.pixels.data() + at, &pixels, sizeof pixels);
        }
    }
}

}  // namespace

void place_section(std::span<const shaders::VertexData> vertices, const shaders::FrameData& frame,
                   std::vector<SectionCorner>& corners) {
    const vec2 half = 0.5F * vec2(frame.picture);
    corners.resize(vertices.size());
    std::transform(vertices.begin(), vertices.end(), corners.begin(), [&](const auto& vertex) {
        const vec4 clip = frame.view_projection * vec4(vec3(vertex.place), 1.0F);
        if (clip.w <= 0.0F) return SectionCorner{};
        const float near = 1.0F / clip.w;
        const vec2 at_px = half + half * vec2(clip) * near;
        return SectionCorner{.at_px = {lanes::in_steps(at_px.x), lanes::in_steps(at_px.y)},
                             .away_mm = clip.w,
                             .depth = clip.z * near,
                             .values = {vertex.lean.x * near, vertex.place.y * near, vertex.lean.y * near,
                                        vertex.lean.z * near, near}};
    });
}

void draw_section(std::span<const SectionCorner> corners, const SectionLook& look,
                  const PictureCanvas& canvas) {
    if (canvas.pixels.size() < kBlock) return;
    Reach reach(canvas.size);
    Shape<value::kCount> shape;
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
        const std::span<const SectionCorner> own = corners.subspan(first, 3);
        if (std::min({own[0].away_mm, own[1].away_mm, own[2].away_mm}) <= 0.0F) continue;
        const float area = shapes::area_of(own[0].at_px, own[1].at_px, own[2].at_px);
        if (std::abs(area) < shapes::kNoArea) continue;
        shape.corners = {&own[0], &own[1], &own[2], nullptr};
        shapes::find_slopes(shape, area);
        shapes::find_reach(shape, area > 0.0F, canvas.size, reach);
        draw(shape, reach, look, canvas);
    }
}

}  // namespace onggi::render
