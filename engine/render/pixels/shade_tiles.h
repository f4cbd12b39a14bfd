// Which tiles of the picture a changed shadow mask makes another picture of, so that what has not changed is
// not shaded again. Any thread; one user at a time. Pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/pixels/shadow_mask.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// The shade where one thing's outline lies before another. A pixel of a photograph shows both there, and by
// its one place in the shadow mask it is shaded as if it were all of one, or of what is seen in a gap
// between them: stairs of dark and bright pixels, which are mixed here of their neighbours on both sides.
// Any thread. Pixels.
class ShadeEdges {
  public:
    // Looks for outlines in layers of this width, by each pixel's mask_place(). Those that no shadow can
    // reach are left out.
    void find(int width, std::span<const std::uint32_t> places);
    void forget() { edges_.clear(); }

    // Where the shade on the two sides differs, inside the rectangles of a picture that has just been shaded
    // there and is laid out as the layers are.
    void smooth(const ShadowMask& mask, std::span<const PixelRect> rects, std::span<std::uint32_t> picture);

  private:
    // A pixel at an outline, and those next to the outline's two pixels: on its own side and on the other.
    struct Edge {
        std::uint32_t pixel = 0;
        std::uint32_t inner = 0;
        std::uint32_t outer = 0;
        std::array<std::uint16_t, 3> texels{};  // of the mask, in which these three lie
    };
    struct Mixed {
        std::uint32_t pixel = 0;
        std::uint32_t colour = 0;
    };
    void find_at(int x, int y, std::span<const std::uint32_t> places);

    int width_ = 0;
    std::vector<Edge> edges_;              // row by row
    std::vector<std::size_t> row_begins_;  // one more than there are rows
    std::vector<Mixed> mixed_;
};

// From one frame to the next: so little that a tile may wait a frame for it, or not.
enum class LightChange { kLittle, kMuch };

// A shaded picture's tiles. Each has a number, another whenever its pixels become others: that of the frame
// in which they were shaded.
class ShadeTiles {
  public:
    // For layers of this size, each of whose pixels lies at a place of the mask (mask_place()). Every tile
    // has to be shaded.
    void learn(const TileGrid& grid, std::span<const std::uint32_t> places);
    // The mask becomes another: the tiles that read a texel which differs have to be shaded.
    void note_mask(const ShadowMask& before, const ShadowMask& now);
    // The light becomes another.
    void note_light(LightChange change);
    // The tiles that have to be shaded, as rectangles; from here on they count as shaded and have this
    // number, which no picture has had. Those that are covered wait until they are seen, and every other row
    // of those that may wait. `moving`: one entry a tile, or empty: nothing moves.
    void take(std::span<const std::uint8_t> moving, std::uint64_t number, std::vector<PixelRect>& rects);

    [[nodiscard]] const TileGrid& grid() const { return grid_; }
    // 0 of those that were never shaded.
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
    std::vector<std::uint16_t> changed_above_left_;  // how many texels have changed, summed over both axes
};

}  // namespace onggi::render
