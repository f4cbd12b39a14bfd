// Settings of a renderer: which backend draws, and how finely. Any thread; pure. Pixels.
#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/render/byte_order.h"
#include "engine/vk/vulkan.h"

namespace onggi::jobs {
class SharedLoop;
}

namespace onggi::render {

constexpr int kMaxRings = 256;

using HostClock = std::int64_t (*)();  // ns

// The renderer's backend. Chosen once, when a renderer is created; both draw the same scenes.
enum class Backend {
    kVulkan,  // the device draws everything in every frame: for GPUs, and for screenshots everywhere
    // For a software device: the device draws the still life once into a cache, and the processor draws the
    // moving things over it.
    kCpu,
};

struct RendererDesc {
    VkFormat colour_format = VK_FORMAT_R8G8B8A8_UNORM;
    Backend backend = Backend::kVulkan;
    int samples = 4;  // per pixel, 1 or 4; kCpu: 1
    // Size of the scene's picture relative to its target, in each direction, 0.25 to 1; kCpu: 1.
    float scale = 1.0F;
    int sectors = 128;  // maximum sectors of a lathe
    // Maximum distance of a sector's edge from the true circle; 0: all sectors, evenly spaced.
    float sector_error_px = 0.0F;
    int max_rings = 256;  // hard cap, 16 to kMaxRings
    // Maximum distance of the drawn outline from the true one, as far as max_rings allows.
    float ring_error_px = 0.1F;
    int streaks_across =
        512;  // texels of the streaks' texture, powers of two up to 512; no need to be finer than a pixel
    int streaks_up = 512;
    bool smooths_outlines = false;    // of moving things; kCpu only, kVulkan has samples for it
    bool draws_hidden_faces = false;  // kCpu only, hands and tools: for tests
    // KVulkan only, draws the lathe's back faces as a flipped winding would: for tests.
    bool inside_out = false;
    bool measures_parts = false;  // fills in FrameStats::parts; costs a software device a few per cent
    // A second thread for large pictures; must outlive the renderer. Null: none. kCpu only.
    jobs::SharedLoop* loop = nullptr;
    HostClock host_clock = nullptr;  // measures the host's parts; null: they are omitted

    friend bool operator==(const RendererDesc&, const RendererDesc&) = default;
};

[[nodiscard]] ByteOrder byte_order(VkFormat format);

// Errors: a setting out of range for the backend.
[[nodiscard]] Result<void> check_desc(const RendererDesc& desc);

// Settings for a screenshot, and for the live picture on this kind of device at this height.
[[nodiscard]] RendererDesc still_desc(VkFormat colour_format);
[[nodiscard]] RendererDesc live_desc(VkFormat colour_format, bool device_is_cpu, int height_px);

}  // namespace onggi::render
