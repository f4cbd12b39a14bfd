#include "engine/render/cached/resting_scene.h"

#include <algorithm>

namespace onggi::render {

Result<void> RestingScene::fit(const FrameContext& frame) {
    grid_ = {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (picture_.size() == bytes) return {};
    auto picture = vk::Buffer::create(
        frame.device, {.name = "resting scene", .size = bytes, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
    if (!picture) return picture.error();
    picture_ = std::move(*picture);
    return {};
}

Result<void> RestingScene::keep(const FrameContext& frame, const HostPicture& scene) {
    if (is_here_) return {};
    if (auto fitted = fit(frame); !fitted) return fitted;
    const auto kept = picture_.as<std::uint32_t>();
    const auto pixels = scene.pixels.as<const std::uint32_t>();
    std::copy(pixels.begin(), pixels.end(), kept.begin());
    if (scene.instead != nullptr) {
        rects_of_tiles(grid_, scene.instead_on, rects_);
        for (const PixelRect& rect : rects_)
            copy_rect(scene.instead->as<const std::uint32_t>(), rect, frame.extent.width, kept);
    }
    constexpr std::uint64_t kNoShadeTile = std::uint64_t{1} << 63U;
    numbers_.assign(grid_.count(), kNoShadeTile | ++last_number_);
    is_here_ = true;
    return {};
}

}  // namespace onggi::render
