#include "engine/render/pixels/section_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/render/pixels/corners8.h"
#include "engine/render/pixels/encode8.h"
#include "shaders/load.h"

namespace onggi::render {
namespace {

namespace value = section_value;
using shapes::Reach;
using shapes::Shape;
using shapes::Slope;

// A value that varies over the picture, and its screen-space derivative.
struct Spread {
    Float8 value;
    Float8 width;
};

// Eight pixels of a row, with the gradients of their values.
struct Pixels {
    const std::array<Slope, value::kCount + 1>& slopes;
    const Shape<value::kCount>& shape;
    Float8 in_row;  // position in the row
    Float8 near;

    [[gnu::always_inline]] [[nodiscard]] Float8 at(std::size_t number) const {
        return slopes[number].first + slopes[number].step * in_row;
    }
    // Returns a value with the width that fwidth() has in a shader.
    [[gnu::always_inline]] [[nodiscard]] Spread spread(std::size_t number) const {
        const Float8 found = at(number) / near;
        const Float8 across = shape.across[number] - found * shape.across[value::kNear];
        const Float8 down = shape.down[number] - found * shape.down[value::kNear];
        return {.value = found,
                .width = float8::max((float8::abs(across) + float8::abs(down)) / near, 1e-5F)};
    }
};

[[gnu::always_inline]] inline Int8 shown(const Pixels& own, const SectionLook& look) {
    // A multiple of the hatch's and the scale's period that keeps positions positive.
    constexpr float kFarMm = 2100.0F;
    const Spread from_axis = own.spread(value::kFromAxis);
    const Spread up = own.spread(value::kUp);
    const Spread load = own.spread(value::kLoad);
    const Spread through = own.spread(value::kThrough);
    const Float8 along = from_axis.value + up.value + kFarMm;
    const Float8 along_width = from_axis.width + up.width;

    const Float8 hatch = shaders::section_hatch(along, along_width);
    const Float8 lines = shaders::section_border(through.value, through.width) *
                         shaders::section_scale(up.value + kFarMm, up.width);
    const Float8 red = shaders::load_red(load.value);
    const Float8 dark = shaders::load_dark(load.value, along, along_width);
    const Float8 pale = shaders::load_pale(load.value, load.width);
    const auto light = [&](int channel) __attribute__((always_inline)) {
        Float8 colour = look.colour[channel] * hatch;
        if (look.shows_load) {
            colour = shaders::with_load(colour, red, dark, pale, shaders::kLoadRed[channel],
                                        shaders::kLoadDark[channel], shaders::kLoadPale[channel]);
        }
        return float8::max(colour * lines, 0.0F);
    };
    return encoded({light(0), light(1), light(2)}, look.order);
}

void draw(const Shape<value::kCount>& shape, const Reach& reach, const SectionLook& look,
          const PictureCanvas& canvas) {
    const std::ptrdiff_t last = canvas.end() - kFloat8;
    std::array<Slope, value::kCount + 1> slopes;
    for (int y = reach.top; y < reach.end; ++y) {
        const int left = reach.left(y);
        const int count = reach.right(y) - left;
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * canvas.size.width + left;
        for (std::size_t number = 0; number < slopes.size(); ++number)
            slopes[number] = shape.slope(number, left, y);
        for (std::ptrdiff_t block = first; block < first + count; block += kFloat8) {
            const std::ptrdiff_t at = std::min(block, last);
            const Int8 numbers = kFirst8 + static_cast<int>(at - first);
            const Float8 in_row = float8::floats(numbers);
            const Float8 here = slopes[value::kCount].first + slopes[value::kCount].step * in_row;
            Float8 depth;
            std::memcpy(&depth, canvas.depth.data() + at, sizeof depth);
            const Int8 is_drawn = (here <= depth) & (numbers >= 0) & (numbers < count);
            if (!float8::any(is_drawn)) continue;
            const Float8 near = slopes[value::kNear].first + slopes[value::kNear].step * in_row;
            Int8 pixels;
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
        return SectionCorner{.at_px = {in_steps(at_px.x), in_steps(at_px.y)},
                             .away_mm = clip.w,
                             .depth = clip.z * near,
                             .values = {vertex.lean.x * near, vertex.place.y * near, vertex.lean.y * near,
                                        vertex.lean.z * near, near}};
    });
}

void draw_section(std::span<const SectionCorner> corners, const SectionLook& look,
                  const PictureCanvas& canvas) {
    if (canvas.pixels.size() < kFloat8) return;
    Reach reach(canvas);
    Shape<value::kCount> shape;
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
        const std::span<const SectionCorner> own = corners.subspan(first, 3);
        if (std::min({own[0].away_mm, own[1].away_mm, own[2].away_mm}) <= 0.0F) continue;
        const float area = shapes::area_of(own[0].at_px, own[1].at_px, own[2].at_px);
        if (std::abs(area) < shapes::kNoArea) continue;
        shape.corners = {&own[0], &own[1], &own[2], nullptr};
        shapes::find_slopes(shape, area);
        shapes::find_reach(shape, area > 0.0F, reach);
        draw(shape, reach, look, canvas);
    }
}

}  // namespace onggi::render
