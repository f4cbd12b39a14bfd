// Systems of the wheel's scene, run once a frame: free functions over the registry, in the phases of
// engine/ecs/schedule.h. Main thread.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/ecs/schedule.h"
#include "engine/render/scene.h"
#include "game/wheel/components.h"
#include "game/wheel/wheel_view.h"

namespace onggi::wheel {

// Input and output of a frame.
struct FrameContext {
    const WheelView* shown = nullptr;
    int width_px = 0;
    int height_px = 0;
    double dt_s = 0.0;    // since the previous frame; 0: everything is at its goal, as in a still
    render::Scene scene;  // its spans point into the pot and the Clay component
};

// kReceive: copies the snapshot into components.
void receive_clay(ecs::Registry& registry, FrameContext& context);
void receive_wheel(ecs::Registry& registry, FrameContext& context);
void receive_tools(ecs::Registry& registry, FrameContext& context);

// kAnimate: advances animations in time.
void move_tools(ecs::Registry& registry, FrameContext& context);
void move_shavings(ecs::Registry& registry, FrameContext& context);
void move_camera(ecs::Registry& registry, FrameContext& context);
void pass_time_of_day(ecs::Registry& registry, FrameContext& context);

// kExtract: builds the scene to draw from the components.
void extract_camera(ecs::Registry& registry, FrameContext& context);
void extract_light(ecs::Registry& registry, FrameContext& context);
void extract_still_life(ecs::Registry& registry, FrameContext& context);
void extract_clay(ecs::Registry& registry, FrameContext& context);
void extract_tools(ecs::Registry& registry, FrameContext& context);

[[nodiscard]] ecs::Schedule<FrameContext> wheel_schedule();

// The background for a picture of this aspect ratio, and the camera that took it: the nearest ratio if it is
// loaded, else any of the same view. Both null if no background is loaded.
struct ShownBackground {
    const BackgroundCamera* camera = nullptr;
    std::shared_ptr<const render::Background> background;
};
[[nodiscard]] ShownBackground shown_background(const PhotographedRoom& room, int width_px, int height_px);

// The light levels at an evening of 0 to 1: the sun goes, the window dims, a warm lamp stays on the wheel.
[[nodiscard]] render::LightLevels light_levels(double evening);

// The rig's camera for a picture of this aspect ratio.
[[nodiscard]] render::Camera camera_of(const CameraRig& rig, int width_px, int height_px);

}  // namespace onggi::wheel
