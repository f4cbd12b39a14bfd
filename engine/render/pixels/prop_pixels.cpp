#include "engine/render/pixels/prop_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "engine/math/wide_vectors.h"
#include "engine/render/pixels/corners8.h"
#include "engine/render/pixels/encode8.h"
#include "shaders/curve.h"
#include "shaders/hand.h"
#include "shaders/shadow.h"
#include "shaders/transfer.h"

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
    const std::ptrdiff_t last = canvas.end() - kFloat8;
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
        const int left = reach.left(y);
        const int count = reach.right(y) - left;
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

ONGGI_WIDE_VECTORS void draw_all(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                                 const PictureCanvas& canvas) {
    if (canvas.pixels.size() < kFloat8) return;
    Reach reach(canvas);
    Shape<3> shape;
    for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
        const auto own = triangle(corners, indices, first);
        if (is_behind_eye(own)) continue;
        shape.corners = {own[0], own[1], own[2], nullptr};
        const float area = shapes::area_of(own[0]->at_px, own[1]->at_px, own[2]->at_px);
        if (std::abs(area) < shapes::kNoArea) continue;
        shapes::find_reach(shape, area > 0.0F, reach);
        if (reach.top >= reach.end) continue;
        shapes::find_slopes(shape, area);
        draw(shape, reach, canvas);
    }
}

}  // namespace

void draw_triangles(std::span<const PropCorner> corners, std::span<const std::uint32_t> indices,
                    const PictureCanvas& canvas) {
    draw_all(corners, indices, canvas);
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

namespace {

// Eight vertices.
struct Vertices8 {
    Float8x3 place;  // mm
    Float8x3 normal;
    Float8 tone;  // tone, smear and open: 0 to 1
    Float8 smear;
    Float8 open;
};

// Fewer than eight vertices are padded with the last one.
[[gnu::always_inline]] inline void load(std::span<const PropMesh::Vertex> vertices,
                                        std::span<const std::uint32_t> numbers, const mat4& place,
                                        Vertices8& into) {
    constexpr float kOneOver255 = 1.0F / 255.0F;
    for (int i = 0; i < kFloat8; ++i) {
        const PropMesh::Vertex& vertex =
            vertices[numbers[std::min(static_cast<std::size_t>(i), numbers.size() - 1)]];
        into.place.x[i] = vertex.position_mm.x;
        into.place.y[i] = vertex.position_mm.y;
        into.place.z[i] = vertex.position_mm.z;
        into.normal.x[i] = vertex.normal.x;
        into.normal.y[i] = vertex.normal.y;
        into.normal.z[i] = vertex.normal.z;
        into.tone[i] = static_cast<float>(vertex.tone) * kOneOver255;
        into.smear[i] = static_cast<float>(vertex.smear) * kOneOver255;
        into.open[i] = static_cast<float>(vertex.open_sky) * kOneOver255;
    }
    const auto turned = [&](const Float8x3& a, float w) __attribute__((always_inline)) {
        const auto row = [&](int i) __attribute__((always_inline)) {
            return place[0][i] * a.x + place[1][i] * a.y + place[2][i] * a.z + place[3][i] * w;
        };
        return Float8x3{row(0), row(1), row(2)};
    };
    into.place = turned(into.place, 1.0F);
    into.normal = normalised(turned(into.normal, 0.0F));
}

// past_lathe_to_light() of shaders/lathe_shadow.glsl, starting a little off the skin.
[[gnu::always_inline]] inline Float8 seen_past_lathe(const PropView& view, const Vertices8& own) {
    const float height = view.frame.lathe.x;
    if (height <= 0.0F) return Float8{} + 1.0F;
    constexpr int kSteps = 16;
    constexpr float kBeforeMm = 2.0F;
    const vec3 light(view.frame.key_direction);
    const float rise = std::max(light.y, 0.05F);
    const vec2 foot(view.frame.lathe_foot);
    const Float8 px = own.place.x + kBeforeMm * own.normal.x;
    const Float8 py = own.place.y + kBeforeMm * own.normal.y;
    const Float8 pz = own.place.z + kBeforeMm * own.normal.z;
    const Float8 from = shaders::slab_from(py, rise);
    const Float8 step = (shaders::slab_to(py, rise, height) - from) / static_cast<float>(kSteps);
    Float8 least = Float8{} + 1e3F;
    for (int number = 0; number < kSteps; ++number) {
        const Float8 t = from + step * (static_cast<float>(number) + 0.5F);
        const Float8 sample =
            float8::clamp((py + light.y * t) * view.frame.lathe.y, 0.0F, LatheSamples::kCount - 1.0F);
        const Float8 outline_mm = float8::looked_up(view.samples.outer_mm.data(), float8::ints(sample));
        least = float8::min(least, shaders::past_outline(px + light.x * t - foot.x, pz + light.z * t - foot.y,
                                                         outline_mm, t));
    }
    return float8::select(step > 0.0F, shaders::past_least(least, view.frame.key_direction.w), 1.0F);
}

[[gnu::always_inline]] inline void light_block(const PropMesh& mesh, const Prop& prop, const PropView& view,
                                               const Vertices8& own, Colour8& shown) {
    const shaders::FrameData& frame = view.frame;
    const vec3 key_from(frame.key_direction);
    const Float8 metalness = mesh.metalness * (1.0F - own.smear);
    const Float8 roughness = shaders::hand_roughness(mesh.roughness, prop.wetness, own.smear);
    const Float8x3 v = towards(vec3(frame.eye), own.place);
    const Float8 n_v = dot(own.normal, v);
    const Float8 n_l = dot(own.normal, key_from);
    const Float8 key = seen_past_lathe(view, own) * shaders::hand_key_seen(own.open);
    const Float8 lit = shaders::hand_lit(n_l);
    const Float8 gleam = shaders::hand_gleam(n_l, n_v, dot(v, key_from), roughness);
    Colour8 reflected;
    Colour8 diffuse;
    find_sky_radiance(frame, mirrored(own.normal, v), roughness, reflected);
    find_sky_diffuse(frame, own.normal, diffuse);
    for (int channel = 0; channel < 3; ++channel) {
        const auto number = static_cast<std::size_t>(channel);
        const Float8 albedo =
            shaders::hand_albedo(mesh.albedo[channel], prop.smear[channel], own.tone, own.smear);
        const Float8 ambient = shaders::hand_ambient(albedo, metalness, roughness, float8::max(n_v, 0.0F),
                                                     own.open, diffuse[number], reflected[number]);
        const Float8 straight_on = shaders::hand_mirror(mesh.albedo[channel], metalness);
        const Float8 light = ambient + frame.key_radiance[channel] * key *
                                           (albedo * (1.0F - metalness) * lit + straight_on * gleam);
        const Float8 above_0 = float8::max(light, 0.0F);
        shown[number] =
            255.0F * shaders::transferred(float8::min(above_0 / shaders::curve_under(above_0), 1.0F));
    }
}

ONGGI_WIDE_VECTORS void light_all(const PropMesh& mesh, std::span<const std::uint32_t> numbers,
                                  const Prop& prop, const PropView& view, PropCorner* into) {
    const std::size_t first_byte = view.order == ByteOrder::kRedFirst ? 0 : 2;
    Vertices8 vertices{};
    Colour8 shown;
    for (std::size_t first = 0; first < numbers.size(); first += kFloat8) {
        const auto own = numbers.subspan(first, std::min(std::size_t{kFloat8}, numbers.size() - first));
        load(mesh.vertices, own, prop.place, vertices);
        light_block(mesh, prop, view, vertices, shown);
        const Placed8 placed = project(view.frame, vertices.place);
        for (std::size_t i = 0; i < own.size(); ++i) {
            const auto lane = static_cast<int>(i);
            into[own[i]] = {.at_px = {placed.at.x[lane], placed.at.y[lane]},
                            .away_mm = placed.away_mm[lane],
                            .depth = placed.at.z[lane],
                            .values = {shown[first_byte][lane], shown[1][lane], shown[2 - first_byte][lane]}};
        }
    }
}

}  // namespace

void light_corners(const PropMesh& mesh, std::span<const std::uint32_t> indices, const Prop& prop,
                   const PropView& view, std::vector<PropCorner>& corners) {
    const std::size_t first = corners.size();
    corners.resize(first + mesh.vertices.size());
    light_all(mesh, vertices_of(indices, mesh.vertices.size()), prop, view, corners.data() + first);
}

}  // namespace onggi::render
