// The outlines of hands and tools: see lathe_edges.h. Any thread; pure functions. mm, pixels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/prop_faces.h"

namespace onggi::render {

// Where two triangles of a mesh meet, wherever their corners are in its lists; or where one ends.
struct MeshEdge {
    std::array<std::uint32_t, 2> corners{};
    std::array<std::uint32_t, 2>
        faces{};  // numbers of triangles; the second is the first where there is none
};
// Once a mesh. Where more than two triangles meet, the first two do.
[[nodiscard]] std::vector<MeshEdge> mesh_edges(const PropMesh& mesh);

// `towards_eye`: see faces_towards(). Appends the edges between a triangle that looks at the eye and one that
// looks away, and the borders of what looks at it, but for what is inside the pot (null: there is none).
// Other hidden ones are there too: the depth test knows.
void add_prop_edges(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                    std::span<const MeshEdge> mesh_edges, const InsidePot* pot, const EdgeView& view,
                    std::vector<OutlinePiece>& edges);

}  // namespace onggi::render
