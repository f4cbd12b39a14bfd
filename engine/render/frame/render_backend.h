// How a scene becomes a picture on a device: one of the two in vulkan_backend.h and cpu_backend.h, chosen
// once when a renderer is made. Main thread.
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

    // Once, before all else. Errors: the device's.
    virtual Result<void> create() = 0;
    // Whatever a picture of this size and what stands still in the scene ask for, where it is not there yet.
    // The device is idle.
    virtual Result<void> fit(const Scene& scene, VkExtent2D target) = 0;
    // Puts all that a frame shows together and records its commands; after fit() with the same scene and
    // size. The device is idle. False: the scene is not in it, because a screen covers it or it stands still.
    virtual Result<bool> draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) = 0;

    [[nodiscard]] virtual FrameContext& frame() = 0;
};

}  // namespace onggi::render
