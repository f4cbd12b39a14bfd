#include "engine/render/vulkan/vulkan_backend.h"

#include <algorithm>
#include <cmath>

#include "engine/render/frame/shadow_map.h"

namespace onggi::render {
namespace {

VkExtent2D scaled(VkExtent2D extent, float scale) {
    const auto side = [&](std::uint32_t px) {
        return std::max(static_cast<std::uint32_t>(std::lround(static_cast<float>(px) * scale)), 1U);
    };
    return {side(extent.width), side(extent.height)};
}

constexpr vk::ImageState kStretched{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                    VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

VkOffset3D far_corner(VkExtent2D extent) {
    return {static_cast<std::int32_t>(extent.width), static_cast<std::int32_t>(extent.height), 1};
}

}  // namespace

Result<void> VulkanBackend::create() {
    if (auto created = frame_.create(shaders::kBindings); !created) return created;
    if (auto made = create_pipelines(frame_, frame_.pipelines); !made) return made;
    if (auto made = create_fixed_images(frame_.device, frame_.desc, frame_.images); !made) return made;
    const vk::Image& mask = frame_.images.mask;
    vk::write_image(frame_.device, frame_.set(), shaders::kBindMask, mask.view(),
                    frame_.pipelines.clamped.get());
    // What is bound must be laid out, though not every scene has it drawn or read.
    auto laid_out = frame_.device.run_once(
        [&](VkCommandBuffer once) { vk::barrier(once, mask, vk::state::kUndefined, vk::state::kSampled); });
    if (!laid_out) return laid_out;
    RoomPass::create(frame_);
    ViewFade::bind_placeholder(frame_);
    if (auto created = props_.create(frame_); !created) return created;
    if (auto created = lathe_.create(frame_); !created) return created;
    return overlay_.create(frame_);
}

Result<void> VulkanBackend::fit_size(VkExtent2D target) {
    const VkExtent2D have = frame_.target_extent;
    if (target.width == have.width && target.height == have.height) return {};
    const VkExtent2D extent = scaled(target, frame_.desc.scale);
    if (auto made = create_sized_images(frame_.device, frame_.desc, extent, frame_.images); !made)
        return made;
    frame_.extent = extent;
    frame_.target_extent = target;
    return {};
}

Result<void> VulkanBackend::fit(const Scene& scene, VkExtent2D target) {
    if (auto fitted = fit_size(target); !fitted) return fitted;
    if (!scene.background) {
        if (auto fitted = fit_shadow_map(frame_); !fitted) return fitted;
    }
    if (auto made = fit_pipelines(frame_, scene, frame_.pipelines); !made) return made;
    if (auto fitted = fade_.fit(frame_, scene); !fitted) return fitted;
    return room_.fit(frame_, scene);
}

Result<void> VulkanBackend::upload(const Scene& scene) {
    frame_.clock.enter_host("shapes");
    frame_.build(scene, room_.bounds());
    frame_.stats.still_life_drawn = true;
    if (auto fitted = props_.fit(frame_, scene); !fitted) return fitted;
    shadow_.update(frame_, scene);
    frame_.clock.end_host();
    frame_.upload_uniforms(frame_.built.frame);
    return lathe_.upload(frame_);
}

Result<bool> VulkanBackend::draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) {
    const bool shows_scene = overlay == nullptr || !overlay->covers;
    if (shows_scene) {
        if (auto sent = upload(scene); !sent) return sent.error();
    }
    if (auto fitted = overlay_.fit(frame_, overlay); !fitted) return fitted.error();
    if (auto begun = frame_.begin(); !begun) return begun.error();
    frame_.enter("overlay's pictures");
    overlay_.record_uploads(frame_);
    if (shows_scene) record(scene, target);
    frame_.enter("overlay");
    overlay_.record(frame_, target, shows_scene);
    if (auto ended = frame_.end(target); !ended) return ended.error();
    frame_.stats.next_view_ready =
        shows_scene && fade_.keeps() != nullptr && room_.has(scene.next_view->background.get());
    return shows_scene;
}

void VulkanBackend::record(const Scene& scene, const vk::TargetImage& target) {
    const VkCommandBuffer commands = frame_.commands;
    const VulkanImages& images = frame_.images;
    frame_.bind_set();
    frame_.enter("shadow maps");
    room_.record(frame_, scene);
    shadow_.record(frame_);
    const vk::Image* apart = picture_apart();
    const VkImage picture = apart != nullptr ? apart->handle() : target.image;
    const VkImageView view = apart != nullptr ? apart->view() : target.view;
    vk::barrier(commands, picture, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kDiscard, vk::state::kColour);
    vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kDepth);
    PassColour colour{.view = view};
    if (frame_.desc.samples > 1) {
        vk::barrier(commands, images.multisampled, vk::state::kDiscard, vk::state::kColour);
        colour = {.view = images.multisampled.view(), .resolve = view};
    }
    begin_pass(commands, frame_.extent, {colour}, {.view = images.depth.view()});
    // Front to back, so that what is hidden is not shaded.
    frame_.enter("lathe");
    lathe_.draw(frame_);
    frame_.enter("hands and tools");
    props_.draw(frame_, scene);
    frame_.enter("still life");
    room_.draw(frame_, scene);
    fade_.draw(frame_);
    vkCmdEndRendering(commands);
    if (apart != nullptr) stretch(*apart, target);
    if (fade_.keeps() != nullptr) fade_.keep(commands, kStretched);
}

const vk::Image* VulkanBackend::picture_apart() const {
    if (fade_.keeps() != nullptr) return fade_.keeps();
    return frame_.desc.scale < 1.0F ? &frame_.images.smaller : nullptr;
}

void VulkanBackend::stretch(const vk::Image& picture, const vk::TargetImage& target) const {
    constexpr vk::ImageState kWritten{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    const VkCommandBuffer commands = frame_.commands;
    vk::barrier(commands, picture, vk::state::kColour, kStretched);
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kDiscard, kWritten);
    VkImageBlit region{};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] = far_corner(picture.extent());
    region.dstOffsets[1] = far_corner(target.extent);
    vkCmdBlitImage(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_LINEAR);
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, kWritten, vk::state::kColour);
}

}  // namespace onggi::render
