// What happens to the wheel's scene once a frame: free functions over the registry, in the phases of
// engine/ecs/schedule.h. Main thread.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/ecs/schedule.h"
#include "engine/render/scene.h"
#include "game/wheel/components.h"
#include "game/wheel/wheel_view.h"

namespace onggi::wheel {

// What a frame brings, and what it takes away.
struct FrameContext {
    const WheelView* shown = nullptr;
    int width_px = 0;
    int height_px = 0;
    double dt_s = 0.0;    // since the frame before; 0: everything is where it is wanted, as in a still
    render::Scene scene;  // what it points to is the pot's and the Clay component's
};

// kReceive: the snapshot becomes components.
void receive_clay(ecs::Registry& registry, FrameContext& context);
void receive_wheel(ecs::Registry& registry, FrameContext& context);
void receive_tools(ecs::Registry& registry, FrameContext& context);

// kAnimate: what eases in time.
void move_tools(ecs::Registry& registry, FrameContext& context);
void move_shavings(ecs::Registry& registry, FrameContext& context);
void move_camera(ecs::Registry& registry, FrameContext& context);
void pass_time_of_day(ecs::Registry& registry, FrameContext& context);

// kExtract: components become the scene that is drawn.
void extract_camera(ecs::Registry& registry, FrameContext& context);
void extract_light(ecs::Registry& registry, FrameContext& context);
void extract_still_life(ecs::Registry& registry, FrameContext& context);
void extract_clay(ecs::Registry& registry, FrameContext& context);
void extract_tools(ecs::Registry& registry, FrameContext& context);

[[nodiscard]] ecs::Schedule<FrameContext> wheel_schedule();

// The background that a picture of this shape shows, and the camera that took it: of the nearest shape if it
// is there, else any of the same view. Both null if there is none.
struct ShownBackground {
    const BackgroundCamera* camera = nullptr;
    std::shared_ptr<const render::Background> background;
};
[[nodiscard]] ShownBackground shown_background(const PhotographedRoom& room, int width_px, int height_px);

// What an evening of 0 to 1 leaves of the light: the sun is gone, the window is dim, a warm lamp stays on the
// wheel.
[[nodiscard]] render::LightLevels light_levels(double evening);

// The rig's camera for a picture of this shape.
[[nodiscard]] render::Camera camera_of(const CameraRig& rig, int width_px, int height_px);

}  // namespace onggi::wheel
