// What the entities of the wheel's scene are made of. Plain data; main thread. mm, rad, linear light.
#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "game/pot/pot.h"
#include "game/wheel/framing.h"
#include "game/wheel/shavings.h"
#include "game/wheel/tool_pose.h"
#include "game/wheel/workshop_files.h"

namespace onggi::wheel {

// One number on its way to a goal: a spring that is damped just so that it never swings past.
struct Settling {
    double value = 0.0;
    double speed = 0.0;  // a second

    friend bool operator==(const Settling&, const Settling&) = default;
};
// After dt_s seconds; exact for any step. After 5 / rate_per_s about 96 % of the way is done.
[[nodiscard]] inline Settling settled(const Settling& now, double goal, double rate_per_s, double dt_s) {
    // x'' = -2 r x' - r^2 x about the goal, solved: (x0 + (v0 + r x0) t) exp(-r t).
    const double away = now.value - goal;
    const double push = now.speed + rate_per_s * away;
    const double decay = std::exp(-rate_per_s * dt_s);
    return {.value = goal + (away + push * dt_s) * decay,
            .speed = (now.speed - rate_per_s * push * dt_s) * decay};
}

// Where an entity is.
struct Transform {
    dvec3 position_mm{0.0};
};

// The turning wheel head. The clay turns with it.
struct Wheel {
    dvec2 direction{1.0, 0.0};  // (cos, sin) of the angle turned, counter-clockwise from above
    bool turning = false;
};

// The clay on the wheel, while a frame is put together, and how it is to be shown.
struct Clay {
    const pot::Pot* pot = nullptr;  // as WheelView has it
    render::LatheMaterial material{};
    std::vector<float> wetness{};  // of each ring: how much its water darkens it
    bool shows_load = false;
    const render::LatheMarks* marks = nullptr;  // as WheelView has them
    bool is_cut_open = false;                   // towards the camera
    float edge_rounding_mm = 0.0F;
};

// A hand and what it holds: shown as the ball that touches, or as hand and tool.
struct Tool {
    ToolSight sight{};
    ToolPose pose{};
    bool as_ball = true;
};

// What fell from a trimmer.
struct Shaved {
    Shavings shavings{};
};

// What is not in the photographs of the bench because it can be taken from it.
struct OnBench {
    bool rib = false;
};

// The wire that cuts the pot off, or its rim.
struct Wire {
    bool shown = false;
    double height_mm = 0.0;
};

// What tools look like; see load_tool_models(). Of the ball alone: all are balls.
struct ToolShelf {
    std::shared_ptr<const render::PropLibrary> library;

    [[nodiscard]] bool has_tools() const { return library->size() > 1; }
};

// Frames the wheel so that `height_mm` of it fill the picture's height, or `width_mm` its width, whichever
// shows more.
struct CameraRig {
    dvec3 target_mm{0.0};
    double distance_mm = 900.0;
    double elevation_rad = 0.25;
    double azimuth_rad = 0.0;  // 0 looks along -Z
    double height_mm = 350.0;
    double width_mm = 330.0;
};

// Where the camera of a background stands, and how much of the background it shows.
struct ViewPlace {
    std::string camera;
    Framing framing{};

    friend bool operator==(const ViewPlace&, const ViewPlace&) = default;
};

// The photographed workshop, beside the rig: while it has a background to show, the camera stands where that
// was taken. To another it is cut as soon as its picture is ready, which then fades in.
struct PhotographedRoom {
    std::shared_ptr<const Workshop> workshop;
    View view = View::kThrowing;
    Framing framing{};
    bool jumps = false;  // with the next frame it is where it is wanted
    std::map<std::string, std::shared_ptr<const render::Background>> backgrounds{};  // by their camera's name
    bool moves_less = false;          // who looks on asked for less motion: nothing fades
    bool sways = false;               // while nobody throws: a little to either side, slowly
    std::string camera{};             // whose background is shown
    Framing framed_so{};              // and how
    std::optional<ViewPlace> next{};  // where it will be cut to
    bool next_is_ready = false;       // the picture there is made; said once a frame
    double fade_left_s = 0.0;         // until the view it was cut to is all that is seen
    int width_px = 0;                 // of the picture they were framed for
    int height_px = 0;
    Settling sway_fraction{};  // 0 to 1
    double sway_s = 0.0;       // how long it has swayed
};

// The time of day: 0 the daylight in which one works, 1 the evening in which one looks at what one has made.
struct TimeOfDay {
    double evening = 0.0;  // the goal
    Settling now{};
};

// One far light, and the light from everywhere else.
struct KeyLight {
    render::DirectionalLight light;
};
struct Surroundings {
    render::Environment environment;
    std::optional<std::array<vec3, 9>> irradiance;  // where it is known better than the environment says
    render::Backdrop backdrop;
};

// A part of what stands still about the wheel.
struct StillPart {
    std::shared_ptr<const render::Mesh> mesh{};
    render::Material material{};
    bool casts_shadow = true;
};

}  // namespace onggi::wheel
