// The tiles of a picture in which something moves, as closely as its shape allows: all of them are copied
// anew every frame. Pure; any thread. Pixels.
#pragma once

#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_edges.h"

namespace onggi::render {

// Fills moving_tiles of a frame whose lathe and edges are built, and whose prop_tiles are known.
void find_moving_tiles(const Scene& scene, const EdgeView& view, BuiltFrame& built);

}  // namespace onggi::render
