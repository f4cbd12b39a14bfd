// The overlay where the device is the processor: painted here, into pixels of its own, only where it has
// changed; HostFrame lays it over the picture. Main thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/frame/frame_context.h"
#include "engine/render/overlay.h"
#include "engine/render/pixels/overlay_paint.h"
#include "engine/render/pixels/overlay_tiles.h"

namespace onggi::render {

class PaintedOverlay {
  public:
    // Paints what has changed. The device is idle. Null: no overlay.
    Result<void> fit(const FrameContext& frame, const Overlay* overlay);
    // What lies where; nothing where there is no overlay.
    [[nodiscard]] std::span<const std::uint64_t> content() const { return tiles_.content(); }
    // As large as the picture; only tiles on which something lies are good.
    [[nodiscard]] const vk::Buffer& painted() const { return painted_; }

  private:
    Result<void> fit_picture(const FrameContext& frame);

    vk::Buffer painted_;
    TileGrid grid_;
    OverlayPictures pictures_;
    OverlayTiles tiles_;
    std::vector<std::uint64_t> painted_content_;  // what of each tile was painted last
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

}  // namespace onggi::render
