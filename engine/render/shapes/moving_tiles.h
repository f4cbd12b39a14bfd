// The tiles of a picture in which something moves, as closely as its shape allows: all of them are copied
// anew every frame. Pure; any thread. Pixels.
#pragma once

#include <span>
#include <vector>

#include "engine/render/camera.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_edges.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// The pixels that the lathe covers for sure: what lies under them need not be made.
// Pixels.

// Where a line across the picture passes the pot for sure.
struct Covered {
    float left = 0.0F;
    float right = 0.0F;  // not above left: nowhere
};

// What is drawn of the pot are chords of its circles: this far from its ends it covers for sure.
constexpr float kCoveredMarginPx = 2.0F;

// One entry a line of pixels, the first at the top: what lies between the two ends of a ring that is drawn,
// and between those of one ring and the next, is pot. `vertices` are the lathe's, rows of sectors + 1.
[[nodiscard]] std::vector<Covered> covered_by_lathe(std::span<const shaders::VertexData> vertices,
                                                    std::size_t rows, int sectors, const Camera& camera,
                                                    int width_px, int height_px);

// Fills moving_tiles of a frame whose lathe and edges are built, and whose prop_tiles are known.
void find_moving_tiles(const Scene& scene, const EdgeView& view, BuiltFrame& built);

}  // namespace onggi::render
