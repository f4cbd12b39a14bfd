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
    frame.bind(scene.background ? frame.pipelines.background_surface : frame.pipelines.still);
    still_.draw(frame, StillMeshes::Which::kAll);
    frame.draw_screen(scene.background ? frame.pipelines.background : frame.pipelines.backdrop);
}

}  // namespace onggi::render
