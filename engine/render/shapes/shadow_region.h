// Where the moving things' shadow lies: the map from the world to the shadow mask; and where in the picture
// they are. Any thread; pure functions. mm, pixels.
#pragma once

#include <span>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// The mask covers a rectangle of y = 0 that begins behind the axis, seen from the light, and runs down the
// light as far as the tallest caster's shadow.
struct MaskPlacement {
    vec4 u;  // dot(xyz, p) + w: where p, slid along the light onto y = 0, lies in the mask
    vec4 v;
    vec2 origin;  // xz of u = v = 0
    vec2 axis_u;  // xz
    vec2 axis_v;
};
[[nodiscard]] MaskPlacement place_mask(const ShadowRegion& region, const DirectionalLight& light);

// All pixels in which boxes of the world can be seen, one more all round.
[[nodiscard]] PixelRect pixels_of(std::span<const Box> boxes, const Camera& camera, int width_px,
                                  int height_px);

// Boxes about what moves: the lathe; the spheres and the props.
[[nodiscard]] Box lathe_box(const Lathe& lathe);
[[nodiscard]] Box sphere_box(const Sphere& sphere);
[[nodiscard]] std::vector<Box> boxes_beside_lathe(const Scene& scene);

}  // namespace onggi::render
