// What the entities of the wheel's scene are made of. Plain data; main thread. mm, rad, linear light.
#pragma once

#include <vector>

#include "engine/math/math.h"
#include "engine/render/scene.h"

namespace onggi::wheel {

// Where an entity is.
struct Transform {
    dvec3 position_mm{0.0};
};

// The turning wheel head. The clay turns with it.
struct Wheel {
    dvec2 direction{1.0, 0.0};  // (cos, sin) of the angle turned, counter-clockwise from above
    bool turning = false;
};

// The clay as the picture knows it. The radii are the picture's own copy: a snapshot may be overwritten while
// the frame is put together.
struct Clay {
    std::vector<float> radii_mm{};  // bottom first
    double height_mm = 200.0;
    render::LatheMaterial material{};
    float edge_rounding_mm = 0.0F;
};

// The hand's tool.
struct Tool {
    double radius_mm = 10.0;
    bool shown = true;
    bool touching = false;
    render::Material material{};
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

// One far light, and the light from everywhere else.
struct KeyLight {
    render::DirectionalLight light;
};
struct Surroundings {
    render::Environment environment;
    render::Backdrop backdrop;
};

// A part of what stands still about the wheel.
struct StillPart {
    std::shared_ptr<const render::Mesh> mesh{};
    render::Material material{};
    bool casts_shadow = true;
};

}  // namespace onggi::wheel
