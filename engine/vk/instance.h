// The Vulkan instance, with the validation layer on request and an ear for what the layers say. Main thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/vulkan.h"

namespace onggi::vk {

struct InstanceDesc {
    // VK_LAYER_KHRONOS_validation with synchronization validation; system lacks if it is not installed.
    bool validation = false;
    std::vector<std::string> extensions{};  // what the window asks for
};

class Instance {
  public:
    static Result<std::unique_ptr<Instance>> create(const InstanceDesc& desc);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    [[nodiscard]] VkInstance handle() const { return instance_; }
    [[nodiscard]] bool names_objects() const { return has_debug_utils_; }
    // Warnings and errors heard so far, oldest first; tests want none. Validation only.
    [[nodiscard]] const std::vector<std::string>& messages() const { return *messages_; }

  private:
    Instance() = default;

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    bool has_debug_utils_ = false;
    // The messenger holds a pointer to it, so it must not move.
    std::unique_ptr<std::vector<std::string>> messages_ = std::make_unique<std::vector<std::string>>();
};

}  // namespace onggi::vk
