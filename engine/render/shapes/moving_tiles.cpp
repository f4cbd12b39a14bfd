#include "engine/render/shapes/moving_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

std::vector<Covered> covered_by_lathe(std::span<const shaders::VertexData> vertices, std::size_t rows,
                                      int sectors, const Camera& camera, int width_px, int height_px) {
    std::vector<Covered> lines(static_cast<std::size_t>(std::max(height_px, 0)));
    const mat4 matrix = view_projection(camera, width_px, height_px);
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    vec2 left_before(0.0F);
    vec2 right_before(0.0F);
    for (std::size_t row = 0; row < rows && (row + 1) * in_row <= vertices.size(); ++row) {
        vec2 left(1e9F, 0.0F);
        vec2 right(-1e9F, 0.0F);
        for (const shaders::VertexData& vertex : vertices.subspan(row * in_row, in_row)) {
            const vec4 clip = matrix * vec4(vec3(vertex.place), 1.0F);
            if (clip.w <= camera.near_mm) return std::vector<Covered>(lines.size());
            const vec2 pixel((0.5F + 0.5F * clip.x / clip.w) * static_cast<float>(width_px),
                             (0.5F + 0.5F * clip.y / clip.w) * static_cast<float>(height_px));
            if (pixel.x < left.x) left = pixel;
            if (pixel.x > right.x) right = pixel;
        }
        if (row > 0) {
            // The extreme points of two rings span a quadrilateral of the pot; a line that crosses both sides
            // passes through it.
            const float top = std::max(std::min(left.y, left_before.y), std::min(right.y, right_before.y));
            const float low = std::min(std::max(left.y, left_before.y), std::max(right.y, right_before.y));
            const auto first = static_cast<int>(std::ceil(std::max(top - 0.5F, 0.0F)));
            for (int y = first; y < height_px && static_cast<float>(y) + 0.5F <= low; ++y) {
                const auto at = [&](vec2 a, vec2 b) {
                    const float run = b.y - a.y;
                    const float fraction =
                        std::abs(run) > 1e-3F
                            ? std::clamp((static_cast<float>(y) + 0.5F - a.y) / run, 0.0F, 1.0F)
                            : 0.5F;
                    return a.x + fraction * (b.x - a.x);
                };
                Covered& line = lines[static_cast<std::size_t>(y)];
                const Covered here{at(left_before, left), at(right_before, right)};
                if (here.right - here.left > line.right - line.left) line = here;
            }
        }
        left_before = left;
        right_before = right;
    }
    return lines;
}

namespace {

// Bounding box of a row of the lathe's vertices, in pixels.
struct Extent {
    vec2 low{std::numeric_limits<float>::max()};
    vec2 high{std::numeric_limits<float>::lowest()};
};

// Returns false if part of the row is beside or behind the eye: it may then be anywhere.
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

// Marks the tiles that the pot covers completely.
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
        // Smoothing changes half a pixel to each side and reads the next pixel.
        constexpr float kReachPx = 2.0F;
        want_tiles(grid,
                   rect_about(glm::min(vec2(edge.from), vec2(edge.to)) - kReachPx,
                              glm::max(vec2(edge.from), vec2(edge.to)) + kReachPx),
                   tiles);
    }
    std::transform(tiles.begin(), tiles.end(), built.prop_tiles.begin(), tiles.begin(),
                   [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    // The faces of a cut are not rows.
    const bool is_whole = scene.lathe && !scene.lathe->cut && want_lathe(view, grid, built);
    if (scene.lathe && !is_whole) {
        const Box box = lathe_box(*scene.lathe);
        want_tiles(grid, pixels_of({&box, 1}, view.camera, view.width_px, view.height_px), tiles);
    }
    if (is_whole) note_covered(view, grid, built);
}

}  // namespace onggi::render
