// The shadow mask worked out by the processor, texel for texel as shaders/mask.frag does it: where a device
// is the processor itself, that is quicker than drawing it, and what reads it need not wait for a device. Any
// thread; pure.
#pragma once

#include <array>
#include <cstdint>

#include "shaders/frame_data.h"

namespace onggi::render {

// A row of texels after the other, the first at v = 0. Of each, 0 to 255, the fraction of the key light that
// gets there in its low half and of the sky in its high half: 0x00gg00rr, so that both are mixed at once.
using ShadowMask = std::array<std::uint32_t, std::size_t{shaders::kMaskTexels} * shaders::kMaskTexels>;
constexpr std::uint32_t kUnshaded = 0x00FF00FFU;

// From the same numbers that the shader reads.
void fill_shadow_mask(const shaders::FrameData& frame, ShadowMask& mask);

// A texel that differs by one step of 255 stays as it was before: nobody sees that, and it need not be shaded
// again. It never comes to more than that step, because what is compared with is what is shown.
void keep_what_is_alike(const ShadowMask& before, ShadowMask& now);

}  // namespace onggi::render
