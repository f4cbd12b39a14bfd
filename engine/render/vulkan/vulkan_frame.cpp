#include "engine/render/vulkan/vulkan_frame.h"

#include <array>
#include <initializer_list>
#include <span>
#include <utility>

#include "engine/render/frame/pipelines.h"
#include "shaders/frame_data.h"
#include "shaders/shaders.h"

namespace onggi::render {
namespace {

struct ImageRequest {
    vk::Image& into;
    vk::ImageDesc desc;
};

Result<void> create_all(const vk::Device& device, std::initializer_list<ImageRequest> requests) {
    for (const ImageRequest& request : requests) {
        auto image = vk::Image::create(device, request.desc);
        if (!image) return image.error();
        request.into = std::move(*image);
    }
    return {};
}

}  // namespace

Result<void> create_fixed_images(const vk::Device& device, const RendererDesc& desc, VulkanImages& images) {
    constexpr VkImageUsageFlags kRead = VK_IMAGE_USAGE_SAMPLED_BIT;
    return create_all(device, {{images.detail,
                                {.name = "streaks",
                                 .format = VK_FORMAT_R8G8B8A8_UNORM,
                                 .extent = {static_cast<std::uint32_t>(desc.streaks_across),
                                            static_cast<std::uint32_t>(desc.streaks_up)},
                                 .usage = kRead | VK_IMAGE_USAGE_TRANSFER_DST_BIT}},
                               {images.mask,
                                {.name = "shadow mask",
                                 .format = kMaskFormat,
                                 .extent = {shaders::kMaskTexels, shaders::kMaskTexels},
                                 .usage = kRead | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT}}});
}

Result<void> create_sized_images(const vk::Device& device, const RendererDesc& desc, VkExtent2D extent,
                                 VulkanImages& images) {
    const auto samples = static_cast<VkSampleCountFlagBits>(desc.samples);
    auto made = create_all(device, {{images.depth,
                                     {.name = "depth",
                                      .format = kDepthFormat,
                                      .extent = extent,
                                      .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                      .samples = samples,
                                      .aspect = VK_IMAGE_ASPECT_DEPTH_BIT}}});
    if (made && desc.samples > 1) {
        made = create_all(device, {{images.multisampled,
                                    {.name = "picture, several samples a pixel",
                                     .format = desc.colour_format,
                                     .extent = extent,
                                     .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                                     .samples = samples}}});
    }
    if (!made || desc.scale == 1.0F) return made;
    return create_all(device,
                      {{images.smaller,
                        {.name = "picture, smaller than its target",
                         .format = desc.colour_format,
                         .extent = extent,
                         .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}}});
}

namespace {

Result<void> create_samplers(const vk::Device& device, VulkanPipelines& pipelines) {
    struct SamplerRequest {
        vk::Sampler& into;
        vk::SamplerDesc desc;
        const char* name;
    };
    for (const SamplerRequest& request : {SamplerRequest{pipelines.clamped, {}, "clamped"},
                                          SamplerRequest{pipelines.repeated,
                                                         {.address_u = VK_SAMPLER_ADDRESS_MODE_REPEAT,
                                                         .address_v = VK_SAMPLER_ADDRESS_MODE_REPEAT},
                                                         "repeated"}}) {
        auto sampler = vk::create_sampler(device, request.desc, request.name);
        if (!sampler) return sampler.error();
        request.into = std::move(*sampler);
    }
    return {};
}

// The lathe's pipelines, derived from one that draws into the picture.
void make_lathe_pipelines(PipelineMaker& maker, const RendererDesc& desc,
                          const vk::PipelineDesc& into_picture, VulkanPipelines& pipelines) {
    constexpr std::uint32_t kNoSphereIsNear = 0;
    constexpr std::uint32_t kOneMayBe = 1;
    const std::array plain_constants{kNoSphereIsNear};
    const std::array constants{kOneMayBe};

    vk::PipelineDesc lathe = into_picture;
    lathe.name = "lathe";
    lathe.vertex_spirv = shaders::kLatheVert;
    lathe.fragment_spirv = shaders::kLatheFrag;
    lathe.attributes = {};
    lathe.vertex_stride = 0;
    lathe.constants = constants;
    if (desc.inside_out) lathe.cull = VK_CULL_MODE_FRONT_BIT;
    maker.make(pipelines.lathe_near_spheres, lathe);
    vk::PipelineDesc plain = lathe;
    plain.constants = plain_constants;
    maker.make(pipelines.lathe, plain);

    vk::PipelineDesc load = lathe;
    load.name = "lathe with its load";
    load.vertex_spirv = shaders::kLatheLoadVert;
    load.fragment_spirv = shaders::kLatheLoadFrag;
    maker.make(pipelines.lathe_load, load);

    vk::PipelineDesc section = lathe;
    section.name = "section of the lathe";
    section.vertex_spirv = shaders::kLatheSectionVert;
    section.fragment_spirv = shaders::kLatheSectionFrag;
    section.cull = VK_CULL_MODE_NONE;
    maker.make(pipelines.lathe_section, section);

    vk::PipelineDesc marks = lathe;
    marks.name = "lathe with marks";
    marks.fragment_spirv = shaders::kLatheMarksFrag;
    maker.make(pipelines.lathe_marks, marks);
}

// Creates missing pipelines: those that any scene may need, and on request those for the still life's own
// colours. Pipelines for cuts and marks are created up front, because both begin in the middle of a visit,
// when there is no time to compile.
Result<void> make_pipelines(const FrameContext& frame, bool needs_own_colours, VulkanPipelines& pipelines) {
    const RendererDesc& desc = frame.desc;
    const std::array picture_formats{desc.colour_format};
    const std::array mask_formats{kMaskFormat};
    const auto into_picture = [&](vk::PipelineDesc made) {
        made.colour_formats = picture_formats;
        return made;
    };
    PipelineMaker maker(frame.device);
    const vk::PipelineDesc still = into_picture(mesh_pipeline(frame, "still life", shaders::kMeshFrag));
    if (needs_own_colours) {
        maker.make(pipelines.backdrop,
                   into_picture(screen_pipeline(frame, "backdrop", shaders::kBackdropFrag)));
        maker.make(pipelines.still, still);
    }
    maker.make(pipelines.background,
               into_picture(screen_pipeline(frame, "background", shaders::kBackgroundFrag)));
    vk::PipelineDesc background_surface =
        into_picture(mesh_pipeline(frame, "background on the still life", shaders::kBackgroundSurfaceFrag));
    background_surface.vertex_spirv = shaders::kBackgroundSurfaceVert;
    background_surface.attributes = std::span(kMeshAttributes).first(2);
    maker.make(pipelines.background_surface, background_surface);
    vk::PipelineDesc fade = into_picture(screen_pipeline(frame, "view fade", shaders::kViewFadeFrag));
    fade.depth_test = false;
    fade.blend = true;
    maker.make(pipelines.view_fade, fade);
    make_lathe_pipelines(maker, desc, still, pipelines);

    vk::PipelineDesc mask = screen_pipeline(frame, "shadow mask", shaders::kMaskFrag);
    mask.colour_formats = mask_formats;
    mask.depth_format = VK_FORMAT_UNDEFINED;
    mask.samples = VK_SAMPLE_COUNT_1_BIT;
    mask.depth_test = false;
    maker.make(pipelines.mask, mask);
    return maker.outcome();
}

}  // namespace

Result<void> create_pipelines(const FrameContext& frame, VulkanPipelines& pipelines) {
    if (auto samplers = create_samplers(frame.device, pipelines); !samplers) return samplers;
    return make_pipelines(frame, false, pipelines);
}

Result<void> fit_pipelines(const FrameContext& frame, const Scene& scene, VulkanPipelines& pipelines) {
    const bool needs_own_colours = scene.background == nullptr;
    if (!needs_own_colours || pipelines.still.get() != VK_NULL_HANDLE) return {};
    return make_pipelines(frame, true, pipelines);
}

}  // namespace onggi::render
