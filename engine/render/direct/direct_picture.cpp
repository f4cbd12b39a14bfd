#include "engine/render/direct/direct_picture.h"

namespace onggi::render {

Result<void> DirectPicture::create(FrameContext& frame) {
    const vk::Image& mask = frame.images.mask;
    vk::write_image(frame.device, frame.set(), shaders::kBindMask, mask.view(),
                    frame.pipelines.clamped.get());
    // What is bound must be laid out, though not every scene has it drawn or read.
    auto laid_out = frame.device.run_once(
        [&](VkCommandBuffer once) { vk::barrier(once, mask, vk::state::kUndefined, vk::state::kSampled); });
    if (!laid_out) return laid_out;
    RoomPass::create(frame);
    if (auto created = movers_.create(frame); !created) return created;
    if (auto created = lathe_.create(frame); !created) return created;
    return overlay_.create(frame);
}

Result<void> DirectPicture::fit(FrameContext& frame, const Scene& scene) {
    return room_.fit(frame, scene);
}

Result<void> DirectPicture::upload(FrameContext& frame, const Scene& scene) {
    frame.clock.enter_host("shapes");
    frame.build(scene, room_.bounds());
    frame.stats.still_life_drawn = true;
    models_.choose(scene, frame.desc, frame.view(scene), frame.built);
    if (auto fitted = movers_.fit(frame, scene); !fitted) return fitted;
    if (auto sent = movers_.upload(frame, models_); !sent) return sent;
    shadow_.update(frame, scene);
    frame.clock.end_host();
    frame.upload_uniforms(frame.built.frame);
    lathe_.upload(frame.built);
    return {};
}

Result<bool> DirectPicture::draw(FrameContext& frame, const Scene& scene, const vk::TargetImage& target,
                                 const Overlay* overlay) {
    const bool shows_scene = overlay == nullptr || !overlay->covers;
    if (shows_scene) {
        if (auto sent = upload(frame, scene); !sent) return sent.error();
    }
    if (auto fitted = overlay_.fit(frame, overlay); !fitted) return fitted.error();
    if (auto begun = frame.begin(); !begun) return begun.error();
    frame.enter("overlay's pictures");
    overlay_.record_uploads(frame);
    if (shows_scene) record(frame, scene, target);
    frame.enter("overlay");
    overlay_.record(frame, target, shows_scene);
    if (auto ended = frame.end(target); !ended) return ended.error();
    // Any view is drawn as quickly as any other.
    frame.stats.next_view_ready = scene.next_view.has_value();
    return shows_scene;
}

void DirectPicture::record(FrameContext& frame, const Scene& scene, const vk::TargetImage& target) {
    const VkCommandBuffer commands = frame.commands;
    const FrameImages& images = frame.images;
    frame.bind_set();
    frame.enter("shadow maps");
    room_.record(frame, scene);
    shadow_.record(frame);
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kDiscard, vk::state::kColour);
    vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kDepth);
    PassColour colour{.view = target.view};
    if (frame.desc.samples > 1) {
        vk::barrier(commands, images.multisampled, vk::state::kDiscard, vk::state::kColour);
        colour = {.view = images.multisampled.view(), .resolve = target.view};
    }
    begin_pass(commands, frame.extent, {colour}, {.view = images.depth.view()});
    // Front to back, so that what is hidden is not shaded.
    frame.enter("clay");
    lathe_.draw(frame);
    frame.enter("hands and tools");
    movers_.draw(frame, scene, models_);
    frame.enter("still life");
    room_.draw(frame, scene);
    vkCmdEndRendering(commands);
}

}  // namespace onggi::render
