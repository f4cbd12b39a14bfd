// The still life on the device: one vertex and one index buffer, filled when its revision changes. Main
// thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/mesh_buffers.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/frame_build.h"

namespace onggi::render {

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

}  // namespace onggi::render
