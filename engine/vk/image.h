// A 2D image with its memory and a view of the whole image, and its layout transitions. Main thread.
#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/vk/memory.h"

namespace onggi::vk {

struct ImageDesc {
    std::string_view name;
    VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
    VkExtent2D extent{};
    VkImageUsageFlags usage = 0;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

class Image {
  public:
    Image() = default;
    // The device must outlive the image. One mip level, optimal tiling, device memory.
    static Result<Image> create(const Device& device, const ImageDesc& desc);
    ~Image() { destroy(); }
    Image(Image&& other) noexcept { swap(other); }
    Image& operator=(Image&& other) noexcept { return swap(other), *this; }

    [[nodiscard]] VkImage handle() const { return image_; }
    [[nodiscard]] VkImageView view() const { return view_; }
    [[nodiscard]] VkExtent2D extent() const { return extent_; }
    [[nodiscard]] VkImageAspectFlags aspect() const { return aspect_; }

  private:
    void destroy();
    void swap(Image& other) noexcept;

    const Device* device_ = nullptr;
    VkImage image_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    VkExtent2D extent_{};
    VkImageAspectFlags aspect_ = 0;
    Allocation allocation_;
};

// One end of a barrier: the stages and accesses that use an image, and its layout.
struct ImageState {
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

// The states that the renderer uses.
namespace state {
constexpr ImageState kUndefined{};
// Discards the contents, after all earlier commands of the queue have finished with the image.
constexpr ImageState kDiscard{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE,
                              VK_IMAGE_LAYOUT_UNDEFINED};
constexpr ImageState kCopySource{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
constexpr ImageState kCopyTarget{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr ImageState kColour{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                             VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                             VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
constexpr ImageState kDepth{
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
constexpr ImageState kSampled{VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
                              VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
constexpr ImageState kPresent{VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};
}  // namespace state

void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageState& from,
             const ImageState& to);
inline void barrier(VkCommandBuffer commands, const Image& image, const ImageState& from,
                    const ImageState& to) {
    barrier(commands, image.handle(), image.aspect(), from, to);
}

// Copies the part of the images inside `area`. `from` is in the copy source layout, `to` in the copy target
// layout.
void copy(VkCommandBuffer commands, VkImage from, VkImage to, VkImageAspectFlags aspect,
          const VkRect2D& area);

}  // namespace onggi::vk
