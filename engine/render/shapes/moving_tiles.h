// Finds the tiles in which something moves: all of them are copied in every frame. Pure; any thread. Pixels.
#pragma once

#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_edges.h"

namespace onggi::render {

// Fills in moving_tiles of a frame: the tiles of silhouettes, of hands and tools, and of the lathe's bounding
// box. Precondition: its lathe, edges and prop_tiles are built.
void find_moving_tiles(const Scene& scene, const EdgeView& view, BuiltFrame& built);

}  // namespace onggi::render
