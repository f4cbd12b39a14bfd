// An overlay painted by the processor into pixels of its own, in vectors of four pixels: on a software device
// a shader that blends costs six to twelve nanoseconds a pixel and layer, this one. Any thread; pure
// functions. Pixels hold a colour multiplied by alpha, eight bits each, alpha highest.
#pragma once

#include <cstdint>
#include <span>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/overlay_pictures.h"
#include "engine/render/shapes/tiles.h"
#include "engine/ui/draw_list.h"

namespace onggi::render {

// Red lies lowest in the lists and paintings of an overlay, whatever the order is in the pixels.
struct OverlayPainting {
    const ui::DrawList& list;
    const OverlayPictures& pictures;
    ByteOrder order = ByteOrder::kRedFirst;
};

// All of the list that lies inside a rectangle of a picture of this width, and nothing where nothing lies. A
// triangle covers the pixels whose middle it holds, of a side that two share only one of them. `into` has
// whole rows of `width_px`; the rectangle lies inside.
void paint_overlay(const OverlayPainting& painting, const PixelRect& inside, int width_px,
                   std::span<std::uint32_t> into);

// What was painted, laid over another picture of the same width; `into` may be that picture.
void lay_over(std::span<const std::uint32_t> painted, std::span<const std::uint32_t> under,
              const PixelRect& inside, int width_px, std::span<std::uint32_t> into);

}  // namespace onggi::render
