// The shade where one thing's outline lies before another. A pixel of a photograph shows both there, and by
// its one place in the shadow mask it is shaded as if it were all of one, or of what is seen in a gap between
// them: stairs of dark and bright pixels, which are mixed here of their neighbours on both sides. Any thread.
// Pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/pixels/shadow_mask.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

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

}  // namespace onggi::render
