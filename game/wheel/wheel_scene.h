// The potter's-wheel scene: its entities, and the frame that comes of them. Wheel, clay, tool, camera, lights
// and everything that stands about are entities of one registry, and what is drawn comes out of the registry
// and from nowhere else. Main thread.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/ecs/schedule.h"
#include "engine/render/scene.h"
#include "game/wheel/pot_view.h"
#include "game/wheel/systems.h"

namespace onggi::wheel {

class WheelScene {
  public:
    WheelScene();

    // Runs every system for a picture of this size. The scene it gives is good until the next call.
    const render::Scene& apply(const PotView& pot, int width_px, int height_px);

    // Where a pointer at this pixel puts the tool, mm; see LiveView::tool_target_mm.
    [[nodiscard]] std::optional<dvec3> tool_target_mm(double x_px, double y_px, int width_px, int height_px);

    [[nodiscard]] ecs::Registry& registry() { return registry_; }
    [[nodiscard]] ecs::Entity clay() const { return clay_; }
    [[nodiscard]] ecs::Entity tool() const { return tool_; }
    [[nodiscard]] ecs::Entity camera() const { return camera_; }

  private:
    ecs::Registry registry_;
    ecs::Schedule<FrameContext> schedule_ = wheel_schedule();
    FrameContext context_;
    ecs::Entity clay_;
    ecs::Entity tool_;
    ecs::Entity camera_;
};

}  // namespace onggi::wheel
