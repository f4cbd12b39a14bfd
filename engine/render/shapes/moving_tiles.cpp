#include "engine/render/shapes/moving_tiles.h"

#include <algorithm>

#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

void find_moving_tiles(const Scene& scene, const EdgeView& view, BuiltFrame& built) {
    const TileGrid grid{view.width_px, view.height_px};
    std::vector<std::uint8_t>& tiles = built.moving_tiles;
    tiles.assign(grid.count(), 0);
    for (const OutlinePiece& edge : built.edges) {
        // Smoothing changes half a pixel to each side and reads the next pixel.
        constexpr float kReachPx = 2.0F;
        want_tiles(grid,
                   rect_about(glm::min(vec2(edge.from), vec2(edge.to)) - kReachPx,
                              glm::max(vec2(edge.from), vec2(edge.to)) + kReachPx),
                   tiles);
    }
    std::transform(tiles.begin(), tiles.end(), built.prop_tiles.begin(), tiles.begin(),
                   [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    if (scene.lathe) {
        const Box box = lathe_box(*scene.lathe);
        want_tiles(grid, pixels_of({&box, 1}, view.camera, view.width_px, view.height_px), tiles);
    }
}

}  // namespace onggi::render
