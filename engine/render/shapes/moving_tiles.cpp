#include "engine/render/shapes/moving_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/render/shapes/lathe_cover.h"
#include "engine/render/shapes/projector.h"
#include "engine/render/shapes/shadow_region.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {
namespace {

// The pixels between which a row of the lathe's vertices lies.
struct Extent {
    vec2 low{std::numeric_limits<float>::max()};
    vec2 high{std::numeric_limits<float>::lowest()};
};

// False where part of it lies beside the eye or behind it: then it may be anywhere.
bool want_lathe(const EdgeView& view, const TileGrid& grid, BuiltFrame& built) {
    const Projector project(view);
    const auto in_row = static_cast<std::size_t>(built.sectors) + 1;
    Extent before;
    for (std::size_t row = 0; row < built.rows.size(); ++row) {
        Extent extent;
        for (const shaders::VertexData& vertex : std::span(built.vertices).subspan(row * in_row, in_row)) {
            const vec4 at = project(vec3(vertex.place));
            if (at.w <= view.camera.near_mm) return false;
            extent.low = glm::min(extent.low, vec2(at));
            extent.high = glm::max(extent.high, vec2(at));
        }
        if (row > 0) {
            want_tiles(grid,
                       rect_about(glm::min(before.low, extent.low) - 1.0F,
                                  glm::max(before.high, extent.high) + 1.0F),
                       built.moving_tiles);
        }
        before = extent;
    }
    return true;
}

// The tiles that the pot lies over wholly.
void note_covered(const EdgeView& view, const TileGrid& grid, BuiltFrame& built) {
    const std::vector<Covered> lines = covered_by_lathe(built.vertices, built.choice.inside, built.sectors,
                                                        view.camera, view.width_px, view.height_px);
    for (int row = 0; row < grid.down(); ++row) {
        const int top = row * kTileHeightPx;
        Covered in_all{0.0F, static_cast<float>(grid.width_px)};
        for (int y = top; y < std::min(top + kTileHeightPx, grid.height_px); ++y) {
            const Covered& line = lines[static_cast<std::size_t>(y)];
            in_all = {std::max(in_all.left, line.left), std::min(in_all.right, line.right)};
        }
        constexpr auto kWidthPx = static_cast<float>(kTileWidthPx);
        const auto first = static_cast<int>(std::ceil((in_all.left + kCoveredMarginPx) / kWidthPx));
        const auto end = static_cast<int>(std::floor((in_all.right - kCoveredMarginPx) / kWidthPx));
        for (int column = first; column < end; ++column) {
            const auto tile = static_cast<std::size_t>(row * grid.across() + column);
            // A hand may be in front of the pot.
            if (built.prop_tiles[tile] == 0) built.moving_tiles[tile] = kCovered;
        }
    }
}

}  // namespace

void find_moving_tiles(const Scene& scene, const EdgeView& view, BuiltFrame& built) {
    const TileGrid grid{view.width_px, view.height_px};
    std::vector<std::uint8_t>& tiles = built.moving_tiles;
    tiles.assign(grid.count(), 0);
    for (const OutlinePiece& edge : built.edges) {
        // Half a pixel to each side is smoothed, and reads the pixel beyond.
        constexpr float kReachPx = 2.0F;
        want_tiles(grid,
                   rect_about(glm::min(vec2(edge.from), vec2(edge.to)) - kReachPx,
                              glm::max(vec2(edge.from), vec2(edge.to)) + kReachPx),
                   tiles);
    }
    std::transform(tiles.begin(), tiles.end(), built.prop_tiles.begin(), tiles.begin(),
                   [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    // The faces of a cut are no rows.
    const bool is_whole = scene.lathe && !scene.lathe->cut && want_lathe(view, grid, built);
    if (scene.lathe && !is_whole) {
        const Box box = lathe_box(*scene.lathe);
        want_tiles(grid, pixels_of({&box, 1}, view.camera, view.width_px, view.height_px), tiles);
    }
    if (is_whole) note_covered(view, grid, built);
}

}  // namespace onggi::render
