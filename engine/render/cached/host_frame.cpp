#include "engine/render/cached/host_frame.h"

#include <algorithm>

#include "engine/render/pixels/overlay_paint.h"

namespace onggi::render {
namespace {

TileGrid grid_of(const FrameContext& frame) {
    return {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
}

bool any(std::span<const std::uint8_t> tiles) {
    return std::any_of(tiles.begin(), tiles.end(), [](std::uint8_t tile) { return tile != 0; });
}

void begin_copies(const FrameContext& frame, const vk::TargetImage& target) {
    vk::ImageState left = vk::state::kDiscard;  // as the frame before left it
    if (target.frames_before > 0) left.layout = target.final_layout;
    vk::barrier(frame.commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, left, vk::state::kCopyTarget);
}

void end_copies(const FrameContext& frame, const vk::TargetImage& target) {
    vk::barrier(frame.commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kCopyTarget,
                vk::state::kColour);
}

}  // namespace

void HostFrame::copy(const FrameContext& frame, const vk::Buffer& from, std::span<const std::uint8_t> tiles,
                     const vk::TargetImage& into) {
    rects_of_tiles(grid_of(frame), tiles, rects_);
    if (rects_.empty()) return;
    rows_in_buffer(rects_, frame.extent.width, regions_);
    vkCmdCopyBufferToImage(frame.commands, from.handle(), into.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                           static_cast<std::uint32_t>(regions_.size()), regions_.data());
}

Result<void> HostFrame::record(const FrameContext& frame, const vk::TargetImage& target,
                               const HostPicture& picture, const PaintedOverlay& overlay) {
    targets_.held_by(target).take_work(
        {.picture = picture.numbers, .moving = picture.instead_on, .overlay = overlay.content()}, work_);
    const TileGrid grid = grid_of(frame);
    if (any(work_.moves_under)) {
        rects_of_tiles(grid, work_.moves_under, rects_);
        const auto pixels = picture.instead->as<std::uint32_t>();
        for (const PixelRect& rect : rects_)
            lay_over(overlay.painted().as<const std::uint32_t>(), pixels, rect, grid.width_px, pixels);
    }
    if (any(work_.laid_over)) {
        if (auto made = vk::make_room(frame.device, laid_, "still life with the overlay",
                                      picture.pixels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
            !made) {
            return made;
        }
        rects_of_tiles(grid, work_.laid_over, rects_);
        for (const PixelRect& rect : rects_) {
            lay_over(overlay.painted().as<const std::uint32_t>(), picture.pixels.as<const std::uint32_t>(),
                     rect, grid.width_px, laid_.as<std::uint32_t>());
        }
    }
    begin_copies(frame, target);
    if (picture.instead != nullptr) copy(frame, *picture.instead, picture.instead_on, target);
    copy(frame, picture.pixels, work_.bare, target);
    copy(frame, laid_, work_.laid_over, target);
    end_copies(frame, target);
    return {};
}

void HostFrame::record_covered(const FrameContext& frame, const vk::TargetImage& target,
                               const PaintedOverlay& overlay) {
    constexpr std::uint64_t kNoPicture = ~std::uint64_t{0};
    no_picture_.assign(grid_of(frame).count(), kNoPicture);
    targets_.held_by(target).take_work({.picture = no_picture_, .overlay = overlay.content()}, work_);
    begin_copies(frame, target);
    copy(frame, overlay.painted(), work_.laid_over, target);
    end_copies(frame, target);
}

}  // namespace onggi::render
