// The outlines that moving things make in the picture, as pieces of line: a pixel on one of them is shared
// between what lies on its two sides. Where the picture has one sample a pixel it is smoothed by them
// (edge_pixels.h). Any thread; pure functions. mm, pixels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/render/camera.h"
#include "engine/render/scene.h"
#include "shaders/frame_data.h"

namespace onggi::render {

constexpr std::size_t kMaxEdges = 4096;

// Between two points of the picture.
struct OutlinePiece {
    vec4 from;  // xy pixels, z depth
    vec4 to;
};

// Appends a piece of an outline, from and to as a Projector gives them, unless it is next to nothing or there
// are too many.
void add_edge(const vec4& from, const vec4& to, std::vector<OutlinePiece>& edges);

// A grid of vertices as the lathe has it: rows of sectors + 1, outward faces counter-clockwise. Added are the
// edges between a face that looks at the eye and one that looks away, and the border of the first row; with
// open_sides also the two borders across the rows. Hidden ones are there too: the depth test knows.
struct EdgeView {
    const Camera& camera;
    int width_px;
    int height_px;
};
void add_grid_edges(std::span<const shaders::VertexData> vertices, int sectors, bool open_sides,
                    const EdgeView& view, std::vector<OutlinePiece>& edges);

}  // namespace onggi::render
