// The pixels that the lathe covers for sure: what lies under them need not be made. Any thread; pure. Pixels.
#pragma once

#include <span>
#include <vector>

#include "engine/render/camera.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// Where a line across the picture passes the pot for sure.
struct Covered {
    float left = 0.0F;
    float right = 0.0F;  // not above left: nowhere
};

// What is drawn of the pot are chords of its circles: this far from its ends it covers for sure.
constexpr float kCoveredMarginPx = 2.0F;

// One entry a line of pixels, the first at the top: what lies between the two ends of a ring that is drawn,
// and between those of one ring and the next, is pot. `vertices` are the lathe's, rows of sectors + 1.
[[nodiscard]] std::vector<Covered> covered_by_lathe(std::span<const shaders::VertexData> vertices,
                                                    std::size_t rows, int sectors, const Camera& camera,
                                                    int width_px, int height_px);

}  // namespace onggi::render
