// What happens to the wheel's scene once a frame: free functions over the registry, in the phases of
// engine/ecs/schedule.h. Main thread.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/ecs/schedule.h"
#include "engine/render/scene.h"
#include "game/wheel/components.h"
#include "game/wheel/pot_view.h"

namespace onggi::wheel {

// What a frame brings, and what it takes away.
struct FrameContext {
    const PotView* pot = nullptr;
    int width_px = 0;
    int height_px = 0;
    render::Scene scene;  // the radii it points to are the Clay component's
};

// kReceive: the snapshot becomes components.
void receive_clay(ecs::Registry& registry, FrameContext& context);
void receive_wheel(ecs::Registry& registry, FrameContext& context);
void receive_tool(ecs::Registry& registry, FrameContext& context);

// kExtract: components become the scene that is drawn.
void extract_camera(ecs::Registry& registry, FrameContext& context);
void extract_light(ecs::Registry& registry, FrameContext& context);
void extract_still_life(ecs::Registry& registry, FrameContext& context);
void extract_clay(ecs::Registry& registry, FrameContext& context);
void extract_tools(ecs::Registry& registry, FrameContext& context);

[[nodiscard]] ecs::Schedule<FrameContext> wheel_schedule();

// The rig's camera for a picture of this shape.
[[nodiscard]] render::Camera camera_of(const CameraRig& rig, int width_px, int height_px);

}  // namespace onggi::wheel
