// What of an overlay lies on which tile, so that it is painted again only where it has changed, and brought
// into a target only where that shows something else. Main thread. Pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/pixels/overlay_pictures.h"
#include "engine/render/shapes/tiles.h"
#include "engine/ui/draw_list.h"

namespace onggi::render {

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

}  // namespace onggi::render
