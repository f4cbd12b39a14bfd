// The picture as tiles, and which of them a changed shadow mask makes another picture of, so that what has
// not changed is not shaded again. Any thread; one user at a time. Pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/shadow_mask.h"
#include "engine/render/shadow_region.h"

namespace onggi::render {

constexpr int kTileWidthPx = 32;
constexpr int kTileHeightPx = 8;

// How a picture is laid out in tiles, row by row; those at the right and at the bottom may be cut off.
struct TileGrid {
    int width_px = 0;
    int height_px = 0;

    [[nodiscard]] int across() const { return (width_px + kTileWidthPx - 1) / kTileWidthPx; }
    [[nodiscard]] int down() const { return (height_px + kTileHeightPx - 1) / kTileHeightPx; }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(across() * down()); }
    friend bool operator==(const TileGrid&, const TileGrid&) = default;
};

// The pixels that a box with these corners, in pixels, touches.
[[nodiscard]] PixelRect rect_about(vec2 low, vec2 high);

// Calls with the number of each tile that a rectangle touches, part of which may lie outside the picture.
template <typename Visit>
void for_tiles(const TileGrid& grid, const PixelRect& rect, Visit visit) {
    if (rect.width <= 0 || rect.height <= 0) return;
    const int left = std::max(rect.x, 0) / kTileWidthPx;
    const int top = std::max(rect.y, 0) / kTileHeightPx;
    const int right = std::min((rect.x + rect.width - 1 + kTileWidthPx) / kTileWidthPx, grid.across());
    const int bottom = std::min((rect.y + rect.height - 1 + kTileHeightPx) / kTileHeightPx, grid.down());
    for (int row = top; row < bottom; ++row) {
        for (int column = left; column < right; ++column)
            visit(static_cast<std::size_t>(row * grid.across() + column));
    }
}

// What a frame draws over a tile.
constexpr std::uint8_t kNothingMoves = 0;
constexpr std::uint8_t kMoves = 1;    // something, in parts of it
constexpr std::uint8_t kCovered = 2;  // something over all of it: nobody sees what lies under that

// Wants the tiles that a rectangle touches.
void want_tiles(const TileGrid& grid, const PixelRect& rect, std::span<std::uint8_t> wanted);

// Rectangles, none over another, that are together the wanted tiles (one entry a tile, 0 or not).
void rects_of_tiles(const TileGrid& grid, std::span<const std::uint8_t> wanted,
                    std::vector<PixelRect>& rects);

// One rectangle of a picture, whose rows are this wide, into the same place of another.
template <typename Pixel>
void copy_rect(std::span<const Pixel> from, const PixelRect& rect, std::size_t width_px,
               std::span<Pixel> into) {
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
        const auto first =
            static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * width_px) + std::ptrdiff_t{rect.x};
        std::copy_n(from.begin() + first, rect.width, into.begin() + first);
    }
}

// From one frame to the next: so little that a tile may wait a frame for it, or not.
enum class LightChange { kLittle, kMuch };

// A shaded picture's tiles. Each has a number, another whenever its pixels become others.
class ShadeTiles {
  public:
    // For layers of this size, each of whose pixels lies at a place of the mask (mask_place()). Every tile
    // has to be shaded.
    void learn(const TileGrid& grid, std::span<const std::uint32_t> places);
    // The mask becomes another: the tiles that read a texel which differs have to be shaded.
    void note_mask(const ShadowMask& before, const ShadowMask& now);
    // The light becomes another.
    void note_light(LightChange change);
    // The tiles that have to be shaded, as rectangles; from here on they count as shaded. Those that are
    // covered wait until they are seen, and every other row of those that may wait. `moving`: one entry a
    // tile, or empty: nothing moves.
    void take(std::span<const std::uint8_t> moving, std::vector<PixelRect>& rects);

    [[nodiscard]] const TileGrid& grid() const { return grid_; }
    [[nodiscard]] std::span<const std::uint64_t> numbers() const { return numbers_; }

  private:
    // Texels of the mask that a tile reads, both ends included.
    struct Reach {
        std::uint8_t left = 255;
        std::uint8_t right = 0;
        std::uint8_t top = 255;
        std::uint8_t bottom = 0;

        // At least one, see mask_place().
        void hold(std::span<const std::uint32_t> places);
    };

    TileGrid grid_;
    std::vector<Reach> reach_;
    std::vector<std::uint8_t> is_stale_;
    std::vector<std::uint8_t> may_wait_;  // of a little other light; one frame
    int waiting_rows_ = 0;                // the even ones or the odd ones
    std::vector<std::uint8_t> is_due_;
    std::vector<std::uint64_t> numbers_;
    std::uint64_t last_number_ = 0;  // never used again, so that a target cannot take new layers for old
    std::vector<std::uint16_t> changed_above_left_;  // how many texels have changed, summed over both axes
};

}  // namespace onggi::render
