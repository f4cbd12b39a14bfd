#include "engine/render/still_pass.h"

namespace onggi::render {
namespace {

std::uint64_t hash_of(const FrameContext& frame, const Scene& scene) {
    return still_hash(scene, static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height));
}

}  // namespace

void StillPass::bind_placeholders(const FrameContext& frame) {
    // No direct shader reads the layers, and Vulkan lets such bindings stay empty; lavapipe 22.3 follows them
    // all the same and crashes.
    for (const int binding :
         {shaders::kBindStillKey, shaders::kBindStillAmbient, shaders::kBindStillCoords}) {
        vk::write_image(frame.device, frame.set(), static_cast<std::uint32_t>(binding),
                        frame.images.mask.view(), frame.pipelines.exact.get());
    }
    PlatePass::bind_placeholders(frame);
}

void StillPass::resized(const FrameContext& frame) {
    has_layers_ = false;
    if (!frame.desc.cached) return;
    const VkSampler exact = frame.pipelines.exact.get();
    const FrameImages& images = frame.images;
    vk::write_image(frame.device, frame.set(), shaders::kBindStillKey, images.still_key.view(), exact);
    vk::write_image(frame.device, frame.set(), shaders::kBindStillAmbient, images.still_ambient.view(),
                    exact);
    vk::write_image(frame.device, frame.set(), shaders::kBindStillCoords, images.still_coords.view(), exact);
}

Result<void> StillPass::fit(const FrameContext& frame, const Scene& scene) {
    const auto changed = plate_.fit(frame, scene);
    if (!changed) return changed.error();
    if (*changed) has_layers_ = false;
    has_plate_ = scene.plate != nullptr;
    const std::uint64_t revision = scene.still_life ? scene.still_life->revision : 0;
    if (scene.still_life == uploaded_ && revision == uploaded_revision_) return {};
    const StillLife nothing;
    if (auto uploaded = still_.upload(frame.device, scene.still_life ? *scene.still_life : nothing);
        !uploaded) {
        return uploaded;
    }
    uploaded_ = scene.still_life;
    uploaded_revision_ = revision;
    has_layers_ = false;
    return {};
}

bool StillPass::shows(const FrameContext& frame, const Scene& scene) const {
    return has_layers_ && drawn_ == hash_of(frame, scene);
}

void StillPass::update(FrameContext& frame, const Scene& scene) {
    const std::uint64_t now = hash_of(frame, scene);
    is_gliding_ = scene.glide.has_value();
    const bool is_day = scene.levels.ambient == vec3(1.0F) && scene.levels.key == 1.0F;
    const bool is_alone = is_gliding_ && scene.glide->share == 0.0F;
    glide_need_ = !is_day ? kGlideDimmed : (is_alone ? kGlideAlone : kGlideMixed);
    frame.stats.still_life_drawn = is_gliding_ || !frame.desc.cached || !has_layers_ || now != drawn_;
    if (is_gliding_) has_layers_ = false;
    drawn_ = now;
}

void StillPass::record(const FrameContext& frame) {
    if (!frame.stats.still_life_drawn || is_gliding_) return;
    record_key_map(frame);
    if (frame.desc.cached) record_layers(frame);
    has_layers_ = true;
}

void StillPass::record_key_map(const FrameContext& frame) const {
    const vk::Image& map = frame.images.key_map;
    vk::barrier(frame.commands, map, vk::state::kDiscard, vk::state::kDepth);
    begin_pass(frame.commands, map.extent(), {}, {.view = map.view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
    frame.bind(frame.pipelines.key_map);
    still_.draw(frame.commands, frame.pipelines.layout.get(), StillMeshes::Which::kCasters);
    vkCmdEndRendering(frame.commands);
    vk::barrier(frame.commands, map, vk::state::kDepth, vk::state::kSampled);
}

void StillPass::record_layers(const FrameContext& frame) const {
    const VkCommandBuffer commands = frame.commands;
    const FrameImages& images = frame.images;
    for (const vk::Image* image : {&images.still_key, &images.still_ambient, &images.still_coords})
        vk::barrier(commands, *image, vk::state::kDiscard, vk::state::kColour);
    vk::barrier(commands, images.still_depth, vk::state::kDiscard, vk::state::kDepth);
    begin_pass(commands, frame.extent,
               {{.view = images.still_key.view()},
                {.view = images.still_ambient.view()},
                {.view = images.still_coords.view()}},
               {.view = images.still_depth.view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
    draw(frame);
    vkCmdEndRendering(commands);
    for (const vk::Image* image : {&images.still_key, &images.still_ambient, &images.still_coords})
        vk::barrier(commands, *image, vk::state::kColour, vk::state::kSampled);
    vk::barrier(commands, images.still_depth, vk::state::kDepth, vk::state::kCopySource);
}

void StillPass::record_copy(const FrameContext& frame, VkImage target) const {
    constexpr VkImageAspectFlags kColourAspect = VK_IMAGE_ASPECT_COLOR_BIT;
    const VkCommandBuffer commands = frame.commands;
    const FrameImages& images = frame.images;
    vk::barrier(commands, target, kColourAspect, vk::state::kDiscard, vk::state::kCopyTarget);
    vk::barrier(commands, images.still_key, vk::state::kSampled, vk::state::kCopySource);
    vk::copy(commands, images.still_key.handle(), target, kColourAspect, {{0, 0}, frame.extent});
    vk::barrier(commands, images.still_key, vk::state::kCopySource, vk::state::kSampled);
    vk::barrier(commands, target, kColourAspect, vk::state::kCopyTarget, vk::state::kColour);
}

void StillPass::record_depth_copy(const FrameContext& frame) const {
    const VkCommandBuffer commands = frame.commands;
    const FrameImages& images = frame.images;
    if (!frame.built.moving_rects.empty()) {
        vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kCopyTarget);
        copy_rects(commands, images.still_depth.handle(), images.depth.handle(), VK_IMAGE_ASPECT_DEPTH_BIT,
                   frame.built.moving_rects);
        vk::barrier(commands, images.depth, vk::state::kCopyTarget, vk::state::kDepth);
    } else {
        vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kDepth);
    }
}

void StillPass::draw(const FrameContext& frame) const {
    frame.bind(has_plate_ ? frame.pipelines.plate_surface : frame.pipelines.still);
    still_.draw(frame.commands, frame.pipelines.layout.get(), StillMeshes::Which::kAll);
    frame.draw_screen(has_plate_ ? frame.pipelines.plate : frame.pipelines.backdrop);
}

void StillPass::draw_gliding(const FrameContext& frame, const Glide& glide) const {
    frame.bind(frame.pipelines.glide_surface[glide_need_]);
    still_.draw(frame.commands, frame.pipelines.layout.get(), StillMeshes::Which::kNotInRelief);
    frame.bind(frame.pipelines.glide[glide_need_]);
    plate_.draw_relief(frame, glide);
}

}  // namespace onggi::render
