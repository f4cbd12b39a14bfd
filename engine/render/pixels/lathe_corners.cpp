#include "engine/render/pixels/lathe_corners.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/render/pixels/light_lanes.h"
#include "engine/render/pixels/wide_vectors.h"

namespace onggi::render {
namespace {

using lanes::kLanes;
using lanes::Lanes;
using lanes::Lanes3;
using lanes::mixed;

// Vertices side by side, by the names that the shader has for what is known of them.
struct Block {
    Lanes3 place;  // mm
    Lanes3 normal;
    Lanes3 to_eye;
    Lanes outward_x;
    Lanes outward_z;
    Lanes lean;
    Lanes share;  // of a turn
    Lanes seen;
    Lanes height_mm;
    Lanes outline;
    Lanes along_mm;
    Lanes open;
    Lanes inside;
    Lanes water;
    Lanes film;
    Lanes load;
};

[[gnu::always_inline]] inline void load(const LatheGrid& grid, std::span<const std::uint32_t> numbers,
                                        Block& block) {
    const auto in_row = static_cast<std::size_t>(grid.draw.turn.y);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t number = numbers[std::min(i, numbers.size() - 1)];
        const shaders::VertexData& vertex = grid.vertices[number];
        const shaders::RowData& row = grid.rows[number / in_row];
        block.place.x[i] = vertex.place.x;
        block.place.y[i] = vertex.place.y;
        block.place.z[i] = vertex.place.z;
        block.seen[i] = vertex.place.w;
        block.outward_x[i] = vertex.lean.x;
        block.outward_z[i] = vertex.lean.z;
        block.lean[i] = vertex.lean.y;
        block.share[i] = vertex.lean.w;
        block.normal.x[i] = row.light.x;
        block.normal.y[i] = row.light.y;
        block.open[i] = row.light.z;
        block.inside[i] = row.light.w;
        block.height_mm[i] = row.place.y;
        block.outline[i] = row.place.z;
        block.along_mm[i] = row.place.w;
        block.water[i] = row.water.x;
        block.film[i] = row.water.y;
        block.load[i] = row.water.z;
    }
}

[[gnu::always_inline]] inline float one_over_length(float x, float y, float z) {
    return 1.0F / std::sqrt(x * x + y * y + z * z);
}

// From the row's normal in its half plane to the vertex's own.
[[gnu::always_inline]] inline void turn_normals(Block& block) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float across = block.normal.x[i];
        const float x = across * block.outward_x[i];
        const float y = block.normal.y[i] - across * block.lean[i];
        const float z = across * block.outward_z[i];
        const float share = one_over_length(x, y, z);
        block.normal.x[i] = x * share;
        block.normal.y[i] = y * share;
        block.normal.z[i] = z * share;
    }
}

// What of the sky is left by what it stands on, and by the moving spheres: sky_past_sphere() of
// shaders/surface.glsl.
[[gnu::always_inline]] inline void hide_sky(const shaders::FrameData& frame, Block& block) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float near_ground = 0.55F * lanes::exp_below_0(-0.07F * block.height_mm[i]);
        block.open[i] *= 1.0F - near_ground * (1.0F - block.normal.y[i]) * (1.0F - block.inside[i]);
    }
    for (const vec4& sphere : frame.spheres) {
        const vec3 at(sphere);
        const float square = sphere.w * sphere.w;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float x = at.x - block.place.x[i];
            const float y = at.y - block.place.y[i];
            const float z = at.z - block.place.z[i];
            const float nearness = 1.0F / std::sqrt(std::max(x * x + y * y + z * z, square));
            const float towards = block.normal.x[i] * x + block.normal.y[i] * y + block.normal.z[i] * z;
            const float cosine = std::min(std::max(towards * nearness, 0.0F), 1.0F);
            block.open[i] *= 1.0F - cosine * square * nearness * nearness;
        }
    }
}

struct Answer {
    Lanes half;                    // see lathe_value
    std::array<Lanes, 3> ambient;  // without the body's colour
    std::array<Lanes, 3> mirrored;
};

[[gnu::always_inline]] inline void answer_light(const LatheGrid& grid, Block& block, Answer& answer) {
    const vec3 eye(grid.frame.eye);
    const vec3 light(grid.frame.key_direction);
    Lanes3 from;
    Lanes3 mirrored;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float nx = block.normal.x[i];
        const float ny = block.normal.y[i];
        const float nz = block.normal.z[i];
        // Deep inside, what light there is comes down through the mouth.
        const float upward = block.inside[i] * 0.75F * (1.0F - block.open[i]);
        const float fx = nx - nx * upward;
        const float fy = mixed(ny, 1.0F, upward);
        const float fz = nz - nz * upward;
        const float of_from = one_over_length(fx, fy, fz);
        from.x[i] = fx * of_from;
        from.y[i] = fy * of_from;
        from.z[i] = fz * of_from;

        float vx = eye.x - block.place.x[i];
        float vy = eye.y - block.place.y[i];
        float vz = eye.z - block.place.z[i];
        const float of_view = one_over_length(vx, vy, vz);
        vx *= of_view;
        vy *= of_view;
        vz *= of_view;
        block.to_eye.x[i] = vx;
        block.to_eye.y[i] = vy;
        block.to_eye.z[i] = vz;
        const float l_v = light.x * vx + light.y * vy + light.z * vz;
        answer.half[i] = 1.0F / std::sqrt(std::max(2.0F + 2.0F * l_v, 1e-4F));
        const float twice = 2.0F * (nx * vx + ny * vy + nz * vz);
        mirrored.x[i] = twice * nx - vx;
        mirrored.y[i] = twice * ny - vy;
        mirrored.z[i] = twice * nz - vz;
    }
    Lanes roughness;
    roughness.fill(mixed(0.30F, 0.20F, grid.draw.gloss.w));
    lanes::mirror_sky(grid.frame, mirrored, roughness, answer.mirrored);
    for (int channel = 0; channel < 3; ++channel)
        lanes::light_softly(grid.frame, from, channel, answer.ambient[static_cast<std::size_t>(channel)]);
    for (int channel = 0; channel < 3; ++channel) {
        const float dry = grid.draw.dry[channel];
        const float wet = grid.draw.wet[channel];
        Lanes& ambient = answer.ambient[static_cast<std::size_t>(channel)];
        Lanes& mirror = answer.mirrored[static_cast<std::size_t>(channel)];
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float open = block.open[i];
            const float albedo = mixed(dry, wet, block.water[i]);
            ambient[i] *= albedo * (open * (1.0F + albedo * (1.0F - open) * 1.6F));
            mirror[i] *= open;
        }
    }
}

[[gnu::always_inline]] inline void store(const LatheGrid& grid, const Block& block, const Answer& answer,
                                         const lanes::Corners3& at, std::span<const std::uint32_t> numbers,
                                         LatheCorner* into) {
    static_assert(lathe_value::kLoad == lathe_value::kHalf);
    const Lanes& half = grid.shows_load ? block.load : answer.half;
    const auto across = static_cast<float>(grid.slip.across);
    const auto up = static_cast<float>(grid.slip.up);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const float near = at.away_mm[i] > 0.0F ? 1.0F / at.away_mm[i] : 0.0F;
        into[numbers[i]] = {
            .at_px = {at.at.x[i], at.at.y[i]},
            .away_mm = at.away_mm[i],
            .depth = at.at.z[i],
            .values = {block.to_eye.x[i],
                       block.to_eye.y[i],
                       block.to_eye.z[i],
                       block.outward_x[i],
                       block.outward_z[i],
                       near * across * (2.0F * block.share[i] + grid.draw.turn.x + kSlipWidthsMore),
                       near * up * (block.along_mm[i] / kSlipMm),
                       block.outline[i] * static_cast<float>(shaders::kProfileTexels),
                       block.seen[i],
                       block.water[i],
                       block.film[i],
                       block.lean[i],
                       half[i],
                       answer.ambient[0][i],
                       answer.ambient[1][i],
                       answer.ambient[2][i],
                       answer.mirrored[0][i],
                       answer.mirrored[1][i],
                       answer.mirrored[2][i],
                       near,
                       block.place.x[i],
                       block.place.y[i],
                       block.place.z[i],
                       at.at.z[i]}};
    }
}

[[gnu::always_inline]] inline void light_all(const LatheGrid& grid, std::span<const std::uint32_t> numbers,
                                             LatheCorner* into) {
    Block block;
    Answer answer;
    lanes::Corners3 at;
    for (std::size_t first = 0; first < numbers.size(); first += kLanes) {
        const auto own = numbers.subspan(first, std::min(kLanes, numbers.size() - first));
        load(grid, own, block);
        turn_normals(block);
        hide_sky(grid.frame, block);
        answer_light(grid, block, answer);
        lanes::project(grid.frame, block.place, at);
        store(grid, block, answer, at, own, into);
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
    best(grid, lanes::vertices_of(indices, corners.size()), corners.data());
}

}  // namespace onggi::render
