// Rasterises the cut faces for the CPU backend as shaders/lathe_section.frag does, eight pixels at a time.
// Any thread; one user of a canvas at a time. Pixels, mm, linear light.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/picture_shapes.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// Values that are interpolated between corners; all except the last are multiplied by the last.
namespace section_value {
constexpr std::size_t kFromAxis = 0;  // mm, negative on the left
constexpr std::size_t kUp = 1;        // mm
constexpr std::size_t kLoad = 2;      // 1 collapses
constexpr std::size_t kThrough = 3;   // 0 on the outer face, 1 on the inner one
constexpr std::size_t kNear = 4;      // one over the distance along the view
constexpr std::size_t kCount = 5;
}  // namespace section_value
using SectionCorner = PictureCorner<section_value::kCount>;

// Projects the triangles of add_section(), three corners each. Reuses the memory of `corners`.
void place_section(std::span<const shaders::VertexData> vertices, const shaders::FrameData& frame,
                   std::vector<SectionCorner>& corners);

struct SectionLook {
    vec3 colour{0.5F};
    bool shows_load = false;
    ByteOrder order = ByteOrder::kRedFirst;
};

// Draws the triangles, two-sided, with a depth test (nearer or equal passes). Triangles with a corner behind
// the eye are skipped. A canvas of fewer than eight pixels is left unchanged.
void draw_section(std::span<const SectionCorner> corners, const SectionLook& look,
                  const PictureCanvas& canvas);

}  // namespace onggi::render
