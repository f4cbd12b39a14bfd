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
    has_mask_ = false;
    state_ = State::kHere;
}

bool HostShade::shade(FrameContext& frame, std::uint64_t shadow) {
    if (state_ == State::kNothing) return false;
    if (state_ == State::kOnTheWay) take_layers();
    const std::vector<vec4>& rects = frame.built.shade;
    const bool is_new = !has_mask_ || mask_of_ != shadow;
    frame.stats.shadow_drawn = is_new;
    if (is_new) fill_shadow_mask(frame.built.frame, *mask_);
    mask_of_ = shadow;
    has_mask_ = true;
    if (!is_new && rects == shaded_rects_) return true;
    shade_pixels({.width = static_cast<int>(extent_.width),
                  .height = static_cast<int>(extent_.height),
                  .with_key = texels_of(with_key_),
                  .without_key = texels_of(without_key_),
                  .places = texels_of(places_)},
                 *mask_, rects, texels_of(shaded_));
    shaded_rects_ = rects;
    regions_.clear();
    for (const vec4& rect : rects) {
        const auto x = static_cast<std::uint32_t>(rect.x);
        const auto y = static_cast<std::uint32_t>(rect.y);
        VkBufferImageCopy region{};
        region.bufferOffset = VkDeviceSize{4} * (VkDeviceSize{y} * extent_.width + x);
        region.bufferRowLength = extent_.width;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageOffset = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), 0};
        region.imageExtent = {static_cast<std::uint32_t>(rect.z) - x, static_cast<std::uint32_t>(rect.w) - y,
                              1};
        regions_.push_back(region);
    }
    return true;
}

void HostShade::record(const FrameContext& frame, VkImage target) const {
    if (regions_.empty()) return;
    constexpr VkImageAspectFlags kColourAspect = VK_IMAGE_ASPECT_COLOR_BIT;
    vk::barrier(frame.commands, target, kColourAspect, vk::state::kColour, vk::state::kCopyTarget);
    vkCmdCopyBufferToImage(frame.commands, shaded_.handle(), target, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                           static_cast<std::uint32_t>(regions_.size()), regions_.data());
    vk::barrier(frame.commands, target, kColourAspect, vk::state::kCopyTarget, vk::state::kColour);
}

}  // namespace onggi::render
