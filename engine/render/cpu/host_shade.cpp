#include "engine/render/cpu/host_shade.h"

#include <algorithm>
#include <cmath>

#include "engine/render/cpu/touched.h"

namespace onggi::render {
namespace {

ShadeLight shade_light(const LightLevels& levels, VkFormat format) {
    const vec3& ambient = levels.ambient;
    if (byte_order(format) == ByteOrder::kRedFirst) return {{ambient.x, ambient.y, ambient.z}, levels.key};
    return {{ambient.z, ambient.y, ambient.x}, levels.key};
}

}  // namespace

Result<void> HostShade::fit(const FrameContext& frame) {
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (shaded_.size() == bytes) return {};
    auto buffer = vk::Buffer::create(frame.device, {.name = "shaded still life",
                                                    .size = bytes,
                                                    .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                                    .use = vk::MemoryUse::kWork});
    if (!buffer) return buffer.error();
    shaded_ = std::move(*buffer);
    touch(shaded_);
    return {};
}

void HostShade::learn(const FrameContext& frame, const ShadeLayers& layers) {
    tiles_.learn({layers.width, layers.height}, layers.places);
    edges_.forget();
    if (frame.desc.smooths_outlines) edges_.find(layers.width, layers.places);
    has_mask_ = false;
}

void HostShade::note_light(const LightLevels& levels) {
    // Of the light, from frame to frame: what no eye sees where it lies beside what has not changed yet.
    constexpr float kLittle = 0.04F;
    const vec3 ambient = glm::abs(levels.ambient - levels_.ambient);
    const float change = std::max({ambient.x, ambient.y, ambient.z, std::abs(levels.key - levels_.key)});
    if (change == 0.0F) return;
    levels_ = levels;
    tiles_.note_light(change < kLittle ? LightChange::kLittle : LightChange::kMuch);
}

bool HostShade::shade(const FrameContext& frame, const Scene& scene, const ShadeLayers& layers,
                      std::span<const std::uint8_t> moving, TileNumbers& numbers) {
    const std::uint64_t shadow = shadow_hash(scene);
    const bool is_another = !has_mask_ || mask_of_ != shadow;
    if (is_another) {
        std::swap(mask_, mask_before_);
        fill_shadow_mask(frame.built.frame, *mask_);
    }
    mask_of_ = shadow;
    if (!has_mask_) {
        levels_ = scene.levels;
        has_mask_ = true;
    } else {
        if (is_another) {
            keep_what_is_alike(*mask_before_, *mask_);
            tiles_.note_mask(*mask_before_, *mask_);
        }
        note_light(scene.levels);
    }
    tiles_.take(moving, numbers.next(), rects_);
    shade_pixels(layers, *mask_, shade_light(scene.levels, frame.desc.colour_format), rects_,
                 shaded_.as<std::uint32_t>());
    edges_.smooth(*mask_, rects_, shaded_.as<std::uint32_t>());
    return is_another;
}

}  // namespace onggi::render
