#include "engine/render/cpu/resting_scene.h"

namespace onggi::render {

Result<void> RestingScene::fit(const FrameContext& frame) {
    grid_ = {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (picture_.size() == bytes) return {};
    auto picture = vk::Buffer::create(frame.device, {.name = "resting scene",
                                                     .size = bytes,
                                                     .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                                     .use = vk::MemoryUse::kWork});
    if (!picture) return picture.error();
    picture_ = std::move(*picture);
    return {};
}

Result<void> RestingScene::keep(const FrameContext& frame, const HostPicture& scene, TileNumbers& numbers) {
    if (is_here_) return {};
    if (auto fitted = fit(frame); !fitted) return fitted;
    copy_whole(scene, grid_, picture_.as<std::uint32_t>());
    numbers_.assign(grid_.count(), numbers.next());
    is_here_ = true;
    return {};
}

}  // namespace onggi::render
