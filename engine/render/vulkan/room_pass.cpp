#include "engine/render/vulkan/room_pass.h"

#include "engine/render/frame/key_map.h"

namespace onggi::render {

Result<void> RoomPass::fit(const VulkanFrame& frame, const Scene& scene) {
    if (auto fitted = plate_.fit(frame, scene); !fitted) return fitted;
    if (auto fitted = still_.fit(frame.device, scene.still_life); !fitted) return fitted.error();
    return {};
}

void RoomPass::record(const VulkanFrame& frame, const Scene& scene) const {
    if (!scene.plate) record_key_map(frame, still_);
}

void RoomPass::draw(const VulkanFrame& frame, const Scene& scene) const {
    if (scene.plate && scene.glide) return draw_gliding(frame, scene);
    frame.bind(scene.plate ? frame.pipelines.plate_surface : frame.pipelines.still);
    still_.draw(frame.commands, frame.layout.get(), StillMeshes::Which::kAll);
    frame.draw_screen(scene.plate ? frame.pipelines.plate : frame.pipelines.backdrop);
}

void RoomPass::draw_gliding(const VulkanFrame& frame, const Scene& scene) const {
    const Glide& glide = *scene.glide;
    const bool is_day = scene.levels.ambient == vec3(1.0F) && scene.levels.key == 1.0F;
    const std::size_t need = !is_day ? kGlideDimmed : (glide.share == 0.0F ? kGlideAlone : kGlideMixed);
    frame.bind(frame.pipelines.glide_surface[need]);
    still_.draw(frame.commands, frame.layout.get(), StillMeshes::Which::kNotInRelief);
    frame.bind(frame.pipelines.glide[need]);
    plate_.draw_relief(frame, glide);
}

}  // namespace onggi::render
