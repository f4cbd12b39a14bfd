// The background: what stands still, drawn into every frame. Main thread.
#pragma once

#include <optional>

#include "engine/core/result.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/vulkan/background_pass.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

class RoomPass {
  public:
    // Once, with the pipelines and images of fixed size there.
    static void create(const VulkanFrame& frame) { BackgroundPass::bind_placeholders(frame); }
    // The still life of the scene and its backgrounds onto the device, if they are others. The device is
    // idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // The still life's shadow map, where it is another than the one that is there.
    void record(const VulkanFrame& frame, const Scene& scene);
    // Meshes and backdrop inside the caller's pass; front to back, so after what stands before them.
    void draw(const VulkanFrame& frame, const Scene& scene) const;

    [[nodiscard]] const StillBounds& bounds() const { return still_.bounds(); }

    // What a view of this background would be drawn from is on the device; null: it needs nothing.
    [[nodiscard]] bool has(const Background* background) const {
        return background == nullptr || background_.has(background);
    }

  private:
    BackgroundPass background_;
    StillMeshes still_;
    std::optional<mat4> mapped_;  // as the key light saw the still life when its map was drawn
};

}  // namespace onggi::render
