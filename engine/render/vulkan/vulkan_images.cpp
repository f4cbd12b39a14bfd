#include "engine/render/vulkan/vulkan_images.h"

#include <initializer_list>
#include <utility>

#include "engine/render/frame/pipelines.h"
#include "shaders/frame_data.h"

namespace onggi::render {
namespace {

struct ImageRequest {
    vk::Image& into;
    vk::ImageDesc desc;
};

Result<void> create_all(const vk::Device& device, std::initializer_list<ImageRequest> requests) {
    for (const ImageRequest& request : requests) {
        auto image = vk::Image::create(device, request.desc);
        if (!image) return image.error();
        request.into = std::move(*image);
    }
    return {};
}

}  // namespace

Result<void> create_fixed_images(const vk::Device& device, const RendererDesc& desc, VulkanImages& images) {
    constexpr VkImageUsageFlags kRead = VK_IMAGE_USAGE_SAMPLED_BIT;
    return create_all(device, {{images.detail,
                                {.name = "streaks",
                                 .format = VK_FORMAT_R8G8B8A8_UNORM,
                                 .extent = {static_cast<std::uint32_t>(desc.streaks_across),
                                            static_cast<std::uint32_t>(desc.streaks_up)},
                                 .usage = kRead | VK_IMAGE_USAGE_TRANSFER_DST_BIT}},
                               {images.mask,
                                {.name = "shadow mask",
                                 .format = kMaskFormat,
                                 .extent = {shaders::kMaskTexels, shaders::kMaskTexels},
                                 .usage = kRead | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT}}});
}

Result<void> create_sized_images(const vk::Device& device, const RendererDesc& desc, VkExtent2D extent,
                                 VulkanImages& images) {
    const auto samples = static_cast<VkSampleCountFlagBits>(desc.samples);
    auto made = create_all(device, {{images.depth,
                                     {.name = "depth",
                                      .format = kDepthFormat,
                                      .extent = extent,
                                      .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                      .samples = samples,
                                      .aspect = VK_IMAGE_ASPECT_DEPTH_BIT}}});
    if (made && desc.samples > 1) {
        made = create_all(device, {{images.multisampled,
                                    {.name = "picture, several samples a pixel",
                                     .format = desc.colour_format,
                                     .extent = extent,
                                     .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                                     .samples = samples}}});
    }
    if (!made || desc.scale == 1.0F) return made;
    return create_all(device,
                      {{images.smaller,
                        {.name = "picture, smaller than its target",
                         .format = desc.colour_format,
                         .extent = extent,
                         .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}}});
}

}  // namespace onggi::render
