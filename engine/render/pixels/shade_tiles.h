// Tracks which tiles a changed shadow mask or light affects, so that the others are not shaded again. Any
// thread; one user at a time. Pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/pixels/shadow_mask.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// Smooths the shade at silhouettes of static things. A photograph's pixel there shows both sides, but its
// single place in the shadow mask shades it as one side, or as something seen in a gap between them; the
// result is stairs of dark and bright pixels. They are replaced by a mix of the neighbours on both sides. Any
// thread. Pixels.
class ShadeEdges {
  public:
    // Finds silhouettes in layers of this width by each pixel's mask_place(). Those outside the reach of
    // shadows are left out.
    void find(int width, std::span<const std::uint32_t> places);
    void forget() { edges_.clear(); }

    // Mixes silhouette pixels inside the rectangles where the shade differs between the two sides. The
    // picture has just been shaded there and is laid out like the layers.
    void smooth(const ShadowMask& mask, std::span<const PixelRect> rects, std::span<std::uint32_t> picture);

  private:
    // A silhouette pixel, and the pixels behind the silhouette's two pixels: on its own side and on the
    // other.
    struct Edge {
        std::uint32_t pixel = 0;
        std::uint32_t inner = 0;
        std::uint32_t outer = 0;
        std::array<std::uint16_t, 3> texels{};  // mask texels of these three pixels
    };
    struct Mixed {
        std::uint32_t pixel = 0;
        std::uint32_t colour = 0;
    };
    void find_at(int x, int y, std::span<const std::uint32_t> places);

    int width_ = 0;
    std::vector<Edge> edges_;              // row by row
    std::vector<std::size_t> row_begins_;  // one entry more than rows
    std::vector<Mixed> mixed_;
};

// Change of the light between frames: small enough for a tile to wait a frame for it, or not.
enum class LightChange { kLittle, kMuch };

// The tiles of a shaded picture. Each has a number that changes with its pixels: that of the frame in which
// it was shaded.
class ShadeTiles {
  public:
    // Starts with layers of this size and each pixel's mask_place(). All tiles need shading.
    void learn(const TileGrid& grid, std::span<const std::uint32_t> places);
    // The mask has changed: the tiles that read a changed texel need shading.
    void note_mask(const ShadowMask& before, const ShadowMask& now);
    // The light has changed.
    void note_light(LightChange change);
    // Returns the tiles to shade as rectangles, and assigns them `number`, which must be unused. Of the
    // tiles that may wait, every other row waits.
    void take(std::uint64_t number, std::vector<PixelRect>& rects);

    [[nodiscard]] const TileGrid& grid() const { return grid_; }
    // 0 for tiles that were never shaded.
    [[nodiscard]] std::span<const std::uint64_t> numbers() const { return numbers_; }

  private:
    // Range of mask texels that a tile reads, both ends inclusive.
    struct Reach {
        std::uint8_t left = 255;
        std::uint8_t right = 0;
        std::uint8_t top = 255;
        std::uint8_t bottom = 0;

        // `places` is not empty, see mask_place().
        void hold(std::span<const std::uint32_t> places);
    };

    TileGrid grid_;
    std::vector<Reach> reach_;
    std::vector<std::uint8_t> is_stale_;
    std::vector<std::uint8_t> may_wait_;  // for one frame, after a small change of the light
    int waiting_rows_ = 0;                // the even or the odd rows
    std::vector<std::uint8_t> is_due_;
    std::vector<std::uint64_t> numbers_;
    std::vector<std::uint16_t> changed_above_left_;  // summed-area table of changed texels
};

}  // namespace onggi::render
