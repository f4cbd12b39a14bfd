// Draws a Scene into whatever takes frames: a swapchain or an unseen image. Main thread only, one frame in
// flight: a second one would be a frame of delay that the hand sees.
#pragma once

#include <memory>

#include "engine/core/result.h"
#include "engine/render/frame_stats.h"
#include "engine/render/overlay.h"
#include "engine/render/renderer_desc.h"
#include "engine/render/scene.h"
#include "engine/vk/device.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

class Renderer {
  public:
    // The device must outlive the renderer.
    static Result<std::unique_ptr<Renderer>> create(vk::Device& device, const RendererDesc& desc);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Waits for the frame before, then records and submits this one. False if the target takes no frame just
    // now (minimised, resizing). An overlay is laid over the scene, or stands instead of it.
    Result<bool> draw(const Scene& scene, vk::FrameTarget& target, const Overlay* overlay = nullptr);

    // FrameStats::parts from the frame after the next on, or not any more.
    void measure_parts(bool measures);

    [[nodiscard]] const FrameStats& stats() const;
    [[nodiscard]] const RendererDesc& desc() const;

  private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::render
