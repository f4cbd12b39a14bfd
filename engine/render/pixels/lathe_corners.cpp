#include "engine/render/pixels/lathe_corners.h"

#include <algorithm>
#include <array>

#include "engine/math/wide_vectors.h"
#include "engine/render/pixels/corners8.h"
#include "shaders/lathe.h"

// No vector leaves this file by value, see float8.h.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render {
namespace {

// Eight vertices.
struct Vertices8 {
    Float8x3 place;  // mm
    Float8x3 normal;
    Float8 outward_x;
    Float8 outward_z;
    Float8 lean;
    Float8 turned;  // fraction of a turn
    Float8 seen;
    Float8 height_mm;
    Float8 outline;
    Float8 along_mm;
    Float8 open;
    Float8 inside;
    Float8 water;
    Float8 film;
    Float8 load;
};

// Fewer than eight vertices are padded with the last one.
[[gnu::always_inline]] inline void load(const LatheGrid& grid, std::span<const std::uint32_t> numbers,
                                        Vertices8& into) {
    const auto in_row = static_cast<std::size_t>(grid.draw.turn.y);
    for (int i = 0; i < kFloat8; ++i) {
        const std::size_t number = numbers[std::min(static_cast<std::size_t>(i), numbers.size() - 1)];
        const shaders::VertexData& vertex = grid.vertices[number];
        const shaders::RowData& row = grid.rows[number / in_row];
        into.place.x[i] = vertex.place.x;
        into.place.y[i] = vertex.place.y;
        into.place.z[i] = vertex.place.z;
        into.seen[i] = vertex.place.w;
        into.outward_x[i] = vertex.lean.x;
        into.outward_z[i] = vertex.lean.z;
        into.lean[i] = vertex.lean.y;
        into.turned[i] = vertex.lean.w;
        into.normal.x[i] = row.light.x;
        into.normal.y[i] = row.light.y;
        into.open[i] = row.light.z;
        into.inside[i] = row.light.w;
        into.height_mm[i] = row.place.y;
        into.outline[i] = row.place.z;
        into.along_mm[i] = row.place.w;
        into.water[i] = row.water.x;
        into.film[i] = row.water.y;
        into.load[i] = row.water.z;
    }
}

struct Answer8 {
    Float8x3 to_eye;   // unit
    Float8 half;       // see lathe_value
    Colour8 ambient;   // of the body's own colour
    Colour8 mirrored;  // of the sky
};

[[gnu::always_inline]] inline void answer_light(const LatheGrid& grid, Vertices8& own, Answer8& answer) {
    const shaders::FrameData& frame = grid.frame;
    // From the row's normal in its half plane to the vertex's normal.
    const Float8 across = own.normal.x;
    own.normal =
        normalised({across * own.outward_x, own.normal.y - across * own.lean, across * own.outward_z});
    const Float8x3& n = own.normal;
    Float8 open = shaders::lathe_open(own.open, own.height_mm, n.y, own.inside);
    for (const vec4& sphere : frame.spheres)
        open *= shaders::sky_past_sphere(sphere, own.place, n);
    const Float8 from_mouth = shaders::lathe_from_mouth(own.inside, open);
    const Float8x3 from =
        normalised({n.x - n.x * from_mouth, float8::mix(n.y, 1.0F, from_mouth), n.z - n.z * from_mouth});
    answer.to_eye = towards(vec3(frame.eye), own.place);
    answer.half = shaders::half_of(dot(answer.to_eye, vec3(frame.key_direction)));
    find_sky_radiance(frame, mirrored(n, answer.to_eye), shaders::lathe_sky_roughness(grid.draw.gloss.w),
                      answer.mirrored);
    find_sky_diffuse(frame, from, answer.ambient);
    for (int channel = 0; channel < 3; ++channel) {
        const Float8 albedo = float8::mix(grid.draw.dry[channel], grid.draw.wet[channel], own.water);
        const auto number = static_cast<std::size_t>(channel);
        answer.ambient[number] *= albedo * shaders::open_sky_colour(open, albedo);
        answer.mirrored[number] *= open;
    }
}

[[gnu::always_inline]] inline void store(const LatheGrid& grid, const Vertices8& own, const Answer8& answer,
                                         const Placed8& at, std::span<const std::uint32_t> numbers,
                                         LatheCorner* into) {
    static_assert(lathe_value::kLoad == lathe_value::kHalf);
    const Float8& half = grid.shows_load ? own.load : answer.half;
    const auto texels_across = static_cast<float>(grid.streaks.across);
    const auto texels_up = static_cast<float>(grid.streaks.up);
    const Int8 is_before = at.away_mm > 0.0F;
    const Float8 near = float8::select(is_before, 1.0F / float8::select(is_before, at.away_mm, 1.0F), 0.0F);
    const Float8 streaks_across =
        near * texels_across * (2.0F * own.turned + grid.draw.turn.x + kStreakWidthsMore);
    const Float8 streaks_up = near * texels_up * (own.along_mm / shaders::kStreakMm);
    const Float8 outline = own.outline * static_cast<float>(shaders::kProfileTexels);
    const std::array<const Float8*, lathe_value::kCount> values{&answer.to_eye.x,
                                                                &answer.to_eye.y,
                                                                &answer.to_eye.z,
                                                                &own.outward_x,
                                                                &own.outward_z,
                                                                &streaks_across,
                                                                &streaks_up,
                                                                &outline,
                                                                &own.seen,
                                                                &own.water,
                                                                &own.film,
                                                                &own.lean,
                                                                &half,
                                                                &answer.ambient[0],
                                                                &answer.ambient[1],
                                                                &answer.ambient[2],
                                                                &answer.mirrored[0],
                                                                &answer.mirrored[1],
                                                                &answer.mirrored[2],
                                                                &near,
                                                                &own.place.x,
                                                                &own.place.y,
                                                                &own.place.z,
                                                                &at.at.z};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto lane = static_cast<int>(i);
        LatheCorner& corner = into[numbers[i]];
        corner.at_px = {at.at.x[lane], at.at.y[lane]};
        corner.away_mm = at.away_mm[lane];
        corner.depth = at.at.z[lane];
        for (std::size_t value = 0; value < values.size(); ++value)
            corner.values[value] = (*values[value])[lane];
    }
}

[[gnu::always_inline]] inline void light_all(const LatheGrid& grid, std::span<const std::uint32_t> numbers,
                                             LatheCorner* into) {
    Vertices8 vertices{};
    Answer8 answer;
    for (std::size_t first = 0; first < numbers.size(); first += kFloat8) {
        const auto own = numbers.subspan(first, std::min(std::size_t{kFloat8}, numbers.size() - first));
        load(grid, own, vertices);
        answer_light(grid, vertices, answer);
        store(grid, vertices, answer, project(grid.frame, vertices.place), own, into);
    }
}

void light_plain(const LatheGrid& grid, std::span<const std::uint32_t> numbers, LatheCorner* into) {
    light_all(grid, numbers, into);
}

ONGGI_WIDE_VECTORS void light_wide(const LatheGrid& grid, std::span<const std::uint32_t> numbers,
                                   LatheCorner* into) {
    light_all(grid, numbers, into);
}

}  // namespace

void light_corners(const LatheGrid& grid, std::span<const std::uint16_t> indices,
                   std::vector<LatheCorner>& corners) {
    static auto* const best = best_of(light_plain, light_wide);
    corners.resize(grid.vertices.size());
    best(grid, vertices_of(indices, corners.size()), corners.data());
}

}  // namespace onggi::render
