// What every frame of either backend is made with: the device's objects that both need, what the scene
// became, and the commands that are recorded. Main thread. Pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "engine/render/frame/pass.h"
#include "engine/render/frame_stats.h"
#include "engine/render/pass_clock.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/vk/buffer.h"
#include "engine/vk/frame_target.h"
#include "engine/vk/image.h"
#include "engine/vk/pipeline.h"

namespace onggi::render {

struct FrameContext {
    vk::Device& device;
    RendererDesc desc;
    vk::BoundSet scene_set{};
    vk::PipelineLayout layout{};
    // The still life's shadow map and what reads it; the pipeline where a scene has needed it.
    vk::Image shadow_map{};
    vk::Sampler compared{};
    vk::Pipeline shadow_map_pipeline{};
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkExtent2D extent{};  // of the scene's picture
    BuiltFrame built{};
    FrameStats stats{};
    PassClock clock{};
    vk::Buffer uniforms{};
    mutable FrameWork work{};  // counted as it is recorded, by whoever only reads the rest

    // Makes what is here but the shadow map's pipeline, with the first so many bindings of
    // shaders/frame_data.h: a software device reads what is in a slot whether a shader does or not. Errors:
    // the device's, or that it lacks a format.
    Result<void> create(std::size_t bindings);
    // Of that, only what pipelines are made with.
    Result<void> create_layout(std::size_t bindings);
    // The command buffer; end() leaves the target, which is laid out as colour, as whoever shows it wants it.
    Result<void> begin();
    Result<void> end(const vk::TargetImage& target);
    // A part of the frame begins, on the device.
    void enter(const char* part) { clock.enter(device, commands, part); }

    [[nodiscard]] EdgeView view(const Scene& scene) const {
        return {scene.camera, static_cast<int>(extent.width), static_cast<int>(extent.height)};
    }
    // What the scene becomes; the stats begin anew.
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
    // `record` into commands of their own, which are done when this returns.
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
    // One triangle over the whole target.
    void draw_screen(const vk::Pipeline& pipeline) const {
        bind(pipeline);
        vkCmdDraw(commands, 3, 1, 0, 0);
        count_draw(3);
    }
};

}  // namespace onggi::render
