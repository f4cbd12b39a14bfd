// The images a renderer draws into besides its target. Those of the picture's size are made again when it
// changes. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/renderer_desc.h"
#include "engine/vk/image.h"

namespace onggi::render {

struct FrameImages {
    // Of fixed size.
    vk::Image key_map;
    // Not when cached.
    vk::Image detail;
    vk::Image mask;
    // Of the picture's size, likewise.
    vk::Image depth;
    vk::Image multisampled;  // with samples > 1
};

Result<void> create_fixed_images(const vk::Device& device, const RendererDesc& desc, FrameImages& images);
Result<void> create_sized_images(const vk::Device& device, const RendererDesc& desc, VkExtent2D extent,
                                 FrameImages& images);

}  // namespace onggi::render
