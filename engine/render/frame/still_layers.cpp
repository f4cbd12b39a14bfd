#include "engine/render/frame/still_layers.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "engine/render/pixels/photograph_layers.h"
#include "engine/vk/readback.h"

namespace onggi::render {
namespace {

Result<vk::Image> layer(const FrameContext& frame, const char* name, VkFormat format) {
    return vk::Image::create(
        frame.device, {.name = name,
                       .format = format,
                       .extent = frame.extent,
                       .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
}

Result<vk::Image> depth_layer(const FrameContext& frame) {
    return vk::Image::create(
        frame.device, {.name = "still life's depth",
                       .format = kDepthFormat,
                       .extent = frame.extent,
                       .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                       .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
}

struct Reading {
    const vk::Image& image;
    const vk::Buffer& into;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

void record_reading(const FrameContext& frame, const Reading& reading, const vk::ImageState& drawn) {
    vk::barrier(frame.commands, reading.image, drawn, vk::state::kCopySource);
    VkBufferImageCopy region{};
    region.imageSubresource = {reading.aspect, 0, 0, 1};
    region.imageExtent = {frame.extent.width, frame.extent.height, 1};
    vkCmdCopyImageToBuffer(frame.commands, reading.image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           reading.into.handle(), 1, &region);
}

// In commands of their own: `draw` inside a pass over cleared images, and then what came of it, with its
// depth, to where the host reads it.
template <typename Draw>
Result<void> draw_and_read(FrameContext& frame, std::span<const Reading> readings,
                           const vk::Buffer& depth_into, Draw&& draw) {
    const auto depth = depth_layer(frame);
    if (!depth) return depth.error();
    return frame.run_once([&] {
        const VkCommandBuffer commands = frame.commands;
        std::vector<PassColour> colours;
        for (const Reading& reading : readings) {
            vk::barrier(commands, reading.image, vk::state::kUndefined, vk::state::kColour);
            colours.push_back({.view = reading.image.view(), .load = VK_ATTACHMENT_LOAD_OP_CLEAR});
        }
        vk::barrier(commands, *depth, vk::state::kUndefined, vk::state::kDepth);
        begin_pass(commands, frame.extent, colours,
                   {.view = depth->view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
        draw();
        vkCmdEndRendering(commands);
        record_reading(frame, {*depth, depth_into, VK_IMAGE_ASPECT_DEPTH_BIT}, vk::state::kDepth);
        for (const Reading& reading : readings)
            record_reading(frame, reading, vk::state::kColour);
        vk::barrier_to_host(commands);
    });
}

}  // namespace

Result<bool> StillLayers::fit(const FrameContext& frame) {
    const VkExtent2D extent = frame.extent;
    if (extent.width == extent_.width && extent.height == extent_.height) return false;
    extent_ = {};
    struct Wish {
        vk::Buffer& into;
        const char* name;
    };
    for (const Wish& wish :
         {Wish{with_key_, "still life with the key light"},
          Wish{without_key_, "still life without the key light"},
          Wish{places_, "still life's places in the shadow mask"}, Wish{depth_, "still life's depth"}}) {
        auto buffer =
            vk::Buffer::create(frame.device, {.name = wish.name,
                                              .size = VkDeviceSize{4} * extent.width * extent.height,
                                              .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                              .use = vk::MemoryUse::kReadback});
        if (!buffer) return buffer.error();
        wish.into = std::move(*buffer);
    }
    extent_ = extent;
    return true;
}

void StillLayers::let_go() {
    for (vk::Buffer* buffer : {&with_key_, &without_key_, &places_, &depth_})
        *buffer = {};
    extent_ = {};
}

Result<void> StillLayers::draw(FrameContext& frame, const Scene& scene, const StillMeshes& meshes,
                               const PlatePass* plates) {
    const auto drawn =
        plates != nullptr ? draw_photographed(frame, scene, meshes, *plates) : draw_own(frame, meshes);
    if (!drawn) return drawn;
    turn_into_places(places_.as<std::uint32_t>());
    return {};
}

Result<void> StillLayers::draw_own(FrameContext& frame, const StillMeshes& meshes) {
    auto with_key = layer(frame, "still life with the key light", frame.desc.colour_format);
    if (!with_key) return with_key.error();
    auto without_key = layer(frame, "still life without the key light", frame.desc.colour_format);
    if (!without_key) return without_key.error();
    auto coords = layer(frame, "still life's places in the shadow mask", kPackedFormat);
    if (!coords) return coords.error();
    const std::array readings{Reading{*with_key, with_key_}, Reading{*without_key, without_key_},
                              Reading{*coords, places_}};
    return draw_and_read(frame, readings, depth_, [&] {
        frame.bind(frame.pipelines.still);
        meshes.draw(frame.commands, frame.pipelines.layout.get(), StillMeshes::Which::kAll);
        frame.draw_screen(frame.pipelines.backdrop);
    });
}

Result<void> StillLayers::draw_photographed(FrameContext& frame, const Scene& scene,
                                            const StillMeshes& meshes, const PlatePass& plates) {
    const auto plate = plates.bendable(scene.plate);
    if (!plate) return plate.error();
    auto foot = layer(frame, "still life's nearness to the foot", frame.desc.colour_format);
    if (!foot) return foot.error();
    auto coords = layer(frame, "still life's places in the shadow mask", kPackedFormat);
    if (!coords) return coords.error();
    const std::array readings{Reading{*foot, without_key_}, Reading{*coords, places_}};
    auto drawn = draw_and_read(frame, readings, depth_, [&] {
        frame.bind(frame.pipelines.places);
        meshes.draw(frame.commands, frame.pipelines.layout.get(), StillMeshes::Which::kAll);
    });
    if (!drawn) return drawn;
    lay_photographs((*plate)->photographs, frame.built.frame.plate_window, static_cast<int>(extent_.width),
                    with_key_.as<std::uint32_t>(), without_key_.as<std::uint32_t>());
    return {};
}

ShadeLayers StillLayers::layers() const {
    return {.width = static_cast<int>(extent_.width),
            .height = static_cast<int>(extent_.height),
            .with_key = with_key_.as<std::uint32_t>(),
            .without_key = without_key_.as<std::uint32_t>(),
            .places = places_.as<std::uint32_t>()};
}

}  // namespace onggi::render
