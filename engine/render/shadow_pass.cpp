#include "engine/render/shadow_pass.h"

#include <algorithm>

namespace onggi::render {

Result<void> ShadowPass::fit(const FrameContext& frame) {
    return frame.desc.shades_on_host ? host_.fit(frame) : Result<void>();
}

void ShadowPass::update(FrameContext& frame, const Scene& scene, const StillBounds& still) {
    const std::uint64_t now = shadow_hash(scene);
    if (frame.stats.still_life_drawn) host_.forget();
    host_shades_ = frame.desc.shades_on_host && host_.shade(frame, now);
    if (host_shades_) return;
    frame.stats.shadow_drawn = !has_mask_ || now != drawn_;
    drawn_ = now;
    if (!frame.desc.cached) return;
    rects_ = pixels_in_shade(scene, still, frame.built, static_cast<int>(frame.extent.width),
                             static_cast<int>(frame.extent.height));
}

void ShadowPass::pause() {
    host_.let_go();
    host_shades_ = false;
}

void ShadowPass::record(const FrameContext& frame) {
    if (host_shades_ || !frame.stats.shadow_drawn) return;
    const vk::Image& mask = frame.images.mask;
    vk::barrier(frame.commands, mask, vk::state::kDiscard, vk::state::kColour);
    begin_pass(frame.commands, mask.extent(), {{.view = mask.view()}}, {});
    frame.draw_screen(frame.pipelines.mask);
    vkCmdEndRendering(frame.commands);
    vk::barrier(frame.commands, mask, vk::state::kColour, vk::state::kSampled);
    has_mask_ = true;
}

void ShadowPass::record_reading(const FrameContext& frame) {
    // Layers that are drawn in every frame, as at dusk, are not worth reading.
    if (frame.desc.shades_on_host && !frame.stats.still_life_drawn) host_.read_layers(frame);
}

void ShadowPass::draw_shade(const FrameContext& frame) const {
    if (rects_.empty()) return;
    frame.bind(frame.pipelines.shade);
    for (std::size_t first = 0; first < rects_.size(); first += shaders::kShadeRects) {
        const std::size_t count = std::min<std::size_t>(rects_.size() - first, shaders::kShadeRects);
        shaders::ShadeDraw draw{};
        std::copy_n(rects_.begin() + static_cast<std::ptrdiff_t>(first), count, draw.rects);
        frame.push(draw);
        vkCmdDraw(frame.commands, static_cast<std::uint32_t>(6 * count), 1, 0, 0);
    }
}

}  // namespace onggi::render
