// The shadow mask's region of the world, and the pixels where moving things can be seen. Any thread; pure
// functions. mm, pixels.
#pragma once

#include <span>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// The mask covers a rectangle of y = 0. It begins behind the axis, as seen from the light, and extends along
// the light to the end of the tallest caster's shadow.
struct MaskPlacement {
    vec4 u;  // dot(xyz, p) + w: mask coordinate of p projected along the light onto y = 0
    vec4 v;
    vec2 origin;  // xz of u = v = 0
    vec2 axis_u;  // xz
    vec2 axis_v;
};
[[nodiscard]] MaskPlacement place_mask(const ShadowRegion& region, const DirectionalLight& light);

// The pixels in which the boxes can be seen, with a margin of one pixel.
[[nodiscard]] PixelRect pixels_of(std::span<const Box> boxes, const Camera& camera, int width_px,
                                  int height_px);

// Bounding boxes of moving things: the lathe; a sphere; all spheres and props.
[[nodiscard]] Box lathe_box(const Lathe& lathe);
[[nodiscard]] Box sphere_box(const Sphere& sphere);
[[nodiscard]] std::vector<Box> boxes_beside_lathe(const Scene& scene);

}  // namespace onggi::render
