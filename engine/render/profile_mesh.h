// Meshes of things that stand still, made from outlines when the program loads. Any thread; pure functions.
// mm.
#pragma once

#include <span>
#include <vector>

#include "engine/render/scene.h"

namespace onggi::render {

// An outline in the half plane (r, y), walked so that the solid lies on its left hand: up the outside, over
// the top, in to the axis (or down the inside of a bowl).
struct Profile {
    std::vector<vec2> points;  // (r, y), r >= 0
};

// Turned about +Y. Corners sharper than 35 degrees stay corners, the rest is smooth.
[[nodiscard]] Mesh turned_mesh(const Profile& profile, int sectors);

// Radius 1 about the origin.
[[nodiscard]] Mesh sphere_mesh(int rows, int sectors);

// Rounds the corner at `corner` between `before` and `after`, steps + 1 points in their order.
void add_rounded(Profile& profile, vec2 before, vec2 corner, vec2 after, float radius_mm, int steps = 6);

// Sets the open_sky of turned meshes that stand together, by casting cosine-distributed rays from each of
// their outline's points at all of their profiles. Points and vertices in turned_mesh's order.
void set_open_sky(std::span<const Profile> profiles, std::span<Mesh> meshes, int sectors);

}  // namespace onggi::render
