#include "engine/render/frame/pipelines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "shaders/frame_data.h"
#include "shaders/shaders.h"

namespace onggi::render {
namespace {

constexpr VkShaderStageFlags kBoth = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

constexpr vk::Binding kImage{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT};
constexpr vk::Binding kTexels{VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT};
constexpr vk::Binding kVertexData{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT};

// In the order of the kBind... constants.
constexpr std::array kBindings{
    vk::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, kBoth},
    kImage,
    vk::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kBoth},
    kVertexData,
    kTexels,
    kImage,
    vk::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, kBoth},
    kImage,
    kImage,
    kImage,
    kImage,
    vk::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_VERTEX_BIT},
    vk::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_VERTEX_BIT},
    kVertexData,
    kTexels};
// lavapipe reads what is in a slot whether a shader does or not: where there is nothing, there is no slot.
constexpr std::size_t kBindingsOfLayers = shaders::kBindKeyMap + 1;
static_assert(kBindings.size() == shaders::kBindSlip + 1);

constexpr std::array kMeshAttributes{
    VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Mesh::Vertex, position_mm)},
    VkVertexInputAttributeDescription{1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Mesh::Vertex, normal)},
    VkVertexInputAttributeDescription{2, 0, VK_FORMAT_R32_SFLOAT, offsetof(Mesh::Vertex, open_sky)}};

// Formats that Vulkan does not promise everywhere; every desktop driver we know has them.
Result<void> check_formats(const vk::Device& device) {
    struct Need {
        VkFormat format;
        const char* name;
        VkFormatFeatureFlags features;
    };
    for (const Need& need :
         {Need{kDepthFormat, "D32_SFLOAT",
               VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT}}) {
        VkFormatProperties properties{};
        vkGetPhysicalDeviceFormatProperties(device.physical(), need.format, &properties);
        if ((properties.optimalTilingFeatures & need.features) != need.features) {
            return system_lacks(fmt::format("Vulkan device {}: expected reading of {} images, found none",
                                            device.description().name, need.name));
        }
    }
    return {};
}

// Makes pipelines until one fails; the first failure is kept.
class Maker {
  public:
    explicit Maker(const vk::Device& device) : device_(device) {}

    // Where there is none yet.
    void make(vk::Pipeline& into, const vk::PipelineDesc& desc) {
        if (!error_ || into.get() != VK_NULL_HANDLE) return;
        auto made = vk::create_pipeline(device_, desc);
        if (made) {
            into = std::move(*made);
        } else {
            error_ = made.error();
        }
    }
    [[nodiscard]] Result<void> outcome() const { return error_; }

  private:
    const vk::Device& device_;
    Result<void> error_;
};

Result<void> create_samplers(const vk::Device& device, Pipelines& pipelines) {
    struct Wish {
        vk::Sampler& into;
        vk::SamplerDesc desc;
        const char* name;
    };
    for (const Wish& wish :
         {Wish{pipelines.clamped, {}, "clamped"},
          Wish{pipelines.repeated,
               {.address_u = VK_SAMPLER_ADDRESS_MODE_REPEAT, .address_v = VK_SAMPLER_ADDRESS_MODE_REPEAT},
               "repeated"},
          Wish{pipelines.exact, {.filter = VK_FILTER_NEAREST}, "exact"},
          Wish{pipelines.compared,
               {.filter = VK_FILTER_NEAREST,
               .address_u = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER,
               .address_v = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER,
               .compares = true},
               "compared"}}) {
        auto sampler = vk::create_sampler(device, wish.desc, wish.name);
        if (!sampler) return sampler.error();
        wish.into = std::move(*sampler);
    }
    return {};
}

// From the one that puts a plate on a mesh.
void make_glide_pipelines(Maker& maker, const vk::PipelineDesc& plate_surface,
                          std::span<const VkFormat> picture_formats, std::uint32_t transfer,
                          Pipelines& pipelines) {
    for (std::size_t need = 0; need < pipelines.glide.size(); ++need) {
        const std::array constants{transfer, need == kGlideAlone ? 0U : 1U, need == kGlideDimmed ? 1U : 0U};
        vk::PipelineDesc surface = plate_surface;
        surface.name = "plates on the still life, moving";
        surface.vertex_spirv = shaders::kGlideSurfaceVert;
        surface.fragment_spirv = shaders::kGlideSurfaceFrag;
        surface.constants = constants;
        surface.colour_formats = picture_formats;
        maker.make(pipelines.glide_surface[need], surface);
        vk::PipelineDesc relief = surface;
        relief.name = "plates on their relief, moving";
        relief.vertex_spirv = shaders::kGlideVert;
        relief.fragment_spirv = shaders::kGlideFrag;
        relief.attributes = std::span(kMeshAttributes).first(1);
        relief.vertex_stride = sizeof(vec3);
        relief.cull = VK_CULL_MODE_NONE;
        maker.make(pipelines.glide[need], relief);
    }
}

// The clay; not where the processor draws it. From one that draws into the picture.
void make_lathe_pipelines(Maker& maker, const RendererDesc& desc, bool needs_section,
                          const vk::PipelineDesc& into_picture, Pipelines& pipelines) {
    const auto transfer = static_cast<std::uint32_t>(desc.transfer);
    const auto slip_across = static_cast<std::uint32_t>(desc.slip_across);
    const auto slip_up = static_cast<std::uint32_t>(desc.slip_up);
    constexpr std::uint32_t kNoSphereIsNear = 0;
    constexpr std::uint32_t kOneMayBe = 1;
    const std::array plain_constants{transfer, kNoSphereIsNear, slip_across, slip_up};
    const std::array constants{transfer, kOneMayBe, slip_across, slip_up};

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
    if (needs_section) maker.make(pipelines.lathe_section, section);
}

// What not every scene shows.
struct Needs {
    bool own_colours = false;  // of the still life: there is no plate
    bool section = false;
};

Needs needs_of(const RendererDesc& desc, const Scene& scene) {
    return {.own_colours = scene.plate == nullptr,
            .section = !desc.cached && scene.lathe && scene.lathe->cut};
}

// Those that every scene may show, and those that are needed, where they are not there yet.
Result<void> make_pipelines(const vk::Device& device, const RendererDesc& desc, const Needs& needs,
                            Pipelines& pipelines) {
    const auto transfer = static_cast<std::uint32_t>(desc.transfer);
    const std::array constants{transfer};
    const std::array picture_formats{desc.colour_format};
    const std::array layer_formats{desc.colour_format, desc.colour_format, kPackedFormat};
    const std::array place_formats{desc.colour_format, kPackedFormat};
    const std::array mask_formats{kMaskFormat};
    const std::span<const VkFormat> still_formats =
        desc.cached ? std::span<const VkFormat>(layer_formats) : std::span<const VkFormat>(picture_formats);
    const auto samples = static_cast<VkSampleCountFlagBits>(desc.samples);

    vk::PipelineDesc screen{
        .name = "backdrop",
        .vertex_spirv = shaders::kScreenVert,
        .fragment_spirv = desc.cached ? shaders::kBackdropLayersFrag : shaders::kBackdropFrag,
        .constants = constants,
        .layout = pipelines.layout.get(),
        .colour_formats = still_formats,
        .depth_format = kDepthFormat,
        .samples = samples,
        .depth_test = true,
        .cull = VK_CULL_MODE_NONE};
    vk::PipelineDesc mesh{.name = "still life",
                          .vertex_spirv = shaders::kMeshVert,
                          .fragment_spirv = desc.cached ? shaders::kMeshLayersFrag : shaders::kMeshFrag,
                          .constants = constants,
                          .layout = pipelines.layout.get(),
                          .attributes = kMeshAttributes,
                          .vertex_stride = sizeof(Mesh::Vertex),
                          .colour_formats = still_formats,
                          .depth_format = kDepthFormat,
                          .samples = samples,
                          .depth_test = true,
                          .depth_write = true};
    Maker maker(device);
    if (needs.own_colours) {
        maker.make(pipelines.backdrop, screen);
        maker.make(pipelines.still, mesh);
        vk::PipelineDesc key_map = mesh;
        key_map.name = "still life's shadow map";
        key_map.vertex_spirv = shaders::kKeyMapVert;
        key_map.fragment_spirv = {};
        key_map.constants = {};
        key_map.attributes = std::span(kMeshAttributes).first(1);
        key_map.colour_formats = {};
        key_map.samples = VK_SAMPLE_COUNT_1_BIT;
        key_map.depth_bias = true;
        key_map.cull = VK_CULL_MODE_NONE;
        maker.make(pipelines.key_map, key_map);
    }
    vk::PipelineDesc plate_surface = mesh;
    plate_surface.vertex_spirv = shaders::kPlateSurfaceVert;
    plate_surface.attributes = std::span(kMeshAttributes).first(2);
    if (desc.cached) {
        // The photographs are laid by the processor, and what moves is drawn by it.
        vk::PipelineDesc places = plate_surface;
        places.name = "places of the still life";
        places.fragment_spirv = shaders::kPlacesFrag;
        places.constants = {};
        places.colour_formats = place_formats;
        maker.make(pipelines.places, places);
        return maker.outcome();
    }
    vk::PipelineDesc plate = screen;
    plate.name = "plate";
    plate.fragment_spirv = shaders::kPlateFrag;
    maker.make(pipelines.plate, plate);
    plate_surface.name = "plate on the still life";
    plate_surface.fragment_spirv = shaders::kPlateSurfaceFrag;
    maker.make(pipelines.plate_surface, plate_surface);
    make_glide_pipelines(maker, plate_surface, picture_formats, transfer, pipelines);
    make_lathe_pipelines(maker, desc, needs.section, mesh, pipelines);

    vk::PipelineDesc mask = screen;
    mask.name = "shadow mask";
    mask.fragment_spirv = shaders::kMaskFrag;
    mask.constants = {};
    mask.colour_formats = mask_formats;
    mask.depth_format = VK_FORMAT_UNDEFINED;
    mask.samples = VK_SAMPLE_COUNT_1_BIT;
    mask.depth_test = false;
    maker.make(pipelines.mask, mask);
    return maker.outcome();
}

}  // namespace

Result<Pipelines> create_pipelines(const vk::Device& device, const RendererDesc& desc) {
    if (auto formats = check_formats(device); !formats) return formats.error();
    Pipelines pipelines;
    const std::span<const vk::Binding> bindings(kBindings);
    auto set = vk::create_set(device, desc.cached ? bindings.first(kBindingsOfLayers) : bindings, "scene");
    if (!set) return set.error();
    pipelines.set = std::move(*set);
    constexpr auto kPushBytes = static_cast<std::uint32_t>(
        std::max({sizeof(shaders::MeshDraw), sizeof(shaders::LatheDraw), sizeof(shaders::MoverDraw)}));
    static_assert(kPushBytes <= 128);  // what every device has
    auto layout = vk::create_pipeline_layout(device, pipelines.set.layout.get(), kPushBytes, "scene");
    if (!layout) return layout.error();
    pipelines.layout = std::move(*layout);
    if (auto samplers = create_samplers(device, pipelines); !samplers) return samplers.error();
    if (auto made = make_pipelines(device, desc, {}, pipelines); !made) return made.error();
    return pipelines;
}

Result<void> fit_pipelines(const vk::Device& device, const RendererDesc& desc, const Scene& scene,
                           Pipelines& pipelines) {
    const Needs needs = needs_of(desc, scene);
    const auto is_missing = [](bool is_needed, const vk::Pipeline& pipeline) {
        return is_needed && pipeline.get() == VK_NULL_HANDLE;
    };
    if (!is_missing(needs.own_colours, pipelines.still) &&
        !is_missing(needs.section, pipelines.lathe_section)) {
        return {};
    }
    return make_pipelines(device, desc, needs, pipelines);
}

}  // namespace onggi::render
