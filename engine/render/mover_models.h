// The movers' meshes on the device: one vertex and one index buffer for a whole library. Main thread.
#pragma once

#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/mesh_buffers.h"
#include "engine/render/mover.h"
#include "engine/render/mover_edges.h"

namespace onggi::render {

class MoverModels {
  public:
    // Nothing happens if it is the library that is there already. Precondition: the device is idle.
    Result<void> upload(const vk::Device& device, const std::shared_ptr<const MoverLibrary>& library);

    // Where a mesh of a model lies in the buffers; the planes of its faces, see face_planes(); its edges.
    struct Range {
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
        std::int32_t first_vertex = 0;
        std::vector<vec4> planes{};
        std::vector<MeshEdge> edges{};
    };
    // One a mesh; empty for a model that the library does not have.
    [[nodiscard]] const std::vector<Range>& ranges(std::size_t model) const;
    void bind(VkCommandBuffer commands) const { buffers_.bind(commands); }

  private:
    std::shared_ptr<const MoverLibrary> uploaded_;
    std::vector<std::vector<Range>> ranges_;
    MeshBuffers buffers_;
};

}  // namespace onggi::render
