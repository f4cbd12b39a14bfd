#include "engine/render/frame/frame_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "engine/render/frame/pipelines.h"
#include "engine/vk/check.h"

namespace onggi::render {
namespace {

constexpr VkShaderStageFlags kBoth = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
constexpr VkDescriptorType kSampledImage = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;

constexpr vk::Binding kImage{kSampledImage, VK_SHADER_STAGE_FRAGMENT_BIT};
constexpr vk::Binding kTexels{VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT};
constexpr vk::Binding kVertexData{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT};

// In the order of the kBind... constants.
constexpr std::array kBindings{vk::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, kBoth},
                               kImage,
                               vk::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kBoth},
                               kVertexData,
                               kTexels,
                               kImage,
                               kImage,
                               kImage,
                               kImage,
                               kImage,
                               kVertexData,
                               vk::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT}};
static_assert(kBindings.size() == shaders::kBindings);

// Vulkan does not guarantee these features for this format; every known desktop driver has them.
Result<void> check_depth_format(const vk::Device& device) {
    constexpr VkFormatFeatureFlags kFeatures =
        VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT;
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.physical(), kDepthFormat, &properties);
    if ((properties.optimalTilingFeatures & kFeatures) == kFeatures) return {};
    return system_lacks(fmt::format("Vulkan device {}: expected reading of D32_SFLOAT images, found none",
                                    device.description().name));
}

Result<void> create_shadow_map(FrameContext& frame) {
    auto sampler = vk::create_sampler(frame.device,
                                      {.filter = VK_FILTER_NEAREST,
                                       .address_u = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER,
                                       .address_v = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER,
                                       .compares = true},
                                      "compared");
    if (!sampler) return sampler.error();
    frame.compared = std::move(*sampler);
    auto map = vk::Image::create(
        frame.device, {.name = "still life's shadow map",
                       .format = kDepthFormat,
                       .extent = {shaders::kShadowMapTexels, shaders::kShadowMapTexels},
                       .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                       .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
    if (!map) return map.error();
    frame.shadow_map = std::move(*map);
    vk::write_image(frame.device, frame.set(), shaders::kBindShadowMap, frame.shadow_map.view(),
                    frame.compared.get());
    // A bound image must have a layout, even if the scene neither draws nor reads it.
    return frame.device.run_once([&](VkCommandBuffer once) {
        vk::barrier(once, frame.shadow_map, vk::state::kUndefined, vk::state::kSampled);
    });
}

}  // namespace

Result<void> FrameContext::create_layout(std::size_t bindings) {
    auto set = vk::create_set(device, std::span(kBindings).first(bindings), "scene");
    if (!set) return set.error();
    scene_set = std::move(*set);
    constexpr auto kPushBytes = static_cast<std::uint32_t>(
        std::max({sizeof(shaders::MeshDraw), sizeof(shaders::LatheDraw), sizeof(shaders::PropDraw)}));
    static_assert(kPushBytes <= 128);  // every device supports 128
    auto made = vk::create_pipeline_layout(device, scene_set.layout.get(), kPushBytes, "scene");
    if (!made) return made.error();
    layout = std::move(*made);
    return {};
}

Result<void> FrameContext::create(std::size_t bindings) {
    if (auto there = check_depth_format(device); !there) return there;
    if (auto made = create_layout(bindings); !made) return made;
    if (auto made = create_shadow_map(*this); !made) return made;
    auto allocated = device.allocate_commands("frame");
    if (!allocated) return allocated.error();
    commands = *allocated;
    auto buffer = vk::Buffer::create(
        device,
        {.name = "frame", .size = sizeof(shaders::FrameData), .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT});
    if (!buffer) return buffer.error();
    uniforms = std::move(*buffer);
    vk::write_buffer(device, set(), shaders::kBindFrame, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                     uniforms.handle());
    auto made_clock = PassClock::create(device, desc);
    if (!made_clock) return made_clock.error();
    clock = std::move(*made_clock);
    return {};
}

Result<void> FrameContext::begin() {
    const VkCommandBufferBeginInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                        .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    ONGGI_VK_TRY(vkBeginCommandBuffer(commands, &info));
    clock.begin(device, commands);
    return {};
}

Result<void> FrameContext::end(const vk::TargetImage& target) {
    const vk::ImageState done{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                              target.final_layout};
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kColour, done);
    // After the barrier: a mark alone does not wait for every command on a software device
    // (findings/lavapipe-timestamps-do-not-wait-for-a-blit.sh).
    clock.end(device, commands);
    ONGGI_VK_TRY(vkEndCommandBuffer(commands));
    return {};
}

void FrameContext::build(const Scene& scene, const StillBounds& still) {
    const EdgeView seen = view(scene);
    build_frame(scene, still, desc, seen.width_px, seen.height_px, built);
    stats = {.rings = static_cast<int>(built.rows.size()), .ring_error_px = built.ring_error_px};
}

void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::span<const PassColour> colours,
                const PassDepth& depth) {
    std::vector<VkRenderingAttachmentInfo> colour_infos;
    for (const PassColour& colour : colours) {
        VkRenderingAttachmentInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                       .imageView = colour.view,
                                       .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                       .loadOp = colour.load,
                                       .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
        if (colour.resolve != VK_NULL_HANDLE) {
            info.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
            info.resolveImageView = colour.resolve;
            info.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
            info.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        }
        colour_infos.push_back(info);
    }
    const VkRenderingAttachmentInfo depth_info{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                               .imageView = depth.view,
                                               .imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                               .loadOp = depth.load,
                                               .storeOp = depth.store,
                                               .clearValue = {.depthStencil = {1.0F, 0}}};

    const VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                               .renderArea = {{0, 0}, extent},
                               .layerCount = 1,
                               .colorAttachmentCount = static_cast<std::uint32_t>(colour_infos.size()),
                               .pColorAttachments = colour_infos.data(),
                               .pDepthAttachment = depth.view == VK_NULL_HANDLE ? nullptr : &depth_info};
    vkCmdBeginRendering(commands, &info);

    const VkViewport viewport{0.0F, 0.0F, static_cast<float>(extent.width), static_cast<float>(extent.height),
                              0.0F, 1.0F};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &info.renderArea);
}

void rows_in_buffer(std::span<const PixelRect> rects, std::uint32_t width_px,
                    std::vector<VkBufferImageCopy>& regions) {
    regions.clear();
    for (const PixelRect& rect : rects) {
        const VkBufferImageCopy region{
            .bufferOffset = VkDeviceSize{4} * (static_cast<VkDeviceSize>(rect.y) * width_px +
                                               static_cast<VkDeviceSize>(rect.x)),
            .bufferRowLength = width_px,
            .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
            .imageOffset = {rect.x, rect.y, 0},
            .imageExtent = {static_cast<std::uint32_t>(rect.width), static_cast<std::uint32_t>(rect.height),
                            1}};
        regions.push_back(region);
    }
}

}  // namespace onggi::render
