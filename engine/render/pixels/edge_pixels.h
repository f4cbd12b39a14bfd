// Outlines smoothed where a picture has one sample a pixel: by the processor, where that is the device. Any
// thread; one user of a canvas at a time. Pixels.
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
    // Gives each pixel inside `within` through which a piece goes that nothing hides its fraction of what
    // lies beyond. `within` lies inside the canvas, and so does the pixel around it.
    void smooth(std::span<const OutlinePiece> pieces, const PixelRect& within, const PictureCanvas& canvas);

  private:
    struct Smoothed {
        std::size_t at = 0;
        std::uint32_t pixel = 0;
    };
    std::vector<Smoothed> smoothed_;  // written when all have been read
};

}  // namespace onggi::render
