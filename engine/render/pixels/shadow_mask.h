// Computes the shadow mask on the processor, texel for texel as shaders/mask.frag does: on a software device
// this is faster than drawing it, and needs no wait for the device. Any thread; pure.
#pragma once

#include <array>
#include <cstdint>

#include "shaders/frame_data.h"

namespace onggi::render {

// Rows of texels, the first at v = 0. Each texel has the visible fraction of the key light in its low half
// and of the sky in its high half, 0 to 255: 0x00gg00rr, so that both are interpolated at once.
using ShadowMask = std::array<std::uint32_t, std::size_t{shaders::kMaskTexels} * shaders::kMaskTexels>;
constexpr std::uint32_t kUnshaded = 0x00FF00FFU;

// Reads the same numbers as the shader.
void fill_shadow_mask(const shaders::FrameData& frame, ShadowMask& mask);

// Keeps the old value of texels that differ by one step of 255: the difference is invisible, and the tile
// need not be shaded again. The error never exceeds that step, because the comparison is with the value that
// is shown.
void keep_what_is_alike(const ShadowMask& before, ShadowMask& now);

}  // namespace onggi::render
