#include "engine/render/cpu/painted_overlay.h"

namespace onggi::render {

Result<void> PaintedOverlay::fit_picture(const FrameContext& frame) {
    const TileGrid grid{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    if (grid == grid_ && painted_.size() > 0) return {};
    auto painted =
        vk::Buffer::create(frame.device, {.name = "painted overlay",
                                          .size = VkDeviceSize{4} * frame.extent.width * frame.extent.height,
                                          .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                          .use = vk::MemoryUse::kWork});
    if (!painted) return painted.error();
    painted_ = std::move(*painted);
    grid_ = grid;
    painted_content_.assign(grid.count(), 0);
    return {};
}

Result<void> PaintedOverlay::fit(const FrameContext& frame, const Overlay* overlay) {
    if (overlay == nullptr) {
        tiles_.clear();
        return {};
    }
    if (auto fitted = fit_picture(frame); !fitted) return fitted;
    pictures_.take(overlay->uploads, overlay->atlas_side_px);
    tiles_.learn(grid_, *overlay->list, pictures_);
    const std::span<const std::uint64_t> content = tiles_.content();
    wanted_.assign(grid_.count(), 0);
    for (std::size_t tile = 0; tile < content.size(); ++tile) {
        if (content[tile] == 0 || content[tile] == painted_content_[tile]) continue;
        wanted_[tile] = 1;
        painted_content_[tile] = content[tile];
    }
    rects_of_tiles(grid_, wanted_, rects_);
    const OverlayPainting painting{*overlay->list, pictures_, byte_order(frame.desc.colour_format)};
    for (const PixelRect& rect : rects_)
        paint_overlay(painting, rect, grid_.width_px, painted_.as<std::uint32_t>());
    return {};
}

}  // namespace onggi::render
