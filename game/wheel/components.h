// Components of the wheel scene's entities. Plain data; main thread. mm, rad, linear light.
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
#include "game/tool/tool.h"
#include "game/wheel/shavings.h"
#include "game/wheel/tool_models.h"
#include "game/wheel/tool_pose.h"
#include "game/wheel/workshop_files.h"

namespace onggi::wheel {

// A number that moves to a goal: a critically damped spring, which never overshoots.
struct Settling {
    double value = 0.0;
    double speed = 0.0;  // per second

    friend bool operator==(const Settling&, const Settling&) = default;
};
// The value after dt_s seconds; exact for any step. After 5 / rate_per_s about 96 % of the way is done.
[[nodiscard]] inline Settling settled(const Settling& now, double goal, double rate_per_s, double dt_s) {
    // x'' = -2 r x' - r^2 x about the goal, solved: (x0 + (v0 + r x0) t) exp(-r t).
    const double away = now.value - goal;
    const double push = now.speed + rate_per_s * away;
    const double decay = std::exp(-rate_per_s * dt_s);
    return {.value = goal + (away + push * dt_s) * decay,
            .speed = (now.speed - rate_per_s * push * dt_s) * decay};
}

// Position of an entity.
struct Transform {
    dvec3 position_mm{0.0};
};

// The appearance of the pot on the wheel, the loop's clay or another pot.
struct Clay {
    bool shows_load = false;
    bool is_cut_open = false;  // towards the camera
    float edge_rounding_mm = 0.0F;
    // Of each ring in the last frame: how much water darkens it, and how much its film of water gleams.
    std::vector<float> wetness{};
    std::vector<float> film{};
};

// A pot other than the haptic loop's clay: set aside, dried, fired or turned over. Its pointers must stay
// valid until the component is replaced or removed.
struct PotApart {
    const pot::Pot* pot = nullptr;
    const render::LatheMaterial* material = nullptr;  // null: from its body and stage
    const render::LatheMarks* marks = nullptr;        // on its outside, or null
};
// The pot stands on the wheel and replaces the loop's clay there.
struct OnWheel {
    std::optional<dvec2> direction{};  // (cos, sin) of the rotation; empty: rotates with the wheel
};
// The pot is held upside down over the rim of the loop's clay, shifted in the clay's frame.
struct HeldOver {
    vec2 shift_mm{0.0F};
};

// One of the two hands, drawn as the contact ball or as hand and tool.
struct Hand {
    bool is_second = false;
    bool is_away = false;  // not drawn, whatever the loop's position
    dvec2 tilt_rad{0.0};   // of a pen
    ToolPose pose{};
};
// The program moves this hand, and the haptic loop does not.
struct Led {
    DrawnHand hand{};
};

// A trimmer's shavings: they fall from the cut and stay until the trimming ends.
struct Shaved {
    double shaved_mm3 = 0.0;  // since the trimmer was picked up
    dvec3 from_mm{0.0};
    Shavings shavings{};
};

// Drops of slip that wet hands throw off.
struct Splashed {
    Splash splash{};
};

// A tool with a place on the bench.
struct BenchTool {
    tool::Tool tool = tool::Tool::kRib;
    ToolModel model = ToolModel::kRib;
    vec2 target_u{0.0F};          // width and height that a finger can touch, in units of the screens
    bool is_photographed = true;  // false: it is drawn while it lies there
    bool lies_there = true;
    double yaw_rad = 0.0;  // as in placed()
    double lean_rad = 0.0;
};

// The wire that cuts off the pot or its rim. While it is held ready at a height, it hides the hands at its
// ends; otherwise it is drawn while the haptic loop cuts.
struct Wire {
    std::optional<double> held_mm{};
};

// Models of the tools; see load_tool_models(). With only the ball, all tools are drawn as balls.
struct ToolShelf {
    std::shared_ptr<const render::PropLibrary> library;

    [[nodiscard]] bool has_tools() const { return library->size() > 1; }
};

// Frames the wheel so that `height_mm` fill the picture's height or `width_mm` its width, whichever shows
// more.
struct CameraRig {
    dvec3 target_mm{0.0};
    double distance_mm = 900.0;
    double elevation_rad = 0.25;
    double azimuth_rad = 0.0;  // 0 looks along -Z
    double height_mm = 350.0;
    double width_mm = 330.0;
};

// The camera of a background, and the shown part of the background.
struct ViewPlace {
    std::string camera;
    Framing framing{};

    friend bool operator==(const ViewPlace&, const ViewPlace&) = default;
};

// The photographed workshop. While there is a background, the camera is the background's and not the rig's.
// The camera cuts to another view as soon as that picture is ready, and fades it in.
struct PhotographedRoom {
    std::shared_ptr<const Workshop> workshop;
    View view = View::kThrowing;
    Framing framing{};
    bool jumps = false;  // cuts to the wanted view in the next frame
    std::map<std::string, std::shared_ptr<const render::Background>> backgrounds{};  // by camera name
    bool moves_less = false;          // the visitor prefers less motion: nothing fades
    bool sways = false;               // sways slowly from side to side while the wheel is idle
    std::string camera{};             // camera of the shown background
    Framing framed_so{};              // framing of the shown background
    std::optional<ViewPlace> next{};  // the next view to cut to
    bool next_is_ready = false;       // the picture of the next view is ready; reset each frame
    double fade_left_s = 0.0;         // time left in the fade to the current view
    int width_px = 0;                 // picture size that the views were framed for
    int height_px = 0;
    Settling sway_fraction{};  // 0 to 1
    double sway_s = 0.0;       // time since the swaying began
};

// Time of day: 0 daylight for work, 1 evening for looking at the finished pot.
struct TimeOfDay {
    double evening = 0.0;  // the goal
    Settling now{};
};

// One distant light, and the light from all other directions.
struct KeyLight {
    render::DirectionalLight light;
};
struct Surroundings {
    render::Environment environment;
    std::optional<std::array<vec3, 9>> irradiance;  // if known more precisely than from the environment
    render::Backdrop backdrop;
};

// A part of the still life around the wheel.
struct StillPart {
    std::shared_ptr<const render::Mesh> mesh{};
    render::Material material{};
    bool casts_shadow = true;
};

}  // namespace onggi::wheel
