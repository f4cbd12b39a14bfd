#include "engine/vk/swapchain.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "engine/vk/check.h"

namespace onggi::vk {
namespace {

// If the driver reports when an image is on the screen, the display paces the frames and every image is shown
// (FIFO). Otherwise the caller paces them, and a mailbox, where the newest image replaces a waiting one,
// never blocks. A software device copies its picture to the screen immediately, so the mode only determines
// the number of images: Mesa keeps five for mailbox and three for immediate
// (findings/mesa-keeps-five-images-for-mailbox-and-three-for-the-rest.sh).
VkPresentModeKHR best_of(std::span<const VkPresentModeKHR> modes, const Device& device) {
    const auto has = [&](VkPresentModeKHR mode) {
        return std::find(modes.begin(), modes.end(), mode) != modes.end();
    };
    if (device.wait_for_present() != nullptr) return VK_PRESENT_MODE_FIFO_KHR;
    if (device.is_cpu() && has(VK_PRESENT_MODE_IMMEDIATE_KHR)) return VK_PRESENT_MODE_IMMEDIATE_KHR;
    return has(VK_PRESENT_MODE_MAILBOX_KHR) ? VK_PRESENT_MODE_MAILBOX_KHR : VK_PRESENT_MODE_FIFO_KHR;
}

}  // namespace

Result<std::unique_ptr<Swapchain>> Swapchain::create(const Device& device, const Surface& surface,
                                                     VkExtent2D extent) {
    std::unique_ptr<Swapchain> self(new Swapchain(device, surface));
    self->wanted_ = extent;
    if (auto chosen = self->choose_format(); !chosen) return chosen.error();
    auto acquired = create_semaphore(device, "image acquired");
    if (!acquired) return acquired.error();
    self->acquired_ = std::move(*acquired);
    auto timeline = Timeline::create(device, "window frames");
    if (!timeline) return timeline.error();
    self->timeline_ = std::move(*timeline);
    if (auto built = self->rebuild(); !built) return built.error();
    return self;
}

Swapchain::~Swapchain() {
    vkDeviceWaitIdle(device_->handle());
    drop_frames();
    if (swapchain_ != VK_NULL_HANDLE) vkDestroySwapchainKHR(device_->handle(), swapchain_, nullptr);
}

void Swapchain::resize(VkExtent2D extent) {
    if (extent.width == wanted_.width && extent.height == wanted_.height) return;
    wanted_ = extent;
    is_current_ = false;
}

Result<void> Swapchain::choose_format() {
    std::uint32_t count = 0;
    ONGGI_VK_TRY_ON(*device_,
                    vkGetPhysicalDeviceSurfaceFormatsKHR(device_->physical(), surface_, &count, nullptr));
    std::vector<VkSurfaceFormatKHR> formats(count);
    ONGGI_VK_TRY_ON(*device_, vkGetPhysicalDeviceSurfaceFormatsKHR(device_->physical(), surface_, &count,
                                                                   formats.data()));
    // Plain UNORM: the shader encodes.
    for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM}) {
        for (const VkSurfaceFormatKHR& format : formats) {
            if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) {
                format_ = format;
                return {};
            }
        }
    }
    return system_lacks("window: expected a surface with an 8-bit UNORM format, found none");
}

VkExtent2D Swapchain::wanted_extent(const VkSurfaceCapabilitiesKHR& can) const {
    VkExtent2D extent = can.currentExtent;
    if (extent.width ==
        std::numeric_limits<std::uint32_t>::max()) {  // the surface takes the swapchain's size
        extent.width = std::clamp(wanted_.width, can.minImageExtent.width, can.maxImageExtent.width);
        extent.height = std::clamp(wanted_.height, can.minImageExtent.height, can.maxImageExtent.height);
    }
    return extent;
}

Result<bool> Swapchain::is_of_another_size() const {
    VkSurfaceCapabilitiesKHR can{};
    ONGGI_VK_TRY_ON(*device_, vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_->physical(), surface_, &can));
    const VkExtent2D wanted = wanted_extent(can);
    return wanted.width != extent_.width || wanted.height != extent_.height;
}

Result<bool> Swapchain::rebuild() {
    ONGGI_VK_TRY_ON(*device_, vkDeviceWaitIdle(device_->handle()));
    VkSurfaceCapabilitiesKHR can{};
    ONGGI_VK_TRY_ON(*device_, vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_->physical(), surface_, &can));
    const VkExtent2D extent = wanted_extent(can);
    const bool has_no_pixels =
        extent.width == 0 || extent.height == 0 || wanted_.width == 0 || wanted_.height == 0;
    if (has_no_pixels) return false;

    std::uint32_t mode_count = 0;
    ONGGI_VK_TRY_ON(*device_, vkGetPhysicalDeviceSurfacePresentModesKHR(device_->physical(), surface_,
                                                                        &mode_count, nullptr));
    std::vector<VkPresentModeKHR> modes(mode_count);
    ONGGI_VK_TRY_ON(*device_, vkGetPhysicalDeviceSurfacePresentModesKHR(device_->physical(), surface_,
                                                                        &mode_count, modes.data()));
    const VkPresentModeKHR mode = best_of(modes, *device_);
    // In a FIFO without feedback, a third image would add a frame of latency between finger and picture.
    const bool may_queue = mode == VK_PRESENT_MODE_FIFO_KHR && device_->wait_for_present() == nullptr;
    std::uint32_t image_count = std::max(can.minImageCount, may_queue ? 2U : 3U);
    if (can.maxImageCount > 0) image_count = std::min(image_count, can.maxImageCount);

    // The compositor rotates the images of a rotated display, at some cost; our pictures stay upright.
    const bool is_turned_for_us = (can.supportedTransforms & VK_SURFACE_TRANSFORM_IDENTITY_BIT_KHR) != 0;
    const bool can_be_opaque = (can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0;
    const VkSwapchainCreateInfoKHR info{
        .sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
        .surface = surface_,
        .minImageCount = image_count,
        .imageFormat = format_.format,
        .imageColorSpace = format_.colorSpace,
        .imageExtent = extent,
        .imageArrayLayers = 1,
        // Pictures are also copied in; every known surface supports that.
        .imageUsage =
            VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | (can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT),
        .imageSharingMode = VK_SHARING_MODE_EXCLUSIVE,
        .preTransform = is_turned_for_us ? VK_SURFACE_TRANSFORM_IDENTITY_BIT_KHR : can.currentTransform,
        .compositeAlpha =
            can_be_opaque ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR,
        .presentMode = mode,
        // An image must keep its contents until it comes back, even where another window hides it.
        .clipped = VK_FALSE,
        .oldSwapchain = swapchain_};
    VkSwapchainKHR fresh = VK_NULL_HANDLE;
    ONGGI_VK_TRY_ON(*device_, vkCreateSwapchainKHR(device_->handle(), &info, nullptr, &fresh));
    drop_frames();
    if (swapchain_ != VK_NULL_HANDLE) vkDestroySwapchainKHR(device_->handle(), swapchain_, nullptr);
    swapchain_ = fresh;
    presented_ = shown_ = 0;
    extent_ = extent;
    device_->name(VK_OBJECT_TYPE_SWAPCHAIN_KHR, swapchain_, "window");
    if (auto made = make_frames(); !made) return made.error();
    is_current_ = true;
    return true;
}

Result<void> Swapchain::make_frames() {
    std::uint32_t count = 0;
    ONGGI_VK_TRY_ON(*device_, vkGetSwapchainImagesKHR(device_->handle(), swapchain_, &count, nullptr));
    std::vector<VkImage> images(count);
    ONGGI_VK_TRY_ON(*device_, vkGetSwapchainImagesKHR(device_->handle(), swapchain_, &count, images.data()));
    for (VkImage image : images) {
        Frame frame;
        frame.image = image;
        const VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                         .image = image,
                                         .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                         .format = format_.format,
                                         .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
        VkImageView view = VK_NULL_HANDLE;
        ONGGI_VK_TRY_ON(*device_, vkCreateImageView(device_->handle(), &info, nullptr, &view));
        frame.view = {device_->handle(), view};
        const std::string name = fmt::format("window image {}", frames_.size());
        device_->name(VK_OBJECT_TYPE_IMAGE, image, name);
        device_->name(VK_OBJECT_TYPE_IMAGE_VIEW, view, name);
        auto drawn = create_semaphore(*device_, "image drawn");
        if (!drawn) return drawn.error();
        frame.drawn = std::move(*drawn);
        frames_.push_back(std::move(frame));
    }
    return {};
}

void Swapchain::drop_frames() {
    frames_.clear();
}

Result<std::optional<TargetImage>> Swapchain::begin() {
    if (auto waited = wait(); !waited) return waited.error();
    if (!is_current_) {
        auto rebuilt = rebuild();
        if (!rebuilt) return rebuilt.error();
        if (!*rebuilt) return std::optional<TargetImage>();
    }
    // A screen that is off may block the acquisition, and the program has other work.
    constexpr std::uint64_t kPatienceNs = 100'000'000;
    Health& health = device_->health();
    VkResult result = health.before("vkAcquireNextImageKHR");
    if (result == VK_SUCCESS) {
        result = vkAcquireNextImageKHR(device_->handle(), swapchain_, kPatienceNs, acquired_.get(),
                                       VK_NULL_HANDLE, &frame_);
    }
    // Some drivers return VK_NOT_READY only after the timeout.
    if (result == VK_TIMEOUT || result == VK_NOT_READY) return std::optional<TargetImage>();
    health.note(result);
    const auto acquired = check_swapchain(result, "vkAcquireNextImageKHR");
    if (!acquired) return acquired.error();
    if (*acquired == SwapchainState::kOutOfDate) {
        is_current_ = false;
        return std::optional<TargetImage>();
    }
    return std::optional(TargetImage{.image = frames_[frame_].image,
                                     .view = frames_[frame_].view.get(),
                                     .extent = extent_,
                                     .final_layout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
                                     .frames_before = frames_[frame_].begun++});
}

Result<void> Swapchain::end(VkCommandBuffer commands, std::span<const VkRect2D> /*changed*/) {
    const VkSemaphore drawn = frames_[frame_].drawn.get();
    if (auto submitted = timeline_.submit(*device_, commands, acquired_.get(), drawn); !submitted)
        return submitted;
    VkPresentInfoKHR info{.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR,
                          .waitSemaphoreCount = 1,
                          .pWaitSemaphores = &drawn,
                          .swapchainCount = 1,
                          .pSwapchains = &swapchain_,
                          .pImageIndices = &frame_};
    const std::uint64_t number = presented_ + 1;
    const VkPresentIdKHR id{
        .sType = VK_STRUCTURE_TYPE_PRESENT_ID_KHR, .swapchainCount = 1, .pPresentIds = &number};
    if (device_->wait_for_present() != nullptr) info.pNext = &id;
    Health& health = device_->health();
    VkResult result = health.before("vkQueuePresentKHR");
    if (result == VK_SUCCESS) result = vkQueuePresentKHR(device_->queue(), &info);
    health.note(result);
    const auto presented = check_swapchain(result, "vkQueuePresentKHR");
    if (!presented) return presented.error();
    if (*presented == SwapchainState::kOutOfDate)
        is_current_ = false;
    else
        presented_ = number;
    if (result != VK_SUBOPTIMAL_KHR) return {};
    // Keep a swapchain of the right size: a new one would be suboptimal too, as always on a rotated display.
    const auto is_another = is_of_another_size();
    if (!is_another) return is_another.error();
    is_current_ = !*is_another;
    return {};
}

Result<bool> Swapchain::wait_until_shown(std::uint64_t most_ns) {
    Health& health = device_->health();
    VkResult result = health.before("vkWaitForPresentKHR");
    if (result == VK_SUCCESS)
        result = device_->wait_for_present()(device_->handle(), swapchain_, presented_, most_ns);
    if (result == VK_TIMEOUT) return false;
    health.note(result);
    const auto waited = check_swapchain(result, "vkWaitForPresentKHR");
    if (!waited) return waited.error();
    shown_ = presented_;
    if (*waited == SwapchainState::kGood) return true;
    is_current_ = false;
    return false;
}

}  // namespace onggi::vk
