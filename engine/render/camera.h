// Where the picture is taken from, and the way back from a pixel into the world. Any thread; plain functions.
// mm and rad; pixels count from the top left corner, y down.
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
    vec2 shift{0.0F};  // of the whole picture, in halves of it: fractions of a pixel, for a mean of many
    // Where the way the camera looks meets the picture, in halves of it from its middle, x right and y down:
    // a lens that is shifted, as an architect's. It moves everything on the picture and tilts nothing.
    vec2 lens_shift{0.0F};

    friend bool operator==(const Camera&, const Camera&) = default;
};

// World to Vulkan clip space: y down, depth 0 at near and 1 at far.
[[nodiscard]] mat4 view_projection(const Camera& camera, int width_px, int height_px);

struct Ray {
    dvec3 origin_mm;
    dvec3 direction;  // unit length
};

// The ray from the eye through a point of the picture, in pixels (0.5, 0.5 is the centre of the first).
[[nodiscard]] Ray ray_through(const Camera& camera, int width_px, int height_px, dvec2 pixel);

// Where the ray meets the vertical plane that holds the axis x = z = 0 and faces the eye; nothing if it runs
// along that plane or meets it behind the eye.
[[nodiscard]] std::optional<dvec3> meet_axis_plane(const Ray& ray, const Camera& camera);

// A world point in pixels and its depth along the view in mm; nothing if it is not in front of the eye.
struct Projected {
    dvec2 pixel;
    double depth_mm;
};
[[nodiscard]] std::optional<Projected> project(const Camera& camera, int width_px, int height_px,
                                               dvec3 point_mm);

// The camera of a picture that shows the middle of a background: the background is scaled until it fills the
// picture both ways, and what is too much of it is cut off.
[[nodiscard]] Camera background_camera(const Camera& of_background, int background_width_px,
                                       int background_height_px, int width_px, int height_px);

// pixel * xy + zw of a picture is the place in the background, 0 to 1 from its top left corner. `shown`
// stands where the background was taken and looks the same way; it may be narrower or wider than
// background_camera()'s, and shifted.
[[nodiscard]] vec4 background_window(const Camera& of_background, int background_width_px,
                                     int background_height_px, const Camera& shown, int width_px,
                                     int height_px);
// The camera nearer by that factor, as a zoom lens is.
[[nodiscard]] Camera zoomed(const Camera& camera, double factor);

// How many pixels one mm spans at the camera's target.
[[nodiscard]] double pixels_per_mm(const Camera& camera, int height_px);

}  // namespace onggi::render
