#include "engine/vk/health.h"

namespace onggi::vk {

VkResult Health::before(std::string_view call) {
    if (!fault_) return VK_SUCCESS;
    if (trouble_ == Trouble::kLost) return VK_ERROR_DEVICE_LOST;
    if (call.substr(0, call.find('(')) != fault_->call) return VK_SUCCESS;
    if (fault_->after-- > 0) return VK_SUCCESS;
    const VkResult result = fault_->result;
    // A fault that does not lose the device occurs once.
    if (result != VK_ERROR_DEVICE_LOST) fault_.reset();
    return result;
}

void Health::note(VkResult result) {
    if (trouble_ == Trouble::kLost) return;
    switch (result) {
        case VK_ERROR_DEVICE_LOST:
            trouble_ = Trouble::kLost;
            break;
        case VK_ERROR_OUT_OF_HOST_MEMORY:
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            trouble_ = Trouble::kOutOfMemory;
            break;
        case VK_ERROR_SURFACE_LOST_KHR:
            trouble_ = Trouble::kSurfaceLost;
            break;
        default:
            break;
    }
}

}  // namespace onggi::vk
