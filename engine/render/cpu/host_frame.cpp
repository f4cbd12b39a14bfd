#include "engine/render/cpu/host_frame.h"

#include <algorithm>
#include <cstddef>

namespace onggi::render {

void DamageTracker::take_work(const TileContents& wanted, TileWork& work) {
    const std::size_t count = wanted.picture.size();
    if (picture_.size() != count) {
        picture_.assign(count, 0);
        overlay_.assign(count, 0);
    }
    work.bare.assign(count, 0);
    work.laid_over.assign(count, 0);
    work.moves.assign(count, 0);
    work.moves_under.assign(count, 0);
    for (std::size_t tile = 0; tile < count; ++tile) {
        const std::uint64_t overlay = wanted.overlay.empty() ? 0 : wanted.overlay[tile];
        if (!wanted.moving.empty() && wanted.moving[tile] != 0) {
            (overlay == 0 ? work.moves : work.moves_under)[tile] = 1;
            picture_[tile] = overlay_[tile] = 0;
            continue;
        }
        const bool is_there = picture_[tile] == wanted.picture[tile] && overlay_[tile] == overlay;
        if (!is_there) (overlay == 0 ? work.bare : work.laid_over)[tile] = 1;
        picture_[tile] = wanted.picture[tile];
        overlay_[tile] = overlay;
    }
}

DamageTracker& HeldTargets::held_by(const vk::TargetImage& target) {
    const auto is_it = [&](const Known& known) { return known.image == target.image; };
    const auto known = std::find_if(known_.begin(), known_.end(), is_it);
    auto at = static_cast<std::size_t>(known - known_.begin());
    if (known == known_.end()) {
        // The driver reuses handles of destroyed images, so only a few are ever known.
        constexpr std::size_t kMostTargets = 16;
        if (known_.size() == kMostTargets) known_.erase(known_.begin());
        at = known_.size();
        known_.emplace_back();
    }
    Known& found = known_[at];
    // Otherwise the handle belongs to a new image, or the target's last frame was not drawn here.
    const bool is_as_left = target.frames_before > 0 && target.frames_before == found.frame + 1;
    if (!is_as_left) found.held.forget();
    found.image = target.image;
    found.frame = target.frames_before;
    return found.held;
}

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

namespace {

TileGrid grid_of(const FrameContext& frame) {
    return {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
}

bool any(std::span<const std::uint8_t> tiles) {
    return std::any_of(tiles.begin(), tiles.end(), [](std::uint8_t tile) { return tile != 0; });
}

void begin_copies(const FrameContext& frame, const vk::TargetImage& target) {
    // Undefined if the target has no frame yet; else as its last frame left it.
    vk::ImageState left = vk::state::kDiscard;
    if (target.frames_before > 0) left.layout = target.final_layout;
    vk::barrier(frame.commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, left, vk::state::kCopyTarget);
}

void end_copies(const FrameContext& frame, const vk::TargetImage& target) {
    vk::barrier(frame.commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kCopyTarget,
                vk::state::kColour);
}

}  // namespace

void copy_whole(const FrameContext& frame, const HostPicture& picture, const TileGrid& grid,
                std::span<std::uint32_t> into) {
    std::vector<std::uint8_t> wanted;
    std::vector<PixelRect> rects;
    for_parts(frame, picture, grid, wanted, rects, [&](const vk::Buffer& part, const PixelRect& rect) {
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
    for (const PixelRect& rect : rects_) {
        const VkExtent2D size{static_cast<std::uint32_t>(rect.width),
                              static_cast<std::uint32_t>(rect.height)};
        frame.work.uploaded_bytes += std::size_t{4} * size.width * size.height;
        frame.changed.push_back({{rect.x, rect.y}, size});
    }
}

// Composes the overlay over `under` on these tiles, into laid_.
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
