#include "engine/render/vulkan/room_pass.h"

#include "engine/render/frame/shadow_map.h"

namespace onggi::render {

Result<void> RoomPass::fit(const VulkanFrame& frame, const Scene& scene) {
    if (auto fitted = background_.fit(frame, scene); !fitted) return fitted;
    const auto is_other = still_.fit(frame.device, scene.still_life);
    if (!is_other) return is_other.error();
    if (*is_other) mapped_.reset();
    return {};
}

void RoomPass::record(const VulkanFrame& frame, const Scene& scene) {
    still_.look_from(vec3(frame.built.frame.eye));
    const mat4& light = frame.built.frame.key_view_projection;
    if (scene.background || mapped_ == light) return;
    record_shadow_map(frame, still_);
    mapped_ = light;
}

void RoomPass::draw(const VulkanFrame& frame, const Scene& scene) const {
    frame.bind(scene.background ? frame.pipelines.background_surface : frame.pipelines.still);
    still_.draw(frame, StillMeshes::Which::kAll);
    frame.draw_screen(scene.background ? frame.pipelines.background : frame.pipelines.backdrop);
}

}  // namespace onggi::render
