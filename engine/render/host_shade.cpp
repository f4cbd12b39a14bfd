#include "engine/render/host_shade.h"

#include <algorithm>
#include <span>

#include "engine/render/shade_pixels.h"
#include "engine/vk/readback.h"

namespace onggi::render {
namespace {

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

void HostShade::let_go() {
    for (vk::Buffer* buffer : {&with_key_, &without_key_, &places_, &shaded_})
        *buffer = {};
    extent_ = {};
    state_ = State::kNothing;
}

bool HostShade::is_wide_enough() const {
    return extent_.width >= static_cast<std::uint32_t>(kShadeBlockPx);
}

void HostShade::read_layers(const FrameContext& frame) {
    if (state_ != State::kNothing || !is_wide_enough()) return;
    copy_to_host(frame, frame.images.still_key, with_key_);
    copy_to_host(frame, frame.images.still_ambient, without_key_);
    copy_to_host(frame, frame.images.still_coords, places_);
    vk::barrier_to_host(frame.commands);
    state_ = State::kOnTheWay;
}

void HostShade::take_layers() {
    const std::span<std::uint32_t> places = places_.as<std::uint32_t>();
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
    tiles_.take(frame.built.moving_tiles, rects_);
    shade_pixels({.width = static_cast<int>(extent_.width),
                  .height = static_cast<int>(extent_.height),
                  .with_key = with_key_.as<std::uint32_t>(),
                  .without_key = without_key_.as<std::uint32_t>(),
                  .places = places_.as<std::uint32_t>()},
                 *mask_, rects_, shaded_.as<std::uint32_t>());
    return true;
}

}  // namespace onggi::render
