#include "engine/render/edge_pass.h"

#include <algorithm>
#include <span>

#include "engine/render/lathe_edges.h"

namespace onggi::render {

Result<void> EdgePass::create(const FrameContext& frame) {
    std::vector<std::uint16_t> indices;
    static_assert(kStripCorners * kMaxEdges <= 65536);
    for (std::size_t first = 0; first < kStripCorners * kMaxEdges; first += kStripCorners) {
        for (const std::size_t corner : {0U, 1U, 2U, 2U, 1U, 3U})
            indices.push_back(static_cast<std::uint16_t>(first + corner));
    }
    const auto bytes = std::as_bytes(std::span(indices));
    auto index_buffer = vk::Buffer::create(
        frame.device,
        {.name = "outlines' strips", .size = bytes.size(), .usage = VK_BUFFER_USAGE_INDEX_BUFFER_BIT});
    if (!index_buffer) return index_buffer.error();
    indices_ = std::move(*index_buffer);
    indices_.write(bytes);
    auto corners = vk::Buffer::create(frame.device, {.name = "outlines",
                                                     .size = sizeof(StripCorner) * kStripCorners * kMaxEdges,
                                                     .usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT});
    if (!corners) return corners.error();
    corner_buffer_ = std::move(*corners);
    vk::write_image(frame.device, frame.set(), shaders::kBindPicture, frame.images.mask.view(),
                    frame.pipelines.exact.get());
    return {};
}

void EdgePass::resized(const FrameContext& frame) const {
    if (!frame.desc.cached) return;
    vk::write_image(frame.device, frame.set(), shaders::kBindPicture, frame.images.drawn.view(),
                    frame.pipelines.exact.get());
}

void EdgePass::upload(FrameContext& frame) {
    if (frame.built.edges.empty()) return;
    make_strips(frame.built.edges, vec2(frame.extent.width, frame.extent.height), corners_);
    frame.write(corner_buffer_, std::as_bytes(std::span(corners_)));
}

void EdgePass::record(const FrameContext& frame, const vk::TargetImage& target) const {
    const PixelRect& moving = frame.built.moving;
    if (frame.built.edges.empty() || moving.width <= 0 || moving.height <= 0 || !target.can_be_read) return;
    const VkCommandBuffer commands = frame.commands;
    const vk::Image& drawn = frame.images.drawn;
    constexpr VkImageAspectFlags kColourAspect = VK_IMAGE_ASPECT_COLOR_BIT;
    vk::barrier(commands, target.image, kColourAspect, vk::state::kColour, vk::state::kCopySource);
    vk::barrier(commands, drawn, vk::state::kDiscard, vk::state::kCopyTarget);
    copy_rects(commands, target.image, drawn.handle(), frame.built.edge_rects);
    vk::barrier(commands, drawn, vk::state::kCopyTarget, vk::state::kSampled);
    vk::barrier(commands, target.image, kColourAspect, vk::state::kCopySource, vk::state::kColour);
    vk::barrier(commands, frame.images.depth, vk::state::kDepth, vk::state::kDepth);
    begin_pass(commands, frame.extent, {{.view = target.view, .load = VK_ATTACHMENT_LOAD_OP_LOAD}},
               {.view = frame.images.depth.view(), .load = VK_ATTACHMENT_LOAD_OP_LOAD});
    // One pixel in from the copy's border: a strip reads its neighbours.
    set_scissor(commands,
                {moving.x + 1, moving.y + 1, std::max(moving.width - 2, 1), std::max(moving.height - 2, 1)});
    frame.bind(frame.pipelines.edges);
    const VkBuffer buffer = corner_buffer_.handle();
    const VkDeviceSize offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &buffer, &offset);
    vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT16);
    vkCmdDrawIndexed(commands, static_cast<std::uint32_t>(frame.built.edges.size() * 6), 1, 0, 0, 0);
    vkCmdEndRendering(commands);
}

}  // namespace onggi::render
