#include "engine/render/resting_scene.h"

#include <algorithm>

#include "engine/vk/readback.h"

namespace onggi::render {

Result<void> RestingScene::fit(const FrameContext& frame) {
    grid_ = {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (picture_.size() == bytes) return {};
    auto picture = vk::Buffer::create(
        frame.device, {.name = "resting scene",
                       .size = bytes,
                       .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                       .use = vk::MemoryUse::kReadback});
    if (!picture) return picture.error();
    picture_ = std::move(*picture);
    return {};
}

void RestingScene::copy(const vk::Buffer& from, std::span<const std::uint8_t> tiles) {
    const auto width = static_cast<std::size_t>(grid_.width_px);
    rects_of_tiles(grid_, tiles, rects_);
    for (const PixelRect& rect : rects_)
        copy_rect(from.as<const std::uint32_t>(), rect, width, picture_.as<std::uint32_t>());
}

void RestingScene::arrive() {
    constexpr std::uint64_t kNoShadeTile = std::uint64_t{1} << 63U;
    numbers_.assign(grid_.count(), kNoShadeTile | ++last_number_);
    state_ = State::kHere;
}

Result<void> RestingScene::keep(const FrameContext& frame, const HostPicture& scene) {
    if (state_ != State::kNothing) return {};
    if (auto fitted = fit(frame); !fitted) return fitted;
    const auto pixels = scene.pixels.as<const std::uint32_t>();
    std::copy(pixels.begin(), pixels.end(), picture_.as<std::uint32_t>().begin());
    if (scene.instead != nullptr) copy(*scene.instead, scene.instead_on);
    arrive();
    return {};
}

Result<void> RestingScene::record_reading(const FrameContext& frame, const vk::TargetImage& target,
                                          const HostShade* shade) {
    if (state_ != State::kNothing || !target.can_be_read) return {};
    if (auto fitted = fit(frame); !fitted) return fitted;
    is_shaded_.assign(grid_.count(), 0);
    is_drawn_.assign(grid_.count(), 1);
    if (shade != nullptr) {
        is_drawn_ = frame.built.moving_tiles;
        std::transform(is_drawn_.begin(), is_drawn_.end(), is_shaded_.begin(),
                       [](std::uint8_t drawn) { return static_cast<std::uint8_t>(drawn == 0); });
    }
    rects_of_tiles(grid_, is_drawn_, rects_);
    if (!rects_.empty()) {
        rows_in_buffer(rects_, frame.extent.width, regions_);
        constexpr VkImageAspectFlags kAspect = VK_IMAGE_ASPECT_COLOR_BIT;
        vk::barrier(frame.commands, target.image, kAspect, vk::state::kColour, vk::state::kCopySource);
        vkCmdCopyImageToBuffer(frame.commands, target.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                               picture_.handle(), static_cast<std::uint32_t>(regions_.size()),
                               regions_.data());
        vk::barrier(frame.commands, target.image, kAspect, vk::state::kCopySource, vk::state::kColour);
        vk::barrier_to_host(frame.commands);
    }
    state_ = State::kOnTheWay;
    return {};
}

bool RestingScene::take(const HostShade& shade) {
    if (state_ == State::kOnTheWay) {
        copy(shade.shaded(), is_shaded_);
        arrive();
    }
    return state_ == State::kHere;
}

}  // namespace onggi::render
