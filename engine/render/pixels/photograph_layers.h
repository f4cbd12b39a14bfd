// The layers of a photographed room for a camera: the photographs, shifted and scaled to the picture. Any
// thread; pure. Pixels, texels.
#pragma once

#include <cstdint>
#include <span>

#include "engine/math/math.h"
#include "engine/render/pixels/host_photograph.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// Fills these rows of both layers, which are `width` pixels wide without gaps; the alphas of `without_key`
// are kept. The pixel's centre * window.xy + window.zw is the position in the photographs, 0 to 1. Outside
// the photographs the picture continues as in shaders/background_edge.glsl. Bit-identical on every processor.
void lay_photographs(const HostBackground& background, vec4 window, int width, RowSpan rows,
                     std::span<std::uint32_t> with_key, std::span<std::uint32_t> without_key);

}  // namespace onggi::render
