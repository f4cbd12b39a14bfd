#include "engine/vk/host_target.h"

#include <bit>
#include <utility>

#include "engine/vk/check.h"

namespace onggi::vk {

Result<std::unique_ptr<HostTarget>> HostTarget::create(const Device& device,
                                                       std::unique_ptr<HostSurface> surface,
                                                       VkExtent2D extent) {
    std::unique_ptr<HostTarget> self(new HostTarget(device, std::move(surface), extent));
    auto timeline = Timeline::create(device, "window frames");
    if (!timeline) return timeline.error();
    self->timeline_ = std::move(*timeline);
    if (auto built = self->rebuild(); !built) return built.error();
    return self;
}

HostTarget::~HostTarget() {
    vkDeviceWaitIdle(device_->handle());
}

void HostTarget::drop() {
    view_ = {};
    image_ = {};
    memory_ = {};
    extent_ = {};
}

Result<void> HostTarget::import(std::span<std::byte> memory, std::uint32_t types) {
    constexpr auto kHost = VK_EXTERNAL_MEMORY_HANDLE_TYPE_HOST_ALLOCATION_BIT_EXT;
    VkMemoryHostPointerPropertiesEXT properties{.sType =
                                                    VK_STRUCTURE_TYPE_MEMORY_HOST_POINTER_PROPERTIES_EXT};
    ONGGI_VK_TRY_ON(*device_,
                    device_->host_pointer_properties()(device_->handle(), kHost, memory.data(), &properties));
    types &= properties.memoryTypeBits;
    if (types == 0) return system_lacks("window: expected a memory type for its picture, found none");
    const VkImportMemoryHostPointerInfoEXT from{
        .sType = VK_STRUCTURE_TYPE_IMPORT_MEMORY_HOST_POINTER_INFO_EXT,
        .handleType = kHost,
        .pHostPointer = memory.data()};
    const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                    .pNext = &from,
                                    .allocationSize = memory.size(),
                                    .memoryTypeIndex = static_cast<std::uint32_t>(std::countr_zero(types))};
    VkDeviceMemory imported = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(*device_, vkAllocateMemory(device_->handle(), &info, nullptr, &imported));
    memory_ = {device_->handle(), imported};
    return {};
}

Result<void> HostTarget::rebuild() {
    drop();
    if (wanted_.width == 0 || wanted_.height == 0) return {};
    const VkExternalMemoryImageCreateInfo external{
        .sType = VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_IMAGE_CREATE_INFO,
        .handleTypes = VK_EXTERNAL_MEMORY_HANDLE_TYPE_HOST_ALLOCATION_BIT_EXT};
    const VkImageCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
        .pNext = &external,
        .imageType = VK_IMAGE_TYPE_2D,
        .format = kFormat,
        .extent = {wanted_.width, wanted_.height, 1},
        .mipLevels = 1,
        .arrayLayers = 1,
        .samples = VK_SAMPLE_COUNT_1_BIT,
        .tiling = VK_IMAGE_TILING_LINEAR,
        .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
        .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
        .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED};
    VkImage image = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(*device_, vkCreateImage(device_->handle(), &info, nullptr, &image));
    image_ = {device_->handle(), image};
    device_->name(VK_OBJECT_TYPE_IMAGE, image, "window's picture");
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device_->handle(), image, &needs);
    const auto lent = surface_->lend(needs.size);
    if (!lent) return lent.error();
    if (auto imported = import(*lent, needs.memoryTypeBits); !imported) return imported;
    ONGGI_VK_TRY_ON(*device_, vkBindImageMemory(device_->handle(), image, memory_.get(), 0));

    constexpr VkImageSubresource kWhole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0};
    VkSubresourceLayout layout{};
    vkGetImageSubresourceLayout(device_->handle(), image, &kWhole, &layout);
    if (layout.offset != 0) return system_lacks("window: expected a picture from its memory's start on");
    constexpr VkDeviceSize kPixelBytes = 4;
    row_px_ = static_cast<std::uint32_t>(layout.rowPitch / kPixelBytes);
    const VkImageViewCreateInfo seen{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                     .image = image,
                                     .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                     .format = kFormat,
                                     .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    VkImageView view = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(*device_, vkCreateImageView(device_->handle(), &seen, nullptr, &view));
    view_ = {device_->handle(), view};
    device_->name(VK_OBJECT_TYPE_IMAGE_VIEW, view, "window's picture");
    extent_ = wanted_;
    frames_begun_ = 0;
    return {};
}

Result<std::optional<TargetImage>> HostTarget::begin() {
    if (auto waited = wait(); !waited) return waited.error();
    if (wanted_.width != extent_.width || wanted_.height != extent_.height) {
        if (auto read = surface_->wait_until_read(); !read) return read.error();
        if (auto rebuilt = rebuild(); !rebuilt) return rebuilt.error();
    }
    if (extent_.width == 0) return std::optional<TargetImage>();
    return std::optional(TargetImage{.image = image_.get(),
                                     .view = view_.get(),
                                     .extent = extent_,
                                     .final_layout = VK_IMAGE_LAYOUT_GENERAL,
                                     .frames_before = frames_begun_++});
}

// The image changes from the submission on, so the window system may read the last picture while this frame
// is prepared.
Result<void> HostTarget::end(VkCommandBuffer commands, std::span<const VkRect2D> changed) {
    if (auto read = surface_->wait_until_read(); !read) return read;
    if (auto submitted = timeline_.submit(*device_, commands, VK_NULL_HANDLE, VK_NULL_HANDLE); !submitted)
        return submitted;
    if (auto waited = wait(); !waited) return waited;
    surface_->show(extent_, row_px_, changed);
    return {};
}

}  // namespace onggi::vk
