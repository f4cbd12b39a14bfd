#include "engine/render/cpu/host_frame.h"

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

void copy_whole(const HostPicture& picture, const TileGrid& grid, std::span<std::uint32_t> into) {
    std::vector<std::uint8_t> wanted;
    std::vector<PixelRect> rects;
    for_parts(picture, grid, wanted, rects, [&](const vk::Buffer& part, const PixelRect& rect) {
        copy_rect(part.as<const std::uint32_t>(), rect, static_cast<std::size_t>(grid.width_px), into);
    });
}

void HostFrame::copy(const FrameContext& frame, const vk::Buffer& from, std::span<const std::uint8_t> tiles,
                     const vk::TargetImage& into) {
    rects_of_tiles(grid_of(frame), tiles, rects_);
    if (rects_.empty()) return;
    rows_in_buffer(rects_, frame.extent.width, regions_);
    vkCmdCopyBufferToImage(frame.commands, from.handle(), into.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                           static_cast<std::uint32_t>(regions_.size()), regions_.data());
    for (const PixelRect& rect : rects_)
        frame.work.uploaded_bytes += std::size_t{4} * static_cast<std::size_t>(rect.width * rect.height);
}

// With the overlay on it, into what is laid.
void HostFrame::lay(const FrameContext& frame, const PaintedOverlay& overlay, const vk::Buffer& under,
                    std::span<const std::uint8_t> tiles) {
    const TileGrid grid = grid_of(frame);
    rects_of_tiles(grid, tiles, rects_);
    for (const PixelRect& rect : rects_) {
        lay_over(overlay.painted().as<const std::uint32_t>(), under.as<const std::uint32_t>(), rect,
                 grid.width_px, laid_.as<std::uint32_t>());
    }
}

Result<void> HostFrame::record(const FrameContext& frame, const vk::TargetImage& target,
                               const HostPicture& picture, const PaintedOverlay& overlay) {
    targets_.held_by(target).take_work(
        {.picture = picture.numbers, .moving = picture.instead_on, .overlay = overlay.content()}, work_);
    const bool is_laid_over = any(work_.laid_over);
    const bool moves_under = any(work_.moves_under);
    if (is_laid_over || moves_under) {
        if (auto made = vk::make_room(frame.device, laid_, "picture with the overlay", picture.pixels.size(),
                                      VK_BUFFER_USAGE_TRANSFER_SRC_BIT, vk::MemoryUse::kWork);
            !made) {
            return made;
        }
    }
    if (is_laid_over) lay(frame, overlay, picture.pixels, work_.laid_over);
    if (moves_under) lay(frame, overlay, *picture.instead, work_.moves_under);
    begin_copies(frame, target);
    if (picture.instead != nullptr) copy(frame, *picture.instead, work_.moves, target);
    copy(frame, picture.pixels, work_.bare, target);
    if (is_laid_over) copy(frame, laid_, work_.laid_over, target);
    if (moves_under) copy(frame, laid_, work_.moves_under, target);
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
