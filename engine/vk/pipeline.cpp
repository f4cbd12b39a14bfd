#include "engine/vk/pipeline.h"

#include <array>

#include "engine/vk/check.h"

namespace onggi::vk {
namespace {

using ShaderModule = Unique<VkShaderModule, vkDestroyShaderModule>;

Result<ShaderModule> create_module(const Device& device, std::span<const std::uint32_t> spirv) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = spirv.size_bytes();
    info.pCode = spirv.data();
    VkShaderModule module = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateShaderModule(device.handle(), &info, nullptr, &module));
    return ShaderModule(device.handle(), module);
}

VkPipelineShaderStageCreateInfo stage_info(VkShaderStageFlagBits stage, VkShaderModule module,
                                           const VkSpecializationInfo& constants) {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    info.pSpecializationInfo = &constants;
    return info;
}

}  // namespace

Result<Pipeline> create_pipeline(const Device& device, const PipelineDesc& desc) {
    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t id = 0; id < desc.constants.size(); ++id)
        entries.push_back(
            {id, id * static_cast<std::uint32_t>(sizeof(std::uint32_t)), sizeof(std::uint32_t)});
    const VkSpecializationInfo constants{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         desc.constants.size_bytes(), desc.constants.data()};

    auto vertex = create_module(device, device.in_place_of(desc.vertex_spirv));
    if (!vertex) return vertex.error();
    std::vector<VkPipelineShaderStageCreateInfo> stages{
        stage_info(VK_SHADER_STAGE_VERTEX_BIT, vertex->get(), constants)};
    ShaderModule fragment_module;
    if (!desc.fragment_spirv.empty()) {
        auto fragment = create_module(device, device.in_place_of(desc.fragment_spirv));
        if (!fragment) return fragment.error();
        fragment_module = std::move(*fragment);
        stages.push_back(stage_info(VK_SHADER_STAGE_FRAGMENT_BIT, fragment_module.get(), constants));
    }

    const VkVertexInputBindingDescription binding{0, desc.vertex_stride, VK_VERTEX_INPUT_RATE_VERTEX};
    VkPipelineVertexInputStateCreateInfo vertex_input{};
    vertex_input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    if (desc.vertex_stride > 0) {
        vertex_input.vertexBindingDescriptionCount = 1;
        vertex_input.pVertexBindingDescriptions = &binding;
        vertex_input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(desc.attributes.size());
        vertex_input.pVertexAttributeDescriptions = desc.attributes.data();
    }
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster{};
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.polygonMode = VK_POLYGON_MODE_FILL;
    raster.cullMode = desc.cull;
    raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    raster.depthBiasEnable = desc.depth_bias ? VK_TRUE : VK_FALSE;
    raster.depthBiasConstantFactor = desc.depth_bias ? 2.0F : 0.0F;
    raster.depthBiasSlopeFactor = desc.depth_bias ? 2.5F : 0.0F;
    raster.lineWidth = 1.0F;
    VkPipelineMultisampleStateCreateInfo multisample{};
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = desc.samples;
    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = desc.depth_test ? VK_TRUE : VK_FALSE;
    depth.depthWriteEnable = desc.depth_write ? VK_TRUE : VK_FALSE;
    depth.depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkPipelineColorBlendAttachmentState opaque{};
    opaque.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                            VK_COLOR_COMPONENT_A_BIT;
    if (desc.blend) {
        opaque.blendEnable = VK_TRUE;
        opaque.srcColorBlendFactor = opaque.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
        opaque.dstColorBlendFactor = opaque.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        opaque.colorBlendOp = opaque.alphaBlendOp = VK_BLEND_OP_ADD;
    }
    const std::vector<VkPipelineColorBlendAttachmentState> attachments(desc.colour_formats.size(), opaque);
    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = static_cast<std::uint32_t>(attachments.size());
    blend.pAttachments = attachments.data();
    constexpr std::array kDynamic{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(kDynamic.size());
    dynamic.pDynamicStates = kDynamic.data();

    VkPipelineRenderingCreateInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(desc.colour_formats.size());
    rendering.pColorAttachmentFormats = desc.colour_formats.data();
    rendering.depthAttachmentFormat = desc.depth_format;

    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = &rendering;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &vertex_input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &multisample;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = desc.layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device,
                    vkCreateGraphicsPipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline));
    device.name(VK_OBJECT_TYPE_PIPELINE, pipeline, desc.name);
    return Pipeline(device.handle(), pipeline);
}

Result<PipelineLayout> create_pipeline_layout(const Device& device, VkDescriptorSetLayout set,
                                              std::uint32_t push_constant_bytes, std::string_view name) {
    const VkPushConstantRange range{VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                    push_constant_bytes};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout));
    device.name(VK_OBJECT_TYPE_PIPELINE_LAYOUT, layout, name);
    return PipelineLayout(device.handle(), layout);
}

Result<Sampler> create_sampler(const Device& device, const SamplerDesc& desc, std::string_view name) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = desc.filter;
    info.minFilter = desc.filter;
    info.addressModeU = desc.address_u;
    info.addressModeV = desc.address_v;
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.compareEnable = desc.compares ? VK_TRUE : VK_FALSE;
    info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    info.borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
    VkSampler sampler = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateSampler(device.handle(), &info, nullptr, &sampler));
    device.name(VK_OBJECT_TYPE_SAMPLER, sampler, name);
    return Sampler(device.handle(), sampler);
}

}  // namespace onggi::vk
