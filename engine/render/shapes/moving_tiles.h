// Finds the tiles in which something moves, as tightly as its shape allows: all of them are copied in every
// frame. Pure; any thread. Pixels.
#pragma once

#include <span>
#include <vector>

#include "engine/render/camera.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_edges.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// The pixels that the lathe certainly covers: surfaces under them need not be drawn. Pixels.

// The part of a line of pixels that the pot certainly covers.
struct Covered {
    float left = 0.0F;
    float right = 0.0F;  // not greater than left: empty
};

// The drawn pot consists of chords of its circles; this far from the ends it certainly covers.
constexpr float kCoveredMarginPx = 2.0F;

// Returns one entry per line of pixels, from the top: the area between the two extreme points of each drawn
// ring and of the next is covered. `vertices` are the lathe's, rows of sectors + 1.
[[nodiscard]] std::vector<Covered> covered_by_lathe(std::span<const shaders::VertexData> vertices,
                                                    std::size_t rows, int sectors, const Camera& camera,
                                                    int width_px, int height_px);

// Fills in moving_tiles of a frame. Precondition: its lathe, edges and prop_tiles are built.
void find_moving_tiles(const Scene& scene, const EdgeView& view, BuiltFrame& built);

}  // namespace onggi::render
