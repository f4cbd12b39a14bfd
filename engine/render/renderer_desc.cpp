#include "engine/render/renderer_desc.h"

namespace onggi::render {

ByteOrder byte_order(VkFormat format) {
    return format == VK_FORMAT_B8G8R8A8_UNORM ? ByteOrder::kBlueFirst : ByteOrder::kRedFirst;
}

RendererDesc still_desc(VkFormat colour_format) {
    return {.colour_format = colour_format,
            .samples = 4,
            .cached = false,
            .transfer = Transfer::kExactSrgb,
            .sectors = 192,
            .max_rings = kMaxRings,
            .ring_error_px = 0.05F};
}

RendererDesc live_desc(VkFormat colour_format, bool device_is_cpu, int height_px) {
    if (!device_is_cpu) return still_desc(colour_format);
    const bool is_large = height_px > 800;
    return {
        .colour_format = colour_format,
        .samples = 1,
        .cached = true,
        .transfer = Transfer::kSquareRoot,
        .lights_movers_at_vertices = true,
        .chooses_mover_faces = true,
        .sectors = is_large ? 72 : 48,
        .sector_error_px = 0.5F,
        .max_rings = is_large ? 128 : 72,  // more would be grooves finer than a pixel, which its normals show
        .ring_error_px = 0.25F,            // a finer line would not be seen
        .slip_across = is_large ? 512 : 256,
        .slip_up = is_large ? 256 : 128};
}

}  // namespace onggi::render
