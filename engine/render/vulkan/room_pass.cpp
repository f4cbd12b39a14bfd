#include "engine/render/vulkan/room_pass.h"

#include "engine/render/frame/shadow_map.h"

namespace onggi::render {

Result<void> RoomPass::fit(const VulkanFrame& frame, const Scene& scene) {
    if (auto fitted = background_.fit(frame, scene); !fitted) return fitted;
    if (auto fitted = still_.fit(frame.device, scene.still_life); !fitted) return fitted.error();
    return {};
}

void RoomPass::record(const VulkanFrame& frame, const Scene& scene) const {
    if (!scene.background) record_shadow_map(frame, still_);
}

void RoomPass::draw(const VulkanFrame& frame, const Scene& scene) const {
    if (scene.background && scene.transition) return draw_gliding(frame, scene);
    frame.bind(scene.background ? frame.pipelines.background_surface : frame.pipelines.still);
    still_.draw(frame, StillMeshes::Which::kAll);
    frame.draw_screen(scene.background ? frame.pipelines.background : frame.pipelines.backdrop);
}

void RoomPass::draw_gliding(const VulkanFrame& frame, const Scene& scene) const {
    const CameraTransition& transition = *scene.transition;
    const bool is_day = scene.levels.ambient == vec3(1.0F) && scene.levels.key == 1.0F;
    const std::size_t need =
        !is_day ? kTransitionDimmed : (transition.fraction == 0.0F ? kTransitionAlone : kTransitionMixed);
    frame.bind(frame.pipelines.transition_surface[need]);
    still_.draw(frame, StillMeshes::Which::kNotInRelief);
    frame.bind(frame.pipelines.transition[need]);
    background_.draw_relief(frame, transition);
}

}  // namespace onggi::render
