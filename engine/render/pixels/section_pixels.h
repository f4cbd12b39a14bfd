// The faces of a cut by the processor, where that is the device: what shaders/lathe_section.frag does, eight
// pixels at a time. Any thread; one user of a canvas at a time. Pixels, mm, linear light.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/picture_shapes.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// What grows evenly from corner to corner; all but the last times the last.
namespace section_value {
constexpr std::size_t kFromAxis = 0;  // mm, left negative
constexpr std::size_t kUp = 1;        // mm
constexpr std::size_t kLoad = 2;      // 1 gives way
constexpr std::size_t kThrough = 3;   // 0 on the outer face, 1 on the inner one
constexpr std::size_t kNear = 4;      // one over the distance along the view
constexpr std::size_t kCount = 5;
}  // namespace section_value
using SectionCorner = PictureCorner<section_value::kCount>;

// Corners of the triangles of add_section(), three each. `corners` is used again.
void place_section(std::span<const shaders::VertexData> vertices, const shaders::FrameData& frame,
                   std::vector<SectionCorner>& corners);

struct SectionLook {
    vec3 colour{0.5F};
    bool shows_load = false;
    ByteOrder order = ByteOrder::kRedFirst;
};

// Draws them where nothing that is there is nearer, seen from either side; those with a corner behind the eye
// are left out. A canvas of fewer than eight pixels stays as it is: nobody sees what is in it.
void draw_section(std::span<const SectionCorner> corners, const SectionLook& look,
                  const PictureCanvas& canvas);

}  // namespace onggi::render
