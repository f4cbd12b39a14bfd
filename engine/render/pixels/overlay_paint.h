// An overlay painted by the processor into pixels of its own, in vectors of four pixels: on a software device
// a shader that blends costs six to twelve nanoseconds a pixel and layer, this one. Any thread; pure
// functions. Pixels hold a colour multiplied by alpha, eight bits each, alpha highest.
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

// The paintings that an overlay's draw list names by their place in the atlas, as they are in memory: for
// who paints the overlay without a texture. Main thread.
class OverlayPictures {
  public:
    struct Picture {
        ui::Atlas::Upload placed;
        std::uint64_t number = 0;  // no other picture ever had it
    };

    // These come, over whatever lay in their places in an atlas of this size; of one of another size nothing
    // is left.
    void take(std::span<const ui::Atlas::Upload> uploads, int side_px);
    // The picture with this upper left corner in the atlas; null: none.
    [[nodiscard]] const Picture* at(vec2 corner_px) const;
    // Another whenever any of them is.
    [[nodiscard]] std::uint64_t state() const { return last_number_; }

  private:
    std::unordered_map<std::uint64_t, Picture> pictures_;  // by corner
    std::uint64_t last_number_ = 0;
    int side_px_ = 0;
};

// What of an overlay lies on which tile, so that it is painted again only where it has changed, and brought
// into a target only where that shows something else. Main thread. Pixels.
class OverlayTiles {
  public:
    // With the same list and pictures as before nothing is done.
    void learn(const TileGrid& grid, const ui::DrawList& list, const OverlayPictures& pictures);
    void clear() { content_.clear(); }

    // One entry a tile, or none at all: 0 where nothing lies, else a number for all that lies there.
    [[nodiscard]] std::span<const std::uint64_t> content() const { return content_; }

  private:
    TileGrid grid_;
    std::uint64_t list_hash_ = 0;
    std::uint64_t pictures_state_ = 0;
    std::vector<std::uint64_t> content_;
};

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
