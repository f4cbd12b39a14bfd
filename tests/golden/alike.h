// How far pictures that should be alike may be apart, and what they are drawn with for that. Plain values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "engine/render/renderer_desc.h"
#include "engine/vk/offscreen.h"

namespace onggi::golden {

// How far two pictures of eight bits a channel are apart, and in how many of their pixels by more than that
// would be said to be alike.
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

// The processor and the device place the corners of triangles alike to 1/256 of a pixel, but not to the last
// bit: a pixel whose middle lies on an edge may show what is on either side.
constexpr int kOnEdges = 12;

// Of what the processor draws itself: a pixel whose middle lies on the border of two texels of streaks may
// show either, which differ by little.
constexpr int kOnTexels = 64;
constexpr int kTexelsApart = 16;  // levels, at most

// What either backend draws alike to the pixel but for rounding: one sample, the same outlines, no smoothing
// of them, and streaks of one texel, for how texels are read is the one thing in which they are meant to
// differ; hands too, which the processor lights at their corners.
inline render::RendererDesc strictly_alike(render::Backend backend, int height_px) {
    render::RendererDesc desc = render::live_desc(vk::Offscreen::kFormat, true, height_px);
    desc.backend = backend;
    desc.smooths_outlines = false;
    desc.streaks_across = desc.streaks_up = 1;
    return desc;
}

// Of moving pictures.
constexpr int kWidth = 640;
constexpr int kHeight = 360;
constexpr double kFrameS = 1.0 / 60.0;

// A texel of the shadow mask may stay one step of 255 from where it should be: of light, of which dark clay
// shows three in the picture.
constexpr int kMaskStep = 3;

}  // namespace onggi::golden
