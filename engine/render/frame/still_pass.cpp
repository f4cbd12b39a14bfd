#include "engine/render/frame/still_pass.h"

namespace onggi::render {
namespace {

std::uint64_t hash_of(const FrameContext& frame, const Scene& scene) {
    return still_hash(scene, static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height));
}

}  // namespace

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

Result<void> StillPass::draw_layers(FrameContext& frame, const Scene& scene) {
    const auto fitted = layers_.fit(frame);
    if (!fitted) return fitted.error();
    if (!frame.stats.still_life_drawn && !*fitted) return {};
    frame.stats.still_life_drawn = true;
    has_layers_ = false;
    const shaders::FrameData by_day =
        by_full_light(scene, bounds(), frame.built, static_cast<int>(frame.extent.width),
                      static_cast<int>(frame.extent.height));
    frame.upload_uniforms(by_day);
    if (!has_plate_) {
        if (auto mapped = frame.run_once([&] { record_key_map(frame); }); !mapped) return mapped;
    }
    auto drawn = layers_.draw(frame, scene, still_, has_plate_ ? &plate_ : nullptr);
    if (!drawn) return drawn;
    has_layers_ = true;
    return {};
}

void StillPass::let_go_layers() {
    layers_.let_go();
    has_layers_ = false;
}

void StillPass::record(const FrameContext& frame) const {
    if (!is_gliding_ && !has_plate_) record_key_map(frame);
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
