// The still life on the device: one vertex and one index buffer, filled when its revision changes. Main
// thread.
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

// One vertex and one index buffer on the device, for many meshes together.
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

class StillMeshes {
  public:
    // Uploads a still life, none where it is null, unless it is there as it is now; true: it was not.
    // Precondition: the device does not read what was uploaded before.
    Result<bool> fit(const vk::Device& device, const std::shared_ptr<const StillLife>& still_life);

    // From now on what is nearer to the eye is drawn before what is farther, so that little is shaded and
    // then hidden.
    void look_from(const vec3& eye_mm);

    enum class Which { kAll, kCasters };
    // Draws each part with its push constants.
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
    std::shared_ptr<const StillLife> uploaded_;  // held, so that its revision is compared with itself
    std::uint64_t revision_ = 0;
};

// The shadow map of a still life in its own colours: what stands still casts on itself. Its pipeline, where
// there is none yet.
Result<void> fit_shadow_map(FrameContext& frame);
// Into the frame's shadow_map, in commands that are outside of any pass.
void record_shadow_map(const FrameContext& frame, const StillMeshes& meshes);

}  // namespace onggi::render
