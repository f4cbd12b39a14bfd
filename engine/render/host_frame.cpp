#include "engine/render/host_frame.h"

#include <algorithm>

#include "engine/render/overlay_paint.h"

namespace onggi::render {
namespace {

TileGrid grid_of(const FrameContext& frame) {
    return {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
}

bool any(std::span<const std::uint8_t> tiles) {
    return std::any_of(tiles.begin(), tiles.end(), [](std::uint8_t tile) { return tile != 0; });
}

// As the frame before left it.
vk::ImageState left_in(const vk::TargetImage& target) {
    vk::ImageState state = vk::state::kDiscard;
    if (target.frames_before > 0) state.layout = target.final_layout;
    return state;
}

void begin_copies(const FrameContext& frame, const vk::TargetImage& target, const vk::ImageState& before) {
    vk::barrier(frame.commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, before, vk::state::kCopyTarget);
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
    // A picture that is made anew every frame holds what moves as it does all else.
    const bool is_anew = picture.is_whole && picture.instead == nullptr;
    const std::span<const std::uint8_t> moving = is_anew ? std::span<const std::uint8_t>{} : picture.moving;
    targets_.held_by(target).take_work(
        {.picture = picture.numbers, .moving = moving, .overlay = overlay.content()}, work_);
    const TileGrid grid = grid_of(frame);
    if (picture.is_whole && any(work_.drawn_over)) {
        rects_of_tiles(grid, work_.drawn_over, rects_);
        const auto pixels = picture.instead->as<std::uint32_t>();
        for (const PixelRect& rect : rects_)
            lay_over(overlay.painted().as<const std::uint32_t>(), pixels, rect, grid.width_px, pixels);
        std::fill(work_.drawn_over.begin(), work_.drawn_over.end(), std::uint8_t{0});
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
    begin_copies(frame, target, left_in(target));
    if (picture.instead != nullptr) {
        for (std::size_t tile = 0; tile < work_.bare.size(); ++tile)
            work_.bare[tile] = picture.instead_on[tile] != 0 ? 0 : work_.bare[tile];
        copy(frame, *picture.instead, picture.instead_on, target);
    }
    copy(frame, picture.pixels, work_.bare, target);
    copy(frame, laid_, work_.laid_over, target);
    end_copies(frame, target);
    return {};
}

void HostFrame::record_covered(const FrameContext& frame, const vk::TargetImage& target,
                               const PaintedOverlay& overlay, bool scene_is_drawn) {
    constexpr std::uint64_t kNoPicture = ~std::uint64_t{0};
    no_picture_.assign(grid_of(frame).count(), kNoPicture);
    HeldTiles& held = targets_.held_by(target);
    if (scene_is_drawn) held.forget();
    held.take_work({.picture = no_picture_, .overlay = overlay.content()}, work_);
    begin_copies(frame, target, scene_is_drawn ? vk::state::kColour : left_in(target));
    copy(frame, overlay.painted(), work_.laid_over, target);
    end_copies(frame, target);
}

}  // namespace onggi::render
