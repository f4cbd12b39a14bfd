#include <map>

#include "engine/vk/check.h"
#include "engine/vk/pipeline.h"

namespace onggi::vk {
namespace {

// Of what, its writer adds.
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
