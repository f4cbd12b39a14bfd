#include "engine/render/edge_pass.h"

#include <algorithm>

#include "engine/render/lathe_edges.h"

namespace onggi::render {

Result<void> EdgePass::create(const FrameContext& frame) {
    auto buffer = vk::Buffer::create(frame.device, {.name = "outlines",
                                                    .size = sizeof(shaders::EdgeData) * kMaxEdges,
                                                    .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    if (!buffer) return buffer.error();
    edges_ = std::move(*buffer);
    vk::write_buffer(frame.device, frame.set(), shaders::kBindEdges, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                     edges_.handle());
    vk::write_image(frame.device, frame.set(), shaders::kBindPicture, frame.images.mask.view(),
                    frame.pipelines.exact.get());
    return {};
}

void EdgePass::resized(const FrameContext& frame) const {
    if (!frame.desc.cached) return;
    vk::write_image(frame.device, frame.set(), shaders::kBindPicture, frame.images.drawn.view(),
                    frame.pipelines.exact.get());
}

void EdgePass::upload(FrameContext& frame) const {
    if (!frame.built.edges.empty()) frame.write(edges_, std::as_bytes(std::span(frame.built.edges)));
}

void EdgePass::record(const FrameContext& frame, const vk::TargetImage& target) const {
    const PixelRect& moving = frame.built.moving;
    if (frame.built.edges.empty() || moving.width <= 0 || moving.height <= 0 || !target.can_be_read) return;
    const VkCommandBuffer commands = frame.commands;
    const vk::Image& drawn = frame.images.drawn;
    constexpr VkImageAspectFlags kColourAspect = VK_IMAGE_ASPECT_COLOR_BIT;
    vk::barrier(commands, target.image, kColourAspect, vk::state::kColour, vk::state::kCopySource);
    vk::barrier(commands, drawn, vk::state::kDiscard, vk::state::kCopyTarget);
    copy_rects(commands, target.image, drawn.handle(), kColourAspect, frame.built.edge_rects);
    vk::barrier(commands, drawn, vk::state::kCopyTarget, vk::state::kSampled);
    vk::barrier(commands, target.image, kColourAspect, vk::state::kCopySource, vk::state::kColour);
    vk::barrier(commands, frame.images.depth, vk::state::kDepth, vk::state::kDepth);
    begin_pass(commands, frame.extent, {{.view = target.view, .load = VK_ATTACHMENT_LOAD_OP_LOAD}},
               {.view = frame.images.depth.view(), .load = VK_ATTACHMENT_LOAD_OP_LOAD});
    // One pixel in from the copy's border: a strip reads its neighbours.
    set_scissor(commands,
                {moving.x + 1, moving.y + 1, std::max(moving.width - 2, 1), std::max(moving.height - 2, 1)});
    frame.bind(frame.pipelines.edges);
    vkCmdDraw(commands, static_cast<std::uint32_t>(frame.built.edges.size() * 6), 1, 0, 0);
    vkCmdEndRendering(commands);
}

}  // namespace onggi::render
