// The layers of a photographed room where the camera stands: the photographs themselves, moved and stretched
// to where the picture shows them. Any thread; pure. Pixels, texels.
#pragma once

#include <cstdint>
#include <span>

#include "engine/math/math.h"
#include "engine/render/pixels/host_photograph.h"

namespace onggi::render {

// Of a picture, from the top.
struct RowSpan {
    int first = 0;
    int end = 0;  // one after the last
};

// Fills these rows of both layers, which are `width` pixels wide without gaps; of `without_key` the alphas
// stay as they are. The pixel's middle * window.xy + window.zw is the place in the photographs, 0 to 1. What
// lies beside them is as shaders/background_edge.glsl says. The same bits on every processor.
void lay_photographs(const HostBackground& background, vec4 window, int width, RowSpan rows,
                     std::span<std::uint32_t> with_key, std::span<std::uint32_t> without_key);

}  // namespace onggi::render
