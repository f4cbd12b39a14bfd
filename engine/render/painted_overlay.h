// The overlay where the device is the processor: painted here, into pixels of its own, only where it has
// changed. It is laid over the picture here too (HostFrame); over what the device has drawn, the device lays
// it in one go. Main thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/frame_context.h"
#include "engine/render/overlay.h"
#include "engine/render/overlay_paint.h"
#include "engine/render/overlay_tiles.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

[[nodiscard]] ByteOrder byte_order(VkFormat format);

class PaintedOverlay {
  public:
    Result<void> create(const FrameContext& frame);
    // Paints what has changed. The device is idle. Null: no overlay.
    Result<void> fit(const FrameContext& frame, const Overlay* overlay);
    // What lies where; nothing where there is no overlay.
    [[nodiscard]] std::span<const std::uint64_t> content() const { return tiles_.content(); }
    // As large as the picture; only tiles on which something lies are good.
    [[nodiscard]] const vk::Buffer& painted() const { return painted_; }

    // Lays it over these tiles (one entry each) of a target that is laid out as colour, as the scene left it.
    // Nothing else may want the corners' buffer between here and the end of the frame.
    Result<void> record(const FrameContext& frame, const vk::TargetImage& target,
                        std::span<const std::uint8_t> tiles);

  private:
    Result<void> fit_picture(const FrameContext& frame);

    vk::BoundSet set_;
    vk::PipelineLayout layout_;
    vk::Pipeline pipeline_;
    vk::Buffer corners_;
    vk::Buffer painted_;
    TileGrid grid_;
    OverlayPictures pictures_;
    OverlayTiles tiles_;
    std::vector<std::uint64_t> painted_content_;  // what of each tile was painted last
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
    std::vector<vec2> corners_px_;
};

}  // namespace onggi::render
