// Paints the overlay on the processor into a separate buffer, four pixels at a time: on a software device a
// blending shader costs six to twelve nanoseconds per pixel and layer, this code one. Any thread; pure
// functions. Pixels are premultiplied, eight bits per channel, alpha highest.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "engine/render/byte_order.h"
#include "engine/render/shapes/tiles.h"
#include "engine/ui/atlas.h"
#include "engine/ui/draw_list.h"

namespace onggi::render {

// The paintings that an overlay's draw list refers to by their place in the atlas, kept in memory for
// painting without a texture. Main thread.
class OverlayPictures {
  public:
    struct Picture {
        ui::Atlas::Upload placed;
        std::uint64_t number = 0;  // unique; never reused
    };

    // Adds pictures, which replace overlapping ones. If the atlas's side has changed, all older pictures are
    // dropped.
    void take(std::span<const ui::Atlas::Upload> uploads, int side_px);
    // Returns the picture with this upper left corner in the atlas; null if there is none.
    [[nodiscard]] const Picture* at(vec2 corner_px) const;
    // Changes whenever any picture changes.
    [[nodiscard]] std::uint64_t state() const { return last_number_; }

  private:
    std::unordered_map<std::uint64_t, Picture> pictures_;  // by corner
    std::uint64_t last_number_ = 0;
    int side_px_ = 0;
};

// Content hashes of the overlay's tiles, so that only changed tiles are repainted and only tiles that a
// target does not show are copied. Main thread. Pixels.
class OverlayTiles {
  public:
    // Does nothing if list and pictures are unchanged.
    void learn(const TileGrid& grid, const ui::DrawList& list, const OverlayPictures& pictures);
    void clear() { content_.clear(); }

    // One entry per tile, or empty without an overlay: 0 where the tile is empty, else a hash of everything
    // on it.
    [[nodiscard]] std::span<const std::uint64_t> content() const { return content_; }

  private:
    TileGrid grid_;
    std::uint64_t list_hash_ = 0;
    std::uint64_t pictures_state_ = 0;
    std::vector<std::uint64_t> content_;
};

// In an overlay's lists and paintings red is the lowest byte, whatever the order of the pixels.
struct OverlayPainting {
    const ui::DrawList& list;
    const OverlayPictures& pictures;
    ByteOrder order = ByteOrder::kRedFirst;
};

// Paints the list inside a rectangle, and clears the rest of the rectangle. A triangle covers the pixels
// whose centres it contains; a pixel centre on a shared side belongs to one triangle only. `into` has whole
// rows of `width_px`; the rectangle must be inside.
void paint_overlay(const OverlayPainting& painting, const PixelRect& inside, int width_px,
                   std::span<std::uint32_t> into);

// Composes the painted overlay over a picture of the same width. `into` may be that picture.
void lay_over(std::span<const std::uint32_t> painted, std::span<const std::uint32_t> under,
              const PixelRect& inside, int width_px, std::span<std::uint32_t> into);

}  // namespace onggi::render
