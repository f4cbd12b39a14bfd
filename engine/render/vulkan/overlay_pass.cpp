#include "engine/render/vulkan/overlay_pass.h"

#include <array>
#include <cstddef>

#include "engine/render/frame/frame_context.h"
#include "shaders/shaders.h"

namespace onggi::render {
namespace {

struct Push {
    vec2 clip_per_px;
    vec2 atlas_per_px;
};

constexpr std::array kCornerAttributes{
    VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ui::Vertex, position_px)},
    VkVertexInputAttributeDescription{1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ui::Vertex, atlas_px)},
    VkVertexInputAttributeDescription{2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(ui::Vertex, rgba)}};

constexpr std::array kBindings{
    vk::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT}};

VkDeviceSize bytes_of(const ui::Painting& painting) {
    return painting.rgba.size();
}

}  // namespace

Result<void> OverlayPass::create(const VulkanFrame& frame) {
    const vk::Device& device = frame.device;
    auto set = vk::create_set(device, kBindings, "overlay");
    if (!set) return set.error();
    set_ = std::move(*set);
    auto layout = vk::create_pipeline_layout(device, set_.layout.get(), sizeof(Push), "overlay");
    if (!layout) return layout.error();
    layout_ = std::move(*layout);
    auto sampler = vk::create_sampler(device, {}, "overlay");
    if (!sampler) return sampler.error();
    sampler_ = std::move(*sampler);

    const std::array formats{frame.desc.colour_format};
    vk::PipelineDesc desc{.name = "overlay boxes",
                          .vertex_spirv = shaders::kUiVert,
                          .fragment_spirv = shaders::kUiFrag,
                          .layout = layout_.get(),
                          .attributes = kCornerAttributes,
                          .vertex_stride = sizeof(ui::Vertex),
                          .colour_formats = formats,
                          .blend = true,
                          .cull = VK_CULL_MODE_NONE};
    auto boxes = vk::create_pipeline(device, desc);
    if (!boxes) return boxes.error();
    boxes_ = std::move(*boxes);
    desc.name = "overlay pictures";
    desc.fragment_spirv = shaders::kUiPictureFrag;
    auto pictures = vk::create_pipeline(device, desc);
    if (!pictures) return pictures.error();
    pictures_ = std::move(*pictures);
    return {};
}

Result<void> OverlayPass::fit_atlas(const VulkanFrame& frame, int side_px) {
    const auto side = static_cast<std::uint32_t>(side_px);
    if (atlas_.extent().width == side) return {};
    auto atlas = vk::Image::create(frame.device,
                                   {.name = "atlas",
                                    .extent = {side, side},
                                    .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    if (!atlas) return atlas.error();
    atlas_ = std::move(*atlas);
    atlas_is_new_ = true;
    vk::write_image(frame.device, set_.set, 0, atlas_.view(), sampler_.get());
    return {};
}

Result<void> OverlayPass::fit_kept(const VulkanFrame& frame) {
    const VkExtent2D have = kept_.extent();
    if (have.width == frame.target_extent.width && have.height == frame.target_extent.height) return {};
    auto kept = vk::Image::create(
        frame.device, {.name = "kept overlay",
                       .format = frame.desc.colour_format,
                       .extent = frame.target_extent,
                       .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    if (!kept) return kept.error();
    kept_ = std::move(*kept);
    kept_hash_ = 0;
    return {};
}

Result<void> OverlayPass::fill(const VulkanFrame& frame, const ui::DrawList& list) {
    const auto vertices = std::as_bytes(list.vertices());
    const auto indices = std::as_bytes(list.indices());
    if (auto made = vk::make_room(frame.device, vertices_, "overlay vertices", vertices.size(),
                                  VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
        !made) {
        return made;
    }
    if (auto made = vk::make_room(frame.device, indices_, "overlay indices", indices.size(),
                                  VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
        !made) {
        return made;
    }
    if (!vertices.empty()) vertices_.write(vertices);
    if (!indices.empty()) indices_.write(indices);
    frame.work.uploaded_bytes += vertices.size() + indices.size();
    return {};
}

Result<void> OverlayPass::fit(const VulkanFrame& frame, const Overlay* overlay) {
    overlay_ = overlay;
    if (overlay_ == nullptr) return {};
    if (auto fitted = fit_atlas(frame, overlay_->atlas_side_px); !fitted) return fitted;
    VkDeviceSize upload_bytes = 0;
    for (const ui::Atlas::Upload& upload : overlay_->uploads)
        upload_bytes += bytes_of(*upload.painting);
    if (auto made = vk::make_room(frame.device, staging_, "atlas upload", upload_bytes,
                                  VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
        !made) {
        return made;
    }
    std::size_t at = 0;
    for (const ui::Atlas::Upload& upload : overlay_->uploads) {
        staging_.write(std::as_bytes(std::span(upload.painting->rgba)), at);
        at += upload.painting->rgba.size();
        frame.work.uploaded_bytes += upload.painting->rgba.size();
    }
    hash_ = overlay_->list->hash();
    if (overlay_->covers) {
        if (auto fitted = fit_kept(frame); !fitted) return fitted;
    }
    return fill(frame, *overlay_->list);
}

void OverlayPass::record_uploads(const VulkanFrame& frame) {
    if (overlay_ == nullptr) return;
    if (overlay_->uploads.empty() && !atlas_is_new_) return;
    const VkCommandBuffer commands = frame.commands;
    vk::barrier(commands, atlas_, atlas_is_new_ ? vk::state::kUndefined : vk::state::kSampled,
                vk::state::kCopyTarget);
    atlas_is_new_ = false;
    VkDeviceSize at = 0;
    for (const ui::Atlas::Upload& upload : overlay_->uploads) {
        const VkBufferImageCopy region{
            .bufferOffset = at,
            .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
            .imageOffset = {upload.x, upload.y, 0},
            .imageExtent = {static_cast<std::uint32_t>(upload.painting->width),
                            static_cast<std::uint32_t>(upload.painting->height), 1}};
        vkCmdCopyBufferToImage(commands, staging_.handle(), atlas_.handle(),
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
        at += bytes_of(*upload.painting);
    }
    vk::barrier(commands, atlas_, vk::state::kCopyTarget, vk::state::kSampled);
    kept_hash_ = 0;  // the atlas has changed, so the same list may look different
}

void OverlayPass::draw_list(const VulkanFrame& frame, VkImageView view, bool keep_what_is_there) const {
    const VkCommandBuffer commands = frame.commands;
    begin_pass(commands, frame.target_extent,
               {{.view = view,
                 .load = keep_what_is_there ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_DONT_CARE}},
               {});
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set_.set, 0,
                            nullptr);
    const float side = static_cast<float>(overlay_->atlas_side_px);
    const Push push{.clip_per_px = 2.0F / vec2(frame.target_extent.width, frame.target_extent.height),
                    .atlas_per_px = vec2(1.0F / side)};
    vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof push, &push);
    if (!overlay_->list->runs().empty()) {
        const VkBuffer vertices = vertices_.handle();
        constexpr VkDeviceSize kStart = 0;
        vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &kStart);
        vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
    }
    for (const ui::Run& run : overlay_->list->runs()) {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                          run.from_atlas ? pictures_.get() : boxes_.get());
        vkCmdDrawIndexed(commands, run.index_count, 1, run.first_index, 0, 0);
        frame.count_draw(run.index_count);
    }
    vkCmdEndRendering(commands);
}

void OverlayPass::record(const VulkanFrame& frame, const vk::TargetImage& target, bool after_scene) {
    if (overlay_ == nullptr) return;
    if (after_scene) {
        if (!overlay_->list->runs().empty()) {
            vk::barrier(frame.commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kColour,
                        vk::state::kColour);
            draw_list(frame, target.view, true);
        }
        return;
    }
    const VkCommandBuffer commands = frame.commands;
    if (kept_hash_ != hash_) {
        vk::barrier(commands, kept_, vk::state::kDiscard, vk::state::kColour);
        draw_list(frame, kept_.view(), false);
        vk::barrier(commands, kept_, vk::state::kColour, vk::state::kCopySource);
        kept_hash_ = hash_;
    }
    constexpr VkImageAspectFlags kAspect = VK_IMAGE_ASPECT_COLOR_BIT;
    vk::barrier(commands, target.image, kAspect, vk::state::kDiscard, vk::state::kCopyTarget);
    vk::copy(commands, kept_.handle(), target.image, kAspect, {{0, 0}, frame.target_extent});
    vk::barrier(commands, target.image, kAspect, vk::state::kCopyTarget, vk::state::kColour);
}

}  // namespace onggi::render
