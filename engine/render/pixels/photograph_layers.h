// The layers of a photographed room for a camera: the photographs, shifted and scaled to the picture. Any
// thread; pure. Pixels, texels.
#pragma once

#include <cstdint>
#include <span>

#include "engine/math/math.h"
#include "engine/render/pixels/host_photograph.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// A photographed room as a camera sees it, in a picture `width_px` wide. The pixel's centre * window.xy +
// window.zw is the position in the photographs, 0 to 1. Outside of them the room goes on mirrored and darker,
// see shaders/background_edge.h.
struct PhotographedRoom {
    const HostBackground* photographs = nullptr;
    vec4 window{1.0F, 1.0F, 0.0F, 0.0F};
    int width_px = 0;
};

// Takes pixels of one row of both layers from the photographs: those from column `first` on, as many as there
// is room for in the spans, which are of the same size. The alphas of `without_key` are kept. Bit-identical
// on every processor.
void lay_photographs(const PhotographedRoom& room, int row, int first, std::span<std::uint32_t> with_key,
                     std::span<std::uint32_t> without_key);

}  // namespace onggi::render
