#include "engine/render/painted_overlay.h"

#include <array>

#include "engine/render/pass.h"
#include "shaders/shaders.h"

namespace onggi::render {
namespace {

struct Push {
    vec2 clip_per_px;
    std::uint32_t width_px;
};

constexpr std::array kAttributes{VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32_SFLOAT, 0}};
constexpr std::array kBindings{vk::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT}};

}  // namespace

ByteOrder byte_order(VkFormat format) {
    return format == VK_FORMAT_B8G8R8A8_UNORM ? ByteOrder::kBlueFirst : ByteOrder::kRedFirst;
}

Result<void> PaintedOverlay::create(const FrameContext& frame) {
    const vk::Device& device = frame.device;
    auto set = vk::create_set(device, kBindings, "painted overlay");
    if (!set) return set.error();
    set_ = std::move(*set);
    auto layout = vk::create_pipeline_layout(device, set_.layout.get(), sizeof(Push), "painted overlay");
    if (!layout) return layout.error();
    layout_ = std::move(*layout);
    const std::array formats{frame.desc.colour_format};
    const std::array constants{byte_order(formats[0]) == ByteOrder::kBlueFirst ? 1U : 0U};
    auto pipeline = vk::create_pipeline(device, {.name = "painted overlay",
                                                 .vertex_spirv = shaders::kPaintedVert,
                                                 .fragment_spirv = shaders::kPaintedFrag,
                                                 .constants = constants,
                                                 .layout = layout_.get(),
                                                 .attributes = kAttributes,
                                                 .vertex_stride = sizeof(vec2),
                                                 .colour_formats = formats,
                                                 .blend = true,
                                                 .cull = VK_CULL_MODE_NONE});
    if (!pipeline) return pipeline.error();
    pipeline_ = std::move(*pipeline);
    return {};
}

Result<void> PaintedOverlay::fit_picture(const FrameContext& frame) {
    const TileGrid grid{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    if (grid == grid_ && painted_.size() > 0) return {};
    auto painted = vk::Buffer::create(
        frame.device, {.name = "painted overlay",
                       .size = VkDeviceSize{4} * frame.extent.width * frame.extent.height,
                       .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
    if (!painted) return painted.error();
    painted_ = std::move(*painted);
    vk::write_buffer(frame.device, set_.set, 0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, painted_.handle());
    grid_ = grid;
    painted_content_.assign(grid.count(), 0);
    return {};
}

Result<void> PaintedOverlay::fit(const FrameContext& frame, const Overlay* overlay) {
    if (overlay == nullptr) {
        tiles_.clear();
        return {};
    }
    if (auto fitted = fit_picture(frame); !fitted) return fitted;
    pictures_.take(overlay->uploads, overlay->atlas_side_px);
    tiles_.learn(grid_, *overlay->list, pictures_);
    const std::span<const std::uint64_t> content = tiles_.content();
    wanted_.assign(grid_.count(), 0);
    for (std::size_t tile = 0; tile < content.size(); ++tile) {
        if (content[tile] == 0 || content[tile] == painted_content_[tile]) continue;
        wanted_[tile] = 1;
        painted_content_[tile] = content[tile];
    }
    rects_of_tiles(grid_, wanted_, rects_);
    const OverlayPainting painting{*overlay->list, pictures_, byte_order(frame.desc.colour_format)};
    for (const PixelRect& rect : rects_)
        paint_overlay(painting, rect, grid_.width_px, painted_.as<std::uint32_t>());
    return {};
}

Result<void> PaintedOverlay::record(const FrameContext& frame, const vk::TargetImage& target,
                                    std::span<const std::uint8_t> tiles) {
    if (tiles_.content().empty()) return {};
    rects_of_tiles(grid_, tiles, rects_);
    if (rects_.empty()) return {};
    corners_px_.clear();
    for (const PixelRect& rect : rects_) {
        const vec2 low(rect.x, rect.y);
        const vec2 high = low + vec2(rect.width, rect.height);
        for (const vec2 corner : {low, vec2(high.x, low.y), high, low, high, vec2(low.x, high.y)})
            corners_px_.push_back(corner);
    }
    const auto bytes = std::as_bytes(std::span(corners_px_));
    if (auto made = vk::make_room(frame.device, corners_, "painted overlay's corners", bytes.size(),
                                  VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
        !made) {
        return made;
    }
    corners_.write(bytes);
    const VkCommandBuffer commands = frame.commands;
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kColour, vk::state::kColour);
    begin_pass(commands, frame.extent, {{.view = target.view, .load = VK_ATTACHMENT_LOAD_OP_LOAD}}, {});
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set_.set, 0,
                            nullptr);
    const Push push{.clip_per_px = 2.0F / vec2(frame.extent.width, frame.extent.height),
                    .width_px = frame.extent.width};
    vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof push, &push);
    const VkBuffer corners = corners_.handle();
    constexpr VkDeviceSize kStart = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &corners, &kStart);
    vkCmdDraw(commands, static_cast<std::uint32_t>(corners_px_.size()), 1, 0, 0);
    vkCmdEndRendering(commands);
    return {};
}

}  // namespace onggi::render
