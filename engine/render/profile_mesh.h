// Static meshes of revolution, made from outlines when the program loads. Any thread; pure functions. mm.
#pragma once

#include <span>
#include <vector>

#include "engine/render/scene.h"

namespace onggi::render {

// An outline in the half plane (r, y). The solid lies on the left of its direction: up the outside, over the
// top, inwards to the axis (or down the inside of a bowl).
struct Profile {
    std::vector<vec2> points;  // (r, y), r >= 0
};

// Revolves the outline about +Y. Corners sharper than 35 degrees stay sharp; the rest is smooth.
[[nodiscard]] Mesh turned_mesh(const Profile& profile, int sectors);

// A sphere of radius 1 about the origin.
[[nodiscard]] Mesh sphere_mesh(int rows, int sectors);

// Appends the corner between `before` and `after`, rounded: steps + 1 points, in order.
void add_rounded(Profile& profile, vec2 before, vec2 corner, vec2 after, float radius_mm, int steps = 6);

// Sets open_sky of turned meshes that stand together: casts cosine-distributed rays from each outline point
// against all profiles. The order of points and vertices is that of turned_mesh().
void set_open_sky(std::span<const Profile> profiles, std::span<Mesh> meshes, int sectors);

}  // namespace onggi::render
