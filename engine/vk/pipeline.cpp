#include "engine/vk/pipeline.h"

#include <array>
#include <map>

#include "engine/vk/check.h"

namespace onggi::vk {
namespace {

using ShaderModule = Unique<VkShaderModule, vkDestroyShaderModule>;

Result<ShaderModule> create_module(const Device& device, std::span<const std::uint32_t> spirv) {
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .codeSize = spirv.size_bytes(),
                                        .pCode = spirv.data()};
    VkShaderModule module = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateShaderModule(device.handle(), &info, nullptr, &module));
    return ShaderModule(device.handle(), module);
}

VkPipelineShaderStageCreateInfo stage_info(VkShaderStageFlagBits stage, VkShaderModule module,
                                           const VkSpecializationInfo& constants) {
    return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
            .stage = stage,
            .module = module,
            .pName = "main",
            .pSpecializationInfo = &constants};
}

// The modules may be destroyed once the pipeline exists.
struct Stages {
    ShaderModule vertex;
    ShaderModule fragment;
    std::vector<VkPipelineShaderStageCreateInfo> infos;
};

Result<Stages> create_stages(const Device& device, const PipelineDesc& desc,
                             const VkSpecializationInfo& constants) {
    Stages stages;
    auto vertex = create_module(device, device.in_place_of(desc.vertex_spirv));
    if (!vertex) return vertex.error();
    stages.vertex = std::move(*vertex);
    stages.infos.push_back(stage_info(VK_SHADER_STAGE_VERTEX_BIT, stages.vertex.get(), constants));
    if (!desc.fragment_spirv.empty()) {
        auto fragment = create_module(device, device.in_place_of(desc.fragment_spirv));
        if (!fragment) return fragment.error();
        stages.fragment = std::move(*fragment);
        stages.infos.push_back(stage_info(VK_SHADER_STAGE_FRAGMENT_BIT, stages.fragment.get(), constants));
    }
    return stages;
}

// `desc` and `binding` must outlive the result.
VkPipelineVertexInputStateCreateInfo vertex_input_of(const PipelineDesc& desc,
                                                     const VkVertexInputBindingDescription& binding) {
    VkPipelineVertexInputStateCreateInfo vertex_input{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    if (desc.vertex_stride > 0) {
        vertex_input.vertexBindingDescriptionCount = 1;
        vertex_input.pVertexBindingDescriptions = &binding;
        vertex_input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(desc.attributes.size());
        vertex_input.pVertexAttributeDescriptions = desc.attributes.data();
    }
    return vertex_input;
}

VkPipelineRasterizationStateCreateInfo raster_of(const PipelineDesc& desc) {
    return {.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
            .polygonMode = VK_POLYGON_MODE_FILL,
            .cullMode = desc.cull,
            .frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE,
            .depthBiasEnable = desc.depth_bias ? VK_TRUE : VK_FALSE,
            .depthBiasConstantFactor = desc.depth_bias ? 2.0F : 0.0F,
            .depthBiasSlopeFactor = desc.depth_bias ? 2.5F : 0.0F,
            .lineWidth = 1.0F};
}

// The blend state of every colour attachment.
VkPipelineColorBlendAttachmentState blend_of(const PipelineDesc& desc) {
    VkPipelineColorBlendAttachmentState state{.colorWriteMask =
                                                  VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                                  VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT};
    if (desc.blend) {
        state.blendEnable = VK_TRUE;
        state.srcColorBlendFactor = state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
        state.dstColorBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        state.colorBlendOp = state.alphaBlendOp = VK_BLEND_OP_ADD;
    }
    return state;
}

}  // namespace

Result<Pipeline> create_pipeline(const Device& device, const PipelineDesc& desc) {
    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t id = 0; id < desc.constants.size(); ++id)
        entries.push_back(
            {id, id * static_cast<std::uint32_t>(sizeof(std::uint32_t)), sizeof(std::uint32_t)});
    const VkSpecializationInfo constants{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         desc.constants.size_bytes(), desc.constants.data()};

    const auto stages = create_stages(device, desc, constants);
    if (!stages) return stages.error();

    const VkVertexInputBindingDescription binding{0, desc.vertex_stride, VK_VERTEX_INPUT_RATE_VERTEX};
    const VkPipelineVertexInputStateCreateInfo vertex_input = vertex_input_of(desc, binding);
    const VkPipelineInputAssemblyStateCreateInfo assembly{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo viewport{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo raster = raster_of(desc);
    const VkPipelineMultisampleStateCreateInfo multisample{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = desc.samples};
    const VkPipelineDepthStencilStateCreateInfo depth{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = desc.depth_test ? VK_TRUE : VK_FALSE,
        .depthWriteEnable = desc.depth_write ? VK_TRUE : VK_FALSE,
        .depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL};
    const std::vector<VkPipelineColorBlendAttachmentState> attachments(desc.colour_formats.size(),
                                                                       blend_of(desc));
    const VkPipelineColorBlendStateCreateInfo blend{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = static_cast<std::uint32_t>(attachments.size()),
        .pAttachments = attachments.data()};
    constexpr std::array kDynamic{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = static_cast<std::uint32_t>(kDynamic.size()),
        .pDynamicStates = kDynamic.data()};

    const VkPipelineRenderingCreateInfo rendering{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = static_cast<std::uint32_t>(desc.colour_formats.size()),
        .pColorAttachmentFormats = desc.colour_formats.data(),
        .depthAttachmentFormat = desc.depth_format};

    const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                            .pNext = &rendering,
                                            .stageCount = static_cast<std::uint32_t>(stages->infos.size()),
                                            .pStages = stages->infos.data(),
                                            .pVertexInputState = &vertex_input,
                                            .pInputAssemblyState = &assembly,
                                            .pViewportState = &viewport,
                                            .pRasterizationState = &raster,
                                            .pMultisampleState = &multisample,
                                            .pDepthStencilState = &depth,
                                            .pColorBlendState = &blend,
                                            .pDynamicState = &dynamic,
                                            .layout = desc.layout};
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
    const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                          .setLayoutCount = 1,
                                          .pSetLayouts = &set,
                                          .pushConstantRangeCount = 1,
                                          .pPushConstantRanges = &range};
    VkPipelineLayout layout = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout));
    device.name(VK_OBJECT_TYPE_PIPELINE_LAYOUT, layout, name);
    return PipelineLayout(device.handle(), layout);
}

Result<Sampler> create_sampler(const Device& device, const SamplerDesc& desc, std::string_view name) {
    const VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                   .magFilter = desc.filter,
                                   .minFilter = desc.filter,
                                   .addressModeU = desc.address_u,
                                   .addressModeV = desc.address_v,
                                   .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                   .compareEnable = desc.compares ? VK_TRUE : VK_FALSE,
                                   .compareOp = VK_COMPARE_OP_LESS_OR_EQUAL,
                                   .borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE};
    VkSampler sampler = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateSampler(device.handle(), &info, nullptr, &sampler));
    device.name(VK_OBJECT_TYPE_SAMPLER, sampler, name);
    return Sampler(device.handle(), sampler);
}

namespace {

// The caller fills in pBufferInfo, pImageInfo or pTexelBufferView.
VkWriteDescriptorSet one_write(VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type) {
    return {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
            .dstSet = set,
            .dstBinding = binding,
            .descriptorCount = 1,
            .descriptorType = type};
}

}  // namespace

Result<BoundSet> create_set(const Device& device, std::span<const Binding> bindings, std::string_view name) {
    std::vector<VkDescriptorSetLayoutBinding> layout_bindings;
    std::map<VkDescriptorType, std::uint32_t> counts;
    for (const Binding& binding : bindings) {
        const auto number = static_cast<std::uint32_t>(layout_bindings.size());
        layout_bindings.push_back({number, binding.type, 1, binding.stages, nullptr});
        ++counts[binding.type];
    }
    const VkDescriptorSetLayoutCreateInfo layout_info{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = static_cast<std::uint32_t>(layout_bindings.size()),
        .pBindings = layout_bindings.data()};
    BoundSet result;
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateDescriptorSetLayout(device.handle(), &layout_info, nullptr, &layout));
    result.layout = SetLayout(device.handle(), layout);
    device.name(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, layout, name);

    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts)
        sizes.push_back({type, count});
    const VkDescriptorPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                               .maxSets = 1,
                                               .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                               .pPoolSizes = sizes.data()};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateDescriptorPool(device.handle(), &pool_info, nullptr, &pool));
    result.pool = DescriptorPool(device.handle(), pool);
    device.name(VK_OBJECT_TYPE_DESCRIPTOR_POOL, pool, name);

    const VkDescriptorSetAllocateInfo set_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                               .descriptorPool = pool,
                                               .descriptorSetCount = 1,
                                               .pSetLayouts = &layout};
    ONGGI_VK_TRY_ON(device, vkAllocateDescriptorSets(device.handle(), &set_info, &result.set));
    device.name(VK_OBJECT_TYPE_DESCRIPTOR_SET, result.set, name);
    return result;
}

void write_buffer(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type,
                  VkBuffer buffer) {
    const VkDescriptorBufferInfo info{buffer, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = one_write(set, binding, type);
    write.pBufferInfo = &info;
    vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
}

void write_image(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view,
                 VkSampler sampler) {
    const VkDescriptorImageInfo info{sampler, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write = one_write(set, binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
    write.pImageInfo = &info;
    vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
}

Result<BufferView> create_texels(const Device& device, VkBuffer buffer, VkFormat format,
                                 std::string_view name) {
    const VkBufferViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO,
                                      .buffer = buffer,
                                      .format = format,
                                      .range = VK_WHOLE_SIZE};
    VkBufferView view = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(device, vkCreateBufferView(device.handle(), &info, nullptr, &view));
    device.name(VK_OBJECT_TYPE_BUFFER_VIEW, view, name);
    return BufferView(device.handle(), view);
}

void write_texels(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkBufferView view) {
    VkWriteDescriptorSet write = one_write(set, binding, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER);
    write.pTexelBufferView = &view;
    vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
}

}  // namespace onggi::vk
