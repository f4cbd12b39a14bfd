#include "engine/render/cpu/framebuffer.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace onggi::render {

Result<void> Framebuffer::fit(const FrameContext& frame, std::string_view name) {
    const PictureSize size{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    if (size == size_) return {};
    const std::size_t pixels = std::size_t{frame.extent.width} * frame.extent.height;
    auto picture = vk::Buffer::create(frame.device, {.name = name,
                                                     .size = sizeof(std::uint32_t) * pixels,
                                                     .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                                     .use = vk::MemoryUse::kWork});
    if (!picture) return picture.error();
    picture_ = std::move(*picture);
    depth_.resize(pixels);
    size_ = size;
    return {};
}

PictureCanvas Framebuffer::canvas() {
    return {.size = size_, .pixels = picture_.as<std::uint32_t>(), .depth = depth_};
}

}  // namespace onggi::render
