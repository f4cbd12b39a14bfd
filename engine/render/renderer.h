// Draws a Scene into whatever takes frames: a swapchain or an unseen image. Main thread only, one frame in
// flight: a second one would be a frame of delay that the hand sees.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/overlay.h"
#include "engine/render/pass_clock.h"
#include "engine/render/scene.h"
#include "engine/vk/device.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

// How light becomes eight bits. Done in the shader: the target is plain UNORM, because encoding in an _SRGB
// target is neither quick nor the same on every processor under lavapipe.
enum class Transfer {
    kExactSrgb,   // IEC 61966-2-1
    kSquareRoot,  // the live window on a processor: close to sRGB, 1.25 times quicker
};

constexpr int kMaxRings = 256;

struct RendererDesc {
    VkFormat colour_format = VK_FORMAT_R8G8B8A8_UNORM;
    int samples = 4;  // 1 or 4 a pixel
    // For a device that is the processor: what stands still is drawn once and kept where the processor lays
    // shade and overlay over it, and bends it while the camera moves. Needs samples = 1 and kSquareRoot.
    bool cached = false;
    Transfer transfer = Transfer::kExactSrgb;
    // Not at pixels: their triangles are hardly larger. When cached the processor draws them itself.
    bool lights_movers_at_vertices = false;
    bool chooses_mover_faces = false;  // leaves out those that cannot be seen; a GPU does so by itself
    int sectors = 128;                 // of a lathe, at most
    float sector_error_px = 0.0F;  // how far an edge of it may lie from its circle; 0: all of them, evenly
    int max_rings = 256;           // hard cap, 16 to kMaxRings
    float ring_error_px = 0.1F;  // how far the drawn outline may lie from the true one, while the cap allows
    int slip_across = 512;  // texels of the slip's texture, powers of two up to 512; no finer than a pixel
    int slip_up = 512;
    bool smooths_outlines = true;  // of what moves; cached only, others have samples for it
    bool softens_glides = false;   // cached only: half the room's width and height while the camera goes fast
    bool inside_out = false;       // the lathe from its back faces, as a flipped winding would: for tests
    bool measures_parts = false;   // FrameStats::parts, which costs a software device a few per cent

    friend bool operator==(const RendererDesc&, const RendererDesc&) = default;
};

// For a screenshot, and for the moving picture on this kind of device and at this size.
[[nodiscard]] RendererDesc still_desc(VkFormat colour_format);
[[nodiscard]] RendererDesc live_desc(VkFormat colour_format, bool device_is_cpu, int height_px);

// What the last frame took, for tests and for whoever watches.
struct FrameStats {
    int rings = 0;
    float ring_error_px = 0.0F;  // the tolerance that met the cap
    bool still_life_drawn = false;
    bool shadow_drawn = false;
    std::uint64_t bytes_uploaded = 0;
    double device_ms = 0.0;  // of the frame before, from its first command to its last; 0: not measured
    std::vector<PassTime> parts{};   // and of its parts, where they are measured
    bool device_drew_scene = false;  // in that time; false: it showed a screen, or a scene at rest under one
};

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
