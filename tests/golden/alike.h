// Tolerances for comparing pictures, and the settings to draw them with. Plain values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "engine/render/renderer_desc.h"
#include "engine/vk/offscreen.h"

namespace onggi::golden {

// The difference of two 8-bit pictures, and the number of pixels beyond the tolerance.
struct Apart {
    int worst = 0;
    std::size_t worst_at = 0;  // the pixel
    int beyond = 0;
};
inline Apart apart(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, int alike) {
    Apart found;
    for (std::size_t pixel = 0; pixel < a.size() / 4; ++pixel) {
        int worst = 0;
        for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i)
            worst = std::max(worst, std::abs(int{a[i]} - int{b[i]}));
        if (worst > alike) ++found.beyond;
        if (worst <= found.worst) continue;
        found.worst = worst;
        found.worst_at = pixel;
    }
    return found;
}

// The CPU and the device agree on vertices to 1/256 of a pixel, but not to the last bit: a pixel whose centre
// lies on an edge may belong to either side.
constexpr int kOnEdges = 12;

// For the CPU's own rasteriser: a pixel whose centre lies on the border of two streak texels may show either;
// they differ little.
constexpr int kOnTexels = 64;
constexpr int kTexelsApart = 16;  // levels, at most

// Settings with which both backends agree to the pixel, apart from rounding: one sample, the same silhouettes
// without smoothing, streaks of one texel (texture filtering differs by design), and no hands, which the CPU
// lights per vertex.
inline render::RendererDesc strictly_alike(render::Backend backend, int height_px) {
    render::RendererDesc desc = render::live_desc(vk::Offscreen::kFormat, true, height_px);
    desc.backend = backend;
    desc.smooths_outlines = false;
    desc.streaks_across = desc.streaks_up = 1;
    return desc;
}

// The size of moving pictures.
constexpr int kWidth = 640;
constexpr int kHeight = 360;
constexpr double kFrameS = 1.0 / 60.0;

// A texel of the shadow mask may be off by one step of 255 of linear light, which is up to three levels of
// dark clay in the picture.
constexpr int kMaskStep = 3;

}  // namespace onggi::golden
