// Shared by the frames of both backends: the device objects that both need, the built scene, and the command
// buffer. Main thread. Pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame_stats.h"
#include "engine/render/overlay.h"
#include "engine/render/pass_clock.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/tiles.h"
#include "engine/vk/buffer.h"
#include "engine/vk/frame_target.h"
#include "engine/vk/image.h"
#include "engine/vk/pipeline.h"
#include "engine/vk/vulkan.h"

namespace onggi::render {

struct FrameContext {
    vk::Device& device;
    RendererDesc desc;
    vk::BoundSet scene_set{};
    vk::PipelineLayout layout{};
    // The still life's shadow map, and what reads it. The pipeline is created when a scene first needs it.
    vk::Image shadow_map{};
    vk::Sampler compared{};
    vk::Pipeline shadow_map_pipeline{};
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkExtent2D extent{};  // of the scene's picture
    BuiltFrame built{};
    FrameStats stats{};
    PassClock clock{};
    vk::Buffer uniforms{};
    mutable FrameWork work{};  // mutable, so that passes with a const frame can count their draws

    mutable std::vector<VkRect2D> changed{};  // the parts of the target that this frame draws or copies

    // Creates everything except the shadow map's pipeline, with the first `bindings` bindings of
    // shaders/frame_data.h: a software device reads bound slots even if no shader uses them. Errors: the
    // device's, or a missing format.
    Result<void> create(std::size_t bindings);
    // Creates only the set and the pipeline layout.
    Result<void> create_layout(std::size_t bindings);
    // Begin and end the command buffer. end() moves the target from the colour layout to its final layout.
    Result<void> begin();
    Result<void> end(const vk::TargetImage& target);
    // Begins a part of the frame on the device.
    void enter(const char* part) { clock.enter(device, commands, part); }

    [[nodiscard]] EdgeView view(const Scene& scene) const {
        return {scene.camera, static_cast<int>(extent.width), static_cast<int>(extent.height)};
    }
    // Builds the scene's shapes and resets the stats.
    void build(const Scene& scene, const StillBounds& still);
    void upload_uniforms(const shaders::FrameData& data) {
        uniforms.write(std::as_bytes(std::span(&data, 1)));
        work.uploaded_bytes += sizeof data;
    }

    [[nodiscard]] VkDescriptorSet set() const { return scene_set.set; }
    void bind_set() const {
        const VkDescriptorSet own = set();
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout.get(), 0, 1, &own, 0,
                                nullptr);
    }
    // Records `record` into separate commands; returns when the device has executed them.
    template <typename Record>
    Result<void> run_once(Record&& record) {
        return device.run_once([&](VkCommandBuffer once) {
            const VkCommandBuffer of_frame = std::exchange(commands, once);
            bind_set();
            record();
            commands = of_frame;
        });
    }
    void bind(const vk::Pipeline& pipeline) const {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
    }
    template <typename Constants>
    void push(const Constants& constants) const {
        vkCmdPushConstants(commands, layout.get(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
                           0, sizeof constants, &constants);
    }
    void count_draw(std::uint32_t vertices) const {
        ++work.draws;
        work.vertices += vertices;
    }
    // Draws one triangle that covers the whole target.
    void draw_screen(const vk::Pipeline& pipeline) const {
        bind(pipeline);
        vkCmdDraw(commands, 3, 1, 0, 0);
        count_draw(3);
    }
};

// Helpers for dynamic-rendering passes. Main thread.

struct PassColour {
    VkImageView view = VK_NULL_HANDLE;
    VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_DONT_CARE;  // if cleared: to 0
    VkImageView resolve = VK_NULL_HANDLE;  // receives the average of the samples; the samples are discarded
};

struct PassDepth {
    VkImageView view = VK_NULL_HANDLE;                      // null: no depth
    VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_CLEAR;  // if cleared: to 1
    VkAttachmentStoreOp store = VK_ATTACHMENT_STORE_OP_DONT_CARE;
};

// Begins rendering, with viewport and scissor over the whole extent. vkCmdEndRendering ends it.
void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::span<const PassColour> colours,
                const PassDepth& depth);
inline void begin_pass(VkCommandBuffer commands, VkExtent2D extent, std::initializer_list<PassColour> colours,
                       const PassDepth& depth) {
    begin_pass(commands, extent, std::span(colours.begin(), colours.size()), depth);
}

// Copy regions for rectangles of a picture: the same rectangles in a buffer that holds the whole picture row
// by row (width_px wide, four bytes per pixel) and in a colour image.
void rows_in_buffer(std::span<const PixelRect> rects, std::uint32_t width_px,
                    std::vector<VkBufferImageCopy>& regions);

// The interface of both backends, see vulkan_backend.h and cpu_backend.h. Chosen once, when a renderer is
// created. Main thread.

class RenderBackend {
  public:
    RenderBackend() = default;
    virtual ~RenderBackend() = default;
    RenderBackend(const RenderBackend&) = delete;
    RenderBackend& operator=(const RenderBackend&) = delete;

    // Must be called first, once. Errors: the device's.
    virtual Result<void> create() = 0;
    // Creates whatever this target size and the scene's static contents need and do not have yet. The device
    // is idle.
    virtual Result<void> fit(const Scene& scene, VkExtent2D target) = 0;
    // Builds the frame and records its commands. Call after fit() with the same scene and size. The device is
    // idle. Returns false if the frame does not draw the scene, because a screen covers it or it rests.
    virtual Result<bool> draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) = 0;

    [[nodiscard]] virtual FrameContext& frame() = 0;
};

}  // namespace onggi::render
