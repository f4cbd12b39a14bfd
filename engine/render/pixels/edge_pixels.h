// Anti-aliases silhouettes of a picture with one sample per pixel, for the CPU backend. Any thread; one user
// of a canvas at a time. Pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

class EdgePixels {
  public:
    // Blends each pixel inside `within` that a visible segment crosses with its neighbour beyond the segment,
    // by coverage. `within` and the pixels around it must be inside the canvas.
    void smooth(std::span<const OutlinePiece> pieces, const PixelRect& within, const PictureCanvas& canvas);

  private:
    struct Smoothed {
        std::size_t at = 0;
        std::uint32_t pixel = 0;
    };
    std::vector<Smoothed> smoothed_;  // written after all pixels are read
};

}  // namespace onggi::render
