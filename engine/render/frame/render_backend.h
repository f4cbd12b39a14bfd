// The interface of both backends, see vulkan_backend.h and cpu_backend.h. Chosen once, when a renderer is
// created. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/overlay.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

class RenderBackend {
  public:
    RenderBackend() = default;
    virtual ~RenderBackend() = default;
    RenderBackend(const RenderBackend&) = delete;
    RenderBackend& operator=(const RenderBackend&) = delete;

    // Must be called first, once. Errors: the device's.
    virtual Result<void> create() = 0;
    // Creates whatever this target size and the scene's static contents need and do not have yet. The device
    // is idle.
    virtual Result<void> fit(const Scene& scene, VkExtent2D target) = 0;
    // Builds the frame and records its commands. Call after fit() with the same scene and size. The device is
    // idle. Returns false if the frame does not draw the scene, because a screen covers it or it rests.
    virtual Result<bool> draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) = 0;

    [[nodiscard]] virtual FrameContext& frame() = 0;
};

}  // namespace onggi::render
