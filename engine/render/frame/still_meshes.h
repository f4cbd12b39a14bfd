// The static meshes on the device: one vertex and one index buffer, uploaded when their revision changes.
// Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/vk/buffer.h"

namespace onggi::render {

// One vertex and one index buffer on the device, shared by many meshes.
class MeshBuffers {
  public:
    // Replaces the contents; does nothing if `indices` is empty. `name` is the debug name. Precondition: the
    // device no longer reads the old contents.
    Result<void> upload(const vk::Device& device, const std::string& name,
                        std::span<const std::byte> vertices, std::span<const std::uint32_t> indices);
    // Precondition: upload() got indices.
    void bind(VkCommandBuffer commands) const;

  private:
    vk::Buffer vertices_;
    vk::Buffer indices_;
};

class StillMeshes {
  public:
    // Uploads the static meshes if they changed (null clears them). Returns whether anything was uploaded.
    // Precondition: the device no longer reads the old contents.
    Result<bool> fit(const vk::Device& device, const std::shared_ptr<const StillLife>& still_life);

    // Sorts the parts front to back as seen from the eye, to reduce overdraw.
    void look_from(const vec3& eye_mm);

    enum class Which { kAll, kCasters };
    // Draws the parts, each with its push constants.
    void draw(const FrameContext& frame, Which which) const;
    [[nodiscard]] const StillBounds& bounds() const { return bounds_; }

  private:
    Result<void> upload(const vk::Device& device, const StillLife& still_life);

    struct Part {
        shaders::MeshDraw draw;
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
        std::int32_t first_vertex = 0;
        vec3 centre_mm{0.0F};
        bool casts_shadow = true;
    };
    MeshBuffers buffers_;
    std::vector<Part> parts_;
    StillBounds bounds_;
    // Keeps its address from being reused, so that comparing revisions is valid.
    std::shared_ptr<const StillLife> uploaded_;
    std::uint64_t revision_ = 0;
};

// Creates the pipeline of the still life's shadow map if it does not exist. The map holds the shadows of the
// still life on itself, where it is drawn in its own colours.
Result<void> fit_shadow_map(FrameContext& frame);
// Records the shadow map into the frame's shadow_map. Call outside of any pass.
void record_shadow_map(const FrameContext& frame, const StillMeshes& meshes);

}  // namespace onggi::render
