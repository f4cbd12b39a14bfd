#include "engine/render/cpu/still_layers.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "engine/render/cpu/touched.h"
#include "engine/render/frame/pipelines.h"
#include "engine/vk/readback.h"

namespace onggi::render {
namespace {

// What is drawn at once: all of the picture's width, and these of its rows.
struct Band {
    VkExtent2D extent;
    std::uint32_t top = 0;
};

Result<vk::Image> layer(const FrameContext& frame, const Band& band, const char* name, VkFormat format) {
    return vk::Image::create(
        frame.device, {.name = name,
                       .format = format,
                       .extent = band.extent,
                       .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
}

Result<vk::Image> depth_layer(const FrameContext& frame, const Band& band) {
    return vk::Image::create(
        frame.device, {.name = "still life's depth",
                       .format = kDepthFormat,
                       .extent = band.extent,
                       .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                       .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
}

struct Reading {
    const vk::Image& image;
    const vk::Buffer& into;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

void record_reading(const FrameContext& frame, const Band& band, const Reading& reading,
                    const vk::ImageState& drawn) {
    vk::barrier(frame.commands, reading.image, drawn, vk::state::kCopySource);
    const VkBufferImageCopy region{.bufferOffset = VkDeviceSize{4} * band.top * band.extent.width,
                                   .imageSubresource = {reading.aspect, 0, 0, 1},
                                   .imageExtent = {band.extent.width, band.extent.height, 1}};
    vkCmdCopyImageToBuffer(frame.commands, reading.image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           reading.into.handle(), 1, &region);
}

// In commands of their own: `draw` inside a pass over cleared images, and then what came of it, with its
// depth, to where the host reads it.
template <typename Draw>
Result<void> draw_and_read(FrameContext& frame, const Band& band, std::span<const Reading> readings,
                           const vk::Buffer& depth_into, Draw&& draw) {
    const auto depth = depth_layer(frame, band);
    if (!depth) return depth.error();
    return frame.run_once([&] {
        const VkCommandBuffer commands = frame.commands;
        std::vector<PassColour> colours;
        for (const Reading& reading : readings) {
            vk::barrier(commands, reading.image, vk::state::kUndefined, vk::state::kColour);
            colours.push_back({.view = reading.image.view(), .load = VK_ATTACHMENT_LOAD_OP_CLEAR});
        }
        vk::barrier(commands, *depth, vk::state::kUndefined, vk::state::kDepth);
        begin_pass(commands, band.extent, colours,
                   {.view = depth->view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
        const VkViewport whole{0.0F,
                               -static_cast<float>(band.top),
                               static_cast<float>(frame.extent.width),
                               static_cast<float>(frame.extent.height),
                               0.0F,
                               1.0F};
        vkCmdSetViewport(commands, 0, 1, &whole);
        draw();
        vkCmdEndRendering(commands);
        record_reading(frame, band, {*depth, depth_into, VK_IMAGE_ASPECT_DEPTH_BIT}, vk::state::kDepth);
        for (const Reading& reading : readings)
            record_reading(frame, band, reading, vk::state::kColour);
        vk::barrier_to_host(commands);
    });
}

}  // namespace

Result<void> StillLayers::fit(const FrameContext& frame) {
    const VkExtent2D extent = frame.extent;
    if (extent.width == extent_.width && extent.height == extent_.height) return {};
    extent_ = {};
    struct Request {
        vk::Buffer& into;
        const char* name;
    };
    for (const Request& request : {Request{with_key_, "still life with the key light"},
                                   Request{without_key_, "still life without the key light"},
                                   Request{places_, "still life's places in the shadow mask"},
                                   Request{depth_, "still life's depth"}}) {
        auto buffer = vk::Buffer::create(
            frame.device, {.name = request.name,
                           .size = VkDeviceSize{4} * extent.width * extent.height,
                           .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                           .use = vk::MemoryUse::kReadback});
        if (!buffer) return buffer.error();
        request.into = std::move(*buffer);
        touch(request.into);
    }
    extent_ = extent;
    return {};
}

void StillLayers::let_go() {
    for (vk::Buffer* buffer : {&with_key_, &without_key_, &places_, &depth_})
        *buffer = {};
    extent_ = {};
}

Result<void> StillLayers::draw_own(FrameContext& frame, const LayerPipelines& pipelines,
                                   const StillMeshes& meshes) {
    const Band all{extent_};
    auto with_key = layer(frame, all, "still life with the key light", frame.desc.colour_format);
    if (!with_key) return with_key.error();
    auto without_key = layer(frame, all, "still life without the key light", frame.desc.colour_format);
    if (!without_key) return without_key.error();
    auto coords = layer(frame, all, "still life's places in the shadow mask", kPackedFormat);
    if (!coords) return coords.error();
    const std::array readings{Reading{*with_key, with_key_}, Reading{*without_key, without_key_},
                              Reading{*coords, places_}};
    return draw_and_read(frame, all, readings, depth_, [&] {
        frame.bind(pipelines.still);
        meshes.draw(frame, StillMeshes::Which::kAll);
        frame.draw_screen(pipelines.backdrop);
    });
}

Result<void> StillLayers::draw_places(FrameContext& frame, const LayerPipelines& pipelines,
                                      const StillMeshes& meshes, RowSpan rows) {
    const Band band{{extent_.width, static_cast<std::uint32_t>(rows.end - rows.first)},
                    static_cast<std::uint32_t>(rows.first)};
    auto foot = layer(frame, band, "still life's nearness to the foot", frame.desc.colour_format);
    if (!foot) return foot.error();
    auto coords = layer(frame, band, "still life's places in the shadow mask", kPackedFormat);
    if (!coords) return coords.error();
    const std::array readings{Reading{*foot, without_key_}, Reading{*coords, places_}};
    return draw_and_read(frame, band, readings, depth_, [&] {
        frame.bind(pipelines.places);
        meshes.draw(frame, StillMeshes::Which::kAll);
    });
}

void StillLayers::lay(const HostBackground& background, vec4 window, RowSpan rows) {
    lay_photographs(background, window, static_cast<int>(extent_.width), rows, with_key_.as<std::uint32_t>(),
                    without_key_.as<std::uint32_t>());
}

void StillLayers::turn_into_places() {
    render::turn_into_places(places_.as<std::uint32_t>());
}

ShadeLayers StillLayers::layers() const {
    return {.width = static_cast<int>(extent_.width),
            .height = static_cast<int>(extent_.height),
            .with_key = with_key_.as<std::uint32_t>(),
            .without_key = without_key_.as<std::uint32_t>(),
            .places = places_.as<std::uint32_t>()};
}

}  // namespace onggi::render
