// Everything the renderer makes once from its description: the set's layout, the samplers, the pipelines.
// Main thread.
#pragma once

#include <array>
#include <cstddef>

#include "engine/core/result.h"
#include "engine/render/renderer_desc.h"
#include "engine/render/scene.h"
#include "engine/vk/pipeline.h"

namespace onggi::render {

constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
constexpr VkFormat kMaskFormat = VK_FORMAT_R8G8_UNORM;
// Two numbers of sixteen bits each, as two bytes each: see shaders/packed.glsl.
constexpr VkFormat kPackedFormat = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkFormat kDetailFormat = VK_FORMAT_R8G8B8A8_UNORM;

// What a glide needs: one plate, two, or two in the evening.
constexpr std::size_t kGlideAlone = 0;
constexpr std::size_t kGlideMixed = 1;
constexpr std::size_t kGlideDimmed = 2;
constexpr std::size_t kGlideNeeds = 3;

struct Pipelines {
    vk::BoundSet set;
    vk::PipelineLayout layout;
    vk::Sampler clamped;
    vk::Sampler repeated;
    vk::Sampler exact;
    vk::Sampler compared;
    vk::Pipeline
        backdrop;         // into layers when cached, else into the picture; this and the next without a plate
    vk::Pipeline still;   // likewise
    vk::Pipeline places;  // cached, of a photographed room
    vk::Pipeline plate;   // not cached: instead of the backdrop, and of the still life's colours
    vk::Pipeline plate_surface;
    // Instead of these two while the camera moves, by what it needs; never into layers.
    std::array<vk::Pipeline, kGlideNeeds> glide;
    std::array<vk::Pipeline, kGlideNeeds> glide_surface;
    vk::Pipeline key_map;  // of a room in its own colours
    vk::Pipeline mask;     // not cached
    // None of the lathe's when cached: then the processor draws it.
    vk::Pipeline lathe;               // where no moving sphere's shadow falls
    vk::Pipeline lathe_near_spheres;  // where one may
    vk::Pipeline lathe_load;          // the same with its load shown
    vk::Pipeline lathe_section;       // the faces of a cut, where there is one
};

// All but those that not every scene needs: a pipeline takes 2 MB of a software driver's memory.
Result<Pipelines> create_pipelines(const vk::Device& device, const RendererDesc& desc);
// Those that this scene needs besides, once.
Result<void> fit_pipelines(const vk::Device& device, const RendererDesc& desc, const Scene& scene,
                           Pipelines& pipelines);

}  // namespace onggi::render
