// A lathe's vertices: its rows turned about the axis, moved by dents and by rings off the centre, with the
// key light that gets to each. Any thread; a pure function. mm, rad.
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
// A row has a vertex at each of the angles (seen_sectors() and even_sectors() in frame_build.h), the last
// where the first is or at the other side of a cut. `vertices` is used again.
void fill_vertices(const LatheMeshInput& input, const DirectionalLight& key,
                   std::span<const float> angles_rad, std::vector<shaders::VertexData>& vertices);

// How far dents and centres move the wall at most.
[[nodiscard]] float largest_offset_mm(const Lathe& lathe);

}  // namespace onggi::render
