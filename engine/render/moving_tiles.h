// The tiles of a picture in which something moves, as closely as its shape allows: all of them are copied
// anew every frame. Pure; any thread. Pixels.
#pragma once

#include "engine/render/frame_build.h"
#include "engine/render/lathe_edges.h"

namespace onggi::render {

// Fills moving_tiles and all of those rectangles of a frame whose lathe and edges are built.
void find_moving_tiles(const Scene& scene, const EdgeView& view, BuiltFrame& built);

}  // namespace onggi::render
