// What a renderer is asked for: how the picture is made, and how finely. Any thread; pure. Pixels.
#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/render/byte_order.h"
#include "engine/vk/vulkan.h"

namespace onggi::render {

constexpr int kMaxRings = 256;

using HostClock = std::int64_t (*)();  // ns

// How a scene becomes a picture. Chosen once, when a renderer is made; both take the same scenes.
enum class Backend {
    kVulkan,  // the device draws everything in every frame: GPUs, and screenshots everywhere
    // For a device that is the processor: what stands still is drawn once and kept, and the processor draws
    // what moves over it itself.
    kCpu,
};

struct RendererDesc {
    VkFormat colour_format = VK_FORMAT_R8G8B8A8_UNORM;
    Backend backend = Backend::kVulkan;
    int samples = 4;               // a pixel, 1 or 4; kCpu: 1
    float scale = 1.0F;            // of the scene's picture to its target, each way, 0.25 to 1; kCpu: 1
    int sectors = 128;             // of a lathe, at most
    float sector_error_px = 0.0F;  // how far an edge of it may lie from its circle; 0: all of them, evenly
    int max_rings = 256;           // hard cap, 16 to kMaxRings
    float ring_error_px = 0.1F;  // how far the drawn outline may lie from the true one, while the cap allows
    int streaks_across =
        512;  // texels of the streaks' texture, powers of two up to 512; no finer than a pixel
    int streaks_up = 512;
    bool smooths_outlines = false;    // of what moves; kCpu only, others have samples for it
    bool draws_hidden_faces = false;  // kCpu, of hands and tools: for tests
    bool inside_out = false;  // kVulkan, the lathe from its back faces, as a flipped winding would: for tests
    bool measures_parts = false;     // FrameStats::parts, which costs a software device a few per cent
    HostClock host_clock = nullptr;  // measures the host's own parts; null: they are left out

    friend bool operator==(const RendererDesc&, const RendererDesc&) = default;
};

[[nodiscard]] ByteOrder byte_order(VkFormat format);

// Errors: what no backend draws.
[[nodiscard]] Result<void> check_desc(const RendererDesc& desc);

// For a screenshot, and for the moving picture on this kind of device and at this size.
[[nodiscard]] RendererDesc still_desc(VkFormat colour_format);
[[nodiscard]] RendererDesc live_desc(VkFormat colour_format, bool device_is_cpu, int height_px);

}  // namespace onggi::render
