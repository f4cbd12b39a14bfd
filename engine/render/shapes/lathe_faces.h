// Which faces of a lathe's grid are drawn: those that look at the eye, in two heaps, because a pixel that
// must ask the moving spheres for their shadow costs twice one that need not. Any thread; a pure function.
// mm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/shapes/lathe_edges.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// Two triangles a face, counter-clockwise from outside, as indices of the grid's vertices.
struct LatheFaces {
    std::vector<std::uint16_t> indices;
    std::uint32_t plain = 0;  // how many of them, at the front, no sphere's shadow reaches

    void clear() {
        indices.clear();
        plain = 0;
    }
};

// The grid as add_grid_edges() has it. `frame` says where the spheres are and where the light comes from. A
// face that is seen edge on, or of which it cannot be said, is drawn: the device looks once more.
void choose_faces(std::span<const shaders::VertexData> vertices, int sectors, const shaders::FrameData& frame,
                  const EdgeView& view, LatheFaces& faces);

// All of them, in the second heap.
void take_all_faces(std::size_t rows, int sectors, LatheFaces& faces);

}  // namespace onggi::render
