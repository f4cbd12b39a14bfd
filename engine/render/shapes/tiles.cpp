#include "engine/render/shapes/tiles.h"

namespace onggi::render {
namespace {

// std::floor is a library call on the oldest supported instruction set.
glm::ivec2 floored(vec2 at) {
    const glm::ivec2 whole(at);
    return whole - glm::ivec2(glm::lessThan(at, vec2(whole)));
}

}  // namespace

PixelRect rect_about(vec2 low, vec2 high) {
    if (!(low.x <= high.x && low.y <= high.y)) return {};  // NaN
    // Far outside of any picture a float does not fit into an int.
    constexpr float kFarPx = 1e6F;
    const glm::ivec2 from = floored(glm::clamp(low, -kFarPx, kFarPx));
    const glm::ivec2 to = -floored(-glm::clamp(high, -kFarPx, kFarPx));
    return {from.x, from.y, to.x - from.x, to.y - from.y};
}

void want_tiles(const TileGrid& grid, const PixelRect& rect, std::span<std::uint8_t> wanted) {
    for_tiles(grid, rect, [&](std::size_t tile) { wanted[tile] = 1; });
}

void rects_of_tiles(const TileGrid& grid, std::span<const std::uint8_t> wanted,
                    std::vector<PixelRect>& rects) {
    rects.clear();
    const auto across = static_cast<std::size_t>(grid.across());
    std::size_t above = 0;  // the first rectangle that ends where this row of tiles begins
    for (int row = 0; row < grid.down(); ++row) {
        const int y = row * kTileHeightPx;
        const int height = std::min(kTileHeightPx, grid.height_px - y);
        const std::span<const std::uint8_t> tiles =
            wanted.subspan(static_cast<std::size_t>(row) * across, across);
        const std::size_t first = rects.size();
        for (std::size_t at = 0; at < across;) {
            if (tiles[at] == 0) {
                ++at;
                continue;
            }
            const int x = static_cast<int>(at) * kTileWidthPx;
            while (at < across && tiles[at] != 0)
                ++at;
            const int width = std::min(static_cast<int>(at) * kTileWidthPx, grid.width_px) - x;
            rects.push_back({x, y, width, height});
        }
        // A row of tiles equal to the row above extends the rectangles of that row.
        const std::size_t here = rects.size() - first;
        const bool is_as_above =
            here > 0 && here == first - above &&
            std::equal(rects.begin() + static_cast<std::ptrdiff_t>(first), rects.end(),
                       rects.begin() + static_cast<std::ptrdiff_t>(above),
                       [](const PixelRect& low, const PixelRect& high) {
                           return low.x == high.x && low.width == high.width && high.y + high.height == low.y;
                       });
        if (is_as_above) {
            rects.resize(first);
            for (std::size_t grown = above; grown < first; ++grown)
                rects[grown].height += height;
        } else {
            above = first;
        }
    }
}

}  // namespace onggi::render
