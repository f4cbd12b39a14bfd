// A lathe's vertices: its rows turned about the axis and displaced by dents and off-centre rings, with the
// key light that reaches each vertex. Any thread; a pure function. mm, rad.
#pragma once

#include <span>
#include <vector>

#include "engine/render/scene.h"
#include "engine/render/shapes/lathe_light.h"
#include "engine/render/shapes/lathe_rows.h"
#include "shaders/frame_data.h"

namespace onggi::render {

struct LatheMeshInput {
    const Lathe& lathe;
    const LatheProfile& profile;
    const LatheSamples& samples;
    const LatheRows& chosen;
    std::span<const shaders::RowData> rows;
};
// Each row has a vertex at each of the angles (seen_sectors() and even_sectors() in frame_build.h); the last
// vertex coincides with the first or is on the other side of a cut. Reuses the memory of `vertices`.
void fill_vertices(const LatheMeshInput& input, const DirectionalLight& key,
                   std::span<const float> angles_rad, std::vector<shaders::VertexData>& vertices);

// Maximum displacement of the wall by dents and centres.
[[nodiscard]] float largest_offset_mm(const Lathe& lathe);

}  // namespace onggi::render
