#include "engine/render/host_glide.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::render {
namespace {

// kDims of shaders/glide.frag for one byte, with the square-root transfer.
std::uint8_t dimmed(std::size_t value, float left) {
    const float shown = static_cast<float>(value) / 255.0F;
    const float curve = shown * shown;
    const float light = left * 0.35F * curve / (1.0F - 0.8F * curve);
    return static_cast<std::uint8_t>(std::sqrt(light / (light * 0.8F + 0.35F)) * 255.0F + 0.5F);
}

}  // namespace

Result<void> HostGlide::fit(const FrameContext& frame) {
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (picture_.size() == bytes) return {};
    for (auto [into, name] : {std::pair{&picture_, "bent photographs"}, {&depth_, "their depth"}}) {
        auto buffer = vk::Buffer::create(
            frame.device, {.name = name, .size = bytes, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
        if (!buffer) return buffer.error();
        *into = std::move(*buffer);
    }
    return {};
}

void HostGlide::fit_mesh(const Scene& scene) {
    const std::uint64_t revision = scene.still_life ? scene.still_life->revision : 0;
    if (scene.still_life == mesh_of_ && revision == mesh_revision_) return;
    mesh_ = scene.still_life ? bendable_mesh(*scene.still_life) : BendableMesh{};
    mesh_of_ = scene.still_life;
    mesh_revision_ = revision;
}

Result<void> HostGlide::bend(const FrameContext& frame, const Scene& scene, PlatePass& plates) {
    if (auto fitted = fit(frame); !fitted) return fitted;
    const Glide& glide = *scene.glide;
    const auto from = plates.bendable(frame, scene.plate);
    if (!from) return from.error();
    const auto to = plates.bendable(frame, glide.towards);
    if (!to) return to.error();
    const shaders::FrameData& data = frame.built.frame;
    fill_shadow_mask(data, *mask_);
    const BendView view{data, *scene.plate, *glide.towards, *mask_};

    BentPicture picture{.width = static_cast<int>(frame.extent.width),
                        .height = static_cast<int>(frame.extent.height),
                        .pixels = picture_.as<std::uint32_t>(),
                        .depth = depth_.as<float>(),
                        .from = &*(*from)->photographs,
                        .to = &*(*to)->photographs,
                        .mask = mask_.get(),
                        .order = byte_order(frame.desc.colour_format)};
    const bool is_day = scene.levels.ambient == vec3(1.0F) && scene.levels.key == 1.0F;
    if (!is_day) {
        for (int channel = 0; channel < 3; ++channel) {
            const float left = 0.4F * scene.levels.ambient[channel] + 0.6F * scene.levels.key;
            const int at = picture.order == ByteOrder::kRedFirst ? channel : 2 - channel;
            auto& table = dimmed_[static_cast<std::size_t>(at)];
            for (std::size_t value = 0; value < table.size(); ++value)
                table[value] = dimmed(value, left);
        }
        picture.dimmed = &dimmed_;
    }

    const BendablePlate& nearer = **(glide.share < 0.5F ? from : to);
    bend_corners(nearer.relief_mm, view, relief_);
    fit_mesh(scene);
    bend_corners(mesh_, view, surface_);
    float nearest_mm = std::numeric_limits<float>::infinity();
    for (const SurfaceCorner& corner : surface_)
        nearest_mm = std::min(nearest_mm, corner.away_mm);
    order_relief(nearer.cells, relief_, nearest_mm, order_);
    std::fill(picture.depth.begin(), picture.depth.end(), 1.0F);
    const std::span<const Quad> sheet = order_.quads;
    bend_relief(relief_, sheet.first(order_.behind), picture);
    bend_surface(surface_, mesh_.triangles, picture);
    bend_relief(relief_, sheet.subspan(order_.behind), picture);

    const TileGrid grid{picture.width, picture.height};
    constexpr std::uint64_t kNoOtherTile = std::uint64_t{1} << 62U;
    numbers_.assign(grid.count(), kNoOtherTile | ++last_number_);
    return {};
}

void HostGlide::record_depth(const FrameContext& frame) {
    const vk::Image& depth = frame.images.depth;
    if (frame.built.moving_rects.empty()) {
        vk::barrier(frame.commands, depth, vk::state::kDiscard, vk::state::kDepth);
        return;
    }
    rows_in_buffer(frame.built.moving_rects, frame.extent.width, regions_);
    for (VkBufferImageCopy& region : regions_)
        region.imageSubresource.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT;
    vk::barrier(frame.commands, depth, vk::state::kDiscard, vk::state::kCopyTarget);
    vkCmdCopyBufferToImage(frame.commands, depth_.handle(), depth.handle(),
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, static_cast<std::uint32_t>(regions_.size()),
                           regions_.data());
    vk::barrier(frame.commands, depth, vk::state::kCopyTarget, vk::state::kDepth);
}

}  // namespace onggi::render
