// Graphics pipelines for dynamic rendering, and their shared fixed descriptor set. Main thread.
#pragma once

#include <span>
#include <string_view>
#include <utility>

#include "engine/core/result.h"
#include "engine/vk/device.h"

namespace onggi::vk {

// Owns a handle that is created from a VkDevice and destroyed with it.
template <typename Handle, void (*destroy)(VkDevice, Handle, const VkAllocationCallbacks*)>
class Unique {
  public:
    Unique() = default;
    Unique(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
    ~Unique() {
        if (handle_ != VK_NULL_HANDLE) destroy(device_, handle_, nullptr);
    }
    Unique(Unique&& other) noexcept
        : device_(other.device_),
          handle_(std::exchange(other.handle_, Handle{VK_NULL_HANDLE})) {}
    Unique& operator=(Unique&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    [[nodiscard]] Handle get() const { return handle_; }

  private:
    VkDevice device_ = VK_NULL_HANDLE;
    Handle handle_ = VK_NULL_HANDLE;
};

using Pipeline = Unique<VkPipeline, vkDestroyPipeline>;
using PipelineLayout = Unique<VkPipelineLayout, vkDestroyPipelineLayout>;
using SetLayout = Unique<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using DescriptorPool = Unique<VkDescriptorPool, vkDestroyDescriptorPool>;
using Sampler = Unique<VkSampler, vkDestroySampler>;
using BufferView = Unique<VkBufferView, vkDestroyBufferView>;
using Semaphore = Unique<VkSemaphore, vkDestroySemaphore>;

struct PipelineDesc {
    std::string_view name;
    std::span<const std::uint32_t> vertex_spirv;
    std::span<const std::uint32_t> fragment_spirv;  // empty: depth only
    // 32-bit specialization constants for both stages; the id is the index.
    std::span<const std::uint32_t> constants{};
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::span<const VkVertexInputAttributeDescription> attributes{};  // of binding 0
    std::uint32_t vertex_stride = 0;                                  // bytes; 0: no vertex buffer
    std::span<const VkFormat> colour_formats{};
    VkFormat depth_format = VK_FORMAT_UNDEFINED;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    bool depth_test = false;  // passes if less or equal
    bool depth_write = false;
    bool depth_bias = false;                       // for shadow maps
    bool blend = false;                            // over, with premultiplied alpha
    VkCullModeFlags cull = VK_CULL_MODE_BACK_BIT;  // front faces are counter-clockwise seen from outside
};

// Viewport and scissor are dynamic.
Result<Pipeline> create_pipeline(const Device& device, const PipelineDesc& desc);

struct Binding {
    VkDescriptorType type;
    VkShaderStageFlags stages;
};

// One layout, one pool and one set with these bindings, numbered from 0.
struct BoundSet {
    SetLayout layout;
    DescriptorPool pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
};
Result<BoundSet> create_set(const Device& device, std::span<const Binding> bindings, std::string_view name);

void write_buffer(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type,
                  VkBuffer buffer);
// The shader reads it in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL.
void write_image(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view,
                 VkSampler sampler);

// Creates a view of the whole buffer as texels of this format.
Result<BufferView> create_texels(const Device& device, VkBuffer buffer, VkFormat format,
                                 std::string_view name);
void write_texels(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkBufferView view);

Result<PipelineLayout> create_pipeline_layout(const Device& device, VkDescriptorSetLayout set,
                                              std::uint32_t push_constant_bytes, std::string_view name);

struct SamplerDesc {
    VkFilter filter = VK_FILTER_LINEAR;
    VkSamplerAddressMode address_u = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSamplerAddressMode address_v = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    bool compares = false;  // passes if less or equal; outside the image it passes
};
Result<Sampler> create_sampler(const Device& device, const SamplerDesc& desc, std::string_view name);

}  // namespace onggi::vk
