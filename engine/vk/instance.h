// The Vulkan instance, with an optional validation layer and its messages. Main thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

struct InstanceDesc {
    // VK_LAYER_KHRONOS_validation with synchronization validation. System lacks: it is not installed.
    bool validation = false;
    std::vector<std::string> extensions{};  // required by the window
};

class Instance {
  public:
    static Result<std::unique_ptr<Instance>> create(const InstanceDesc& desc);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    [[nodiscard]] VkInstance handle() const { return instance_; }
    [[nodiscard]] bool names_objects() const { return has_debug_utils_; }
    // Warnings and errors so far, oldest first; tests expect none. Filled only with validation.
    [[nodiscard]] const std::vector<std::string>& messages() const { return *messages_; }

  private:
    Instance() = default;

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    bool has_debug_utils_ = false;
    // The messenger holds a pointer to this vector, so it must not move.
    std::unique_ptr<std::vector<std::string>> messages_ = std::make_unique<std::vector<std::string>>();
};

}  // namespace onggi::vk
