// One vertex and one index buffer on the device, for many meshes together. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "engine/core/result.h"
#include "engine/vk/buffer.h"

namespace onggi::render {

class MeshBuffers {
  public:
    // In place of what was there; nothing to do without indices. `name` is what a debugger calls them.
    // Precondition: the device does not read what was uploaded before.
    Result<void> upload(const vk::Device& device, const std::string& name,
                        std::span<const std::byte> vertices, std::span<const std::uint32_t> indices);
    // Precondition: there were indices.
    void bind(VkCommandBuffer commands) const;

  private:
    vk::Buffer vertices_;
    vk::Buffer indices_;
};

}  // namespace onggi::render
