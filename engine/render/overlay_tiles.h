// What of an overlay lies on which tiles of the picture, so that where it has not changed, and nothing was
// drawn under it, it is left as it is. Main thread. Pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/shade_tiles.h"
#include "engine/ui/draw_list.h"

namespace onggi::render {

// A stretch of indices that one pipeline draws inside a rectangle.
struct ClippedRun {
    PixelRect inside;
    ui::Run run;
};

class OverlayTiles {
  public:
    // `list_hash` is the list's own; `atlas_state` is another whenever what lies in the atlas is. With the
    // same of both nothing is done.
    void learn(const TileGrid& grid, const ui::DrawList& list, std::uint64_t list_hash,
               std::uint64_t atlas_state);
    void clear() { content_.clear(); }

    // One entry a tile, or none at all: 0 where nothing lies, else a number for all that lies there.
    [[nodiscard]] std::span<const std::uint64_t> content() const { return content_; }

    // What of the list lies on the wanted tiles, to be drawn inside them.
    void take(const ui::DrawList& list, std::span<const std::uint8_t> wanted,
              std::vector<std::uint32_t>& indices, std::vector<ClippedRun>& runs);

  private:
    TileGrid grid_;
    std::uint64_t list_hash_ = 0;
    std::uint64_t atlas_state_ = 0;
    std::vector<std::uint64_t> content_;
    std::vector<PixelRect> rects_;  // about each triangle
    std::vector<PixelRect> wanted_;
};

}  // namespace onggi::render
