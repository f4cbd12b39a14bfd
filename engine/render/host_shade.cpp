#include "engine/render/host_shade.h"

#include <algorithm>
#include <span>

#include "engine/render/shade_pixels.h"
#include "engine/vk/readback.h"

namespace onggi::render {
namespace {

std::span<std::uint32_t> texels_of(const vk::Buffer& buffer) {
    return {reinterpret_cast<std::uint32_t*>(buffer.mapped()), buffer.size() / sizeof(std::uint32_t)};
}

void copy_to_host(const FrameContext& frame, const vk::Image& image, const vk::Buffer& into) {
    const VkCommandBuffer commands = frame.commands;
    vk::barrier(commands, image, vk::state::kSampled, vk::state::kCopySource);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {image.extent().width, image.extent().height, 1};
    vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, into.handle(), 1,
                           &region);
    vk::barrier(commands, image, vk::state::kCopySource, vk::state::kSampled);
}

}  // namespace

Result<void> HostShade::fit(const FrameContext& frame) {
    const VkExtent2D extent = frame.extent;
    if (extent.width == extent_.width && extent.height == extent_.height) return {};
    extent_ = {};
    state_ = State::kNothing;
    const VkDeviceSize bytes = VkDeviceSize{4} * extent.width * extent.height;
    struct Wish {
        vk::Buffer& into;
        vk::BufferDesc desc;
    };
    const auto read = [&](const char* name) {
        return vk::BufferDesc{.name = name,
                              .size = bytes,
                              .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                              .use = vk::MemoryUse::kReadback};
    };
    for (const Wish& wish :
         {Wish{with_key_, read("still life with the key light, read back")},
          Wish{without_key_, read("still life without the key light, read back")},
          Wish{places_, read("still life's places in the shadow mask, read back")},
          Wish{shaded_,
               {.name = "shaded still life", .size = bytes, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT}}}) {
        auto buffer = vk::Buffer::create(frame.device, wish.desc);
        if (!buffer) return buffer.error();
        wish.into = std::move(*buffer);
    }
    extent_ = extent;
    return {};
}

void HostShade::read_layers(const FrameContext& frame) {
    const bool is_wide_enough = extent_.width >= static_cast<std::uint32_t>(kShadeBlockPx);
    if (state_ != State::kNothing || !is_wide_enough) return;
    copy_to_host(frame, frame.images.still_key, with_key_);
    copy_to_host(frame, frame.images.still_ambient, without_key_);
    copy_to_host(frame, frame.images.still_coords, places_);
    vk::barrier_to_host(frame.commands);
    state_ = State::kOnTheWay;
}

void HostShade::take_layers() {
    const std::span<std::uint32_t> places = texels_of(places_);
    std::transform(places.begin(), places.end(), places.begin(), mask_place);
    // Nothing of what was shaded before fits these layers, which may be of another size.
    tiles_.learn({static_cast<int>(extent_.width), static_cast<int>(extent_.height)}, places);
    has_mask_ = false;
    state_ = State::kHere;
}

bool HostShade::shade(FrameContext& frame, std::uint64_t shadow) {
    if (state_ == State::kNothing) return false;
    if (state_ == State::kOnTheWay) take_layers();
    const bool is_new = !has_mask_ || mask_of_ != shadow;
    frame.stats.shadow_drawn = is_new;
    if (is_new) {
        std::swap(mask_, mask_before_);
        fill_shadow_mask(frame.built.frame, *mask_);
        if (has_mask_) {
            keep_what_is_alike(*mask_before_, *mask_);
            tiles_.note_mask(*mask_before_, *mask_);
        }
    }
    mask_of_ = shadow;
    has_mask_ = true;
    tiles_.take(rects_);
    shade_pixels({.width = static_cast<int>(extent_.width),
                  .height = static_cast<int>(extent_.height),
                  .with_key = texels_of(with_key_),
                  .without_key = texels_of(without_key_),
                  .places = texels_of(places_)},
                 *mask_, rects_, texels_of(shaded_));
    return true;
}

HeldTiles& HostShade::held_by(const vk::TargetImage& target) {
    const auto is_it = [&](const Target& known) { return known.image == target.image; };
    const auto known = std::find_if(targets_.begin(), targets_.end(), is_it);
    auto at = static_cast<std::size_t>(known - targets_.begin());
    if (known == targets_.end()) {
        // Handles of images that are gone are used again, so that few are ever known.
        constexpr std::size_t kMostTargets = 16;
        if (targets_.size() == kMostTargets) targets_.erase(targets_.begin());
        at = targets_.size();
        targets_.emplace_back();
    }
    Target& found = targets_[at];
    // Another handle's image, or one in which a frame was made in another way since.
    const bool is_as_left = target.frames_before > 0 && target.frames_before == found.frame + 1;
    if (!is_as_left) found.held.forget();
    found.image = target.image;
    found.frame = target.frames_before;
    return found.held;
}

void HostShade::record(const FrameContext& frame, const vk::TargetImage& target,
                       std::span<const std::uint64_t> overlay) {
    held_by(target).take_missing(tiles_, {.moving = frame.built.moving_tiles, .overlay = overlay}, rects_,
                                 overlay_wanted_);
    regions_.clear();
    for (const PixelRect& rect : rects_) {
        VkBufferImageCopy region{};
        region.bufferOffset = VkDeviceSize{4} * (static_cast<VkDeviceSize>(rect.y) * extent_.width +
                                                 static_cast<VkDeviceSize>(rect.x));
        region.bufferRowLength = extent_.width;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageOffset = {rect.x, rect.y, 0};
        region.imageExtent = {static_cast<std::uint32_t>(rect.width), static_cast<std::uint32_t>(rect.height),
                              1};
        regions_.push_back(region);
    }
    constexpr VkImageAspectFlags kColourAspect = VK_IMAGE_ASPECT_COLOR_BIT;
    vk::ImageState before = vk::state::kDiscard;
    if (target.frames_before > 0) before.layout = target.final_layout;
    vk::barrier(frame.commands, target.image, kColourAspect, before, vk::state::kCopyTarget);
    if (!regions_.empty()) {
        vkCmdCopyBufferToImage(frame.commands, shaded_.handle(), target.image,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               static_cast<std::uint32_t>(regions_.size()), regions_.data());
    }
    vk::barrier(frame.commands, target.image, kColourAspect, vk::state::kCopyTarget, vk::state::kColour);
}

}  // namespace onggi::render
