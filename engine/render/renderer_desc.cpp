#include "engine/render/renderer_desc.h"

namespace onggi::render {

ByteOrder byte_order(VkFormat format) {
    return format == VK_FORMAT_B8G8R8A8_UNORM ? ByteOrder::kBlueFirst : ByteOrder::kRedFirst;
}

Result<void> check_desc(const RendererDesc& desc) {
    const bool is_whole = desc.scale == 1.0F;
    if (desc.backend == Backend::kCpu) {
        if (desc.samples == 1 && is_whole && !desc.inside_out) return {};
        return failed(
            "renderer: expected one sample per pixel, full size and outer faces for the processor's backend, "
            "found others");
    }
    const bool has_samples = desc.samples == 1 || desc.samples == 4;
    if (has_samples && desc.scale >= 0.25F && desc.scale <= 1.0F && !desc.smooths_outlines) return {};
    return failed(
        "renderer: expected one or four samples per pixel, a scale of 0.25 to 1 and no smoothing for the "
        "Vulkan backend, found others");
}

RendererDesc still_desc(VkFormat colour_format) {
    return {.colour_format = colour_format,
            .backend = Backend::kVulkan,
            .samples = 4,
            .sectors = 192,
            .max_rings = kMaxRings,
            .ring_error_px = 0.05F};
}

RendererDesc live_desc(VkFormat colour_format, bool device_is_cpu, int height_px) {
    if (!device_is_cpu) return still_desc(colour_format);
    const bool is_large = height_px > 800;
    return {
        .colour_format = colour_format,
        .backend = Backend::kCpu,
        .samples = 1,
        .sectors = is_large ? 72 : 48,
        .sector_error_px = 0.5F,
        .max_rings = is_large ? 128 : 72,  // more would be grooves finer than a pixel, which the normals show
        .ring_error_px = 0.25F,            // a smaller error is not visible
        .streaks_across = is_large ? 512 : 256,
        .streaks_up = is_large ? 256 : 128,
        .smooths_outlines = true};
}

}  // namespace onggi::render
