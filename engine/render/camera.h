// The camera: projection, and rays from a pixel into the world. Any thread; pure functions. mm and rad;
// pixels count from the top left corner, y down.
#pragma once

#include <optional>

#include "engine/math/math.h"

namespace onggi::render {

struct Camera {
    vec3 eye_mm{0.0F, 100.0F, 1000.0F};
    vec3 target_mm{0.0F};
    float vertical_fov_rad = 0.5F;
    float near_mm = 50.0F;
    float far_mm = 6000.0F;
    vec2 shift{0.0F};  // sub-pixel shift of the picture in half-picture units, to average many samples
    // Lens shift, as of an architectural lens: where the viewing axis meets the picture, in half-picture
    // units from the picture's middle, x right and y down. It moves the whole picture without tilting
    // verticals.
    vec2 lens_shift{0.0F};

    friend bool operator==(const Camera&, const Camera&) = default;
};

// World to Vulkan clip space: y down, depth 0 at near and 1 at far.
[[nodiscard]] mat4 view_projection(const Camera& camera, int width_px, int height_px);

struct Ray {
    dvec3 origin_mm;
    dvec3 direction;  // unit length
};

// Returns the ray from the eye through a point of the picture in pixels; (0.5, 0.5) is the centre of the
// first pixel.
[[nodiscard]] Ray ray_through(const Camera& camera, int width_px, int height_px, dvec2 pixel);

// Returns where the ray meets the vertical plane that contains the axis x = z = 0 and faces the eye. Empty if
// the ray is parallel to that plane or meets it behind the eye.
[[nodiscard]] std::optional<dvec3> meet_axis_plane(const Ray& ray, const Camera& camera);

// A projected world point: its pixel and its depth along the viewing axis. project() returns nothing for a
// point that is not in front of the eye.
struct Projected {
    dvec2 pixel;
    double depth_mm;
};
[[nodiscard]] std::optional<Projected> project(const Camera& camera, int width_px, int height_px,
                                               dvec3 point_mm);

// Returns the camera of a picture that shows the middle of a background. The background is scaled to cover
// the picture in both directions, and the excess is cropped.
[[nodiscard]] Camera background_camera(const Camera& of_background, int background_width_px,
                                       int background_height_px, int width_px, int height_px);

// Returns the transform from a picture's pixel to background coordinates (0 to 1 from the top left corner):
// pixel * xy + zw. `shown` has the position and direction of the background's camera; it may be narrower or
// wider than background_camera(), and have a lens shift.
[[nodiscard]] vec4 background_window(const Camera& of_background, int background_width_px,
                                     int background_height_px, const Camera& shown, int width_px,
                                     int height_px);
// Returns the camera zoomed in by `factor` by narrowing its field of view.
[[nodiscard]] Camera zoomed(const Camera& camera, double factor);

// Pixels per mm at the distance of the camera's target.
[[nodiscard]] double pixels_per_mm(const Camera& camera, int height_px);

}  // namespace onggi::render
