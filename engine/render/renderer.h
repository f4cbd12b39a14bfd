// Draws a Scene into a frame target: a swapchain or an offscreen image. Main thread only. One frame in
// flight: a second one would add a frame of latency between the hand and the picture.
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

    // Waits for the previous frame, then records and submits this one. Returns false if the target takes no
    // frame now (minimised, resizing). The overlay is drawn over the scene or replaces it.
    Result<bool> draw(const Scene& scene, vk::FrameTarget& target, const Overlay* overlay = nullptr);

    // Switches FrameStats::parts on or off, from the frame after the next.
    void measure_parts(bool measures);

    [[nodiscard]] const FrameStats& stats() const;
    [[nodiscard]] const RendererDesc& desc() const;

  private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::render
