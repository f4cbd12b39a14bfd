// What a lathe's radii say beyond the radii: which rings to draw, how open each is to the sky, and the
// outline's normal, filtered to what a pixel can show. Any thread; pure functions. mm.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/ring_lod.h"
#include "engine/render/scene.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// The outline as drawn: up the wall, round the top edge, flat to the axis.
struct LatheOutline {
    float wall_height_mm = 0.0F;  // where the rounding of the edge begins
    float rounding_mm = 0.0F;     // what there is room for, at most the wanted one
    float height_mm = 0.0F;
    std::span<const float> wall;  // the radii below wall_height_mm, at least one
};
[[nodiscard]] LatheOutline outline_of(const Lathe& lathe);

// One entry a ring, bottom first: base edge, chosen elements, top of the wall.
void lathe_rings(const LatheOutline& outline, float element_height_mm, const RingChoice& choice,
                 std::vector<shaders::RingData>& rings);

// The outline's outward normal (r, y) along the wall, the rounding and the top, as 16-bit signed pairs for
// the texture that fragments read. footprint_mm: how much of the wall one pixel shows; slopes are averaged
// over it, so that grooves finer than a pixel fade instead of flickering.
using NormalTexels = std::array<std::array<std::int16_t, 2>, shaders::kProfileTexels>;
void lathe_normals(const LatheOutline& outline, float element_height_mm, float footprint_mm,
                   NormalTexels& texels);

// How much of the sky's light a ring of the wall sees past the rest of the wall, 0 to 1: between the horizons
// that the profile makes above and below it, weighted by the cosine to an upright wall.
[[nodiscard]] float open_sky(std::span<const shaders::RingData> rings, std::size_t ring);

}  // namespace onggi::render
