// The shape of what a background shows, so that the camera can move a little and the background bend along.
// Any thread; pure functions. mm.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/scene.h"

namespace onggi::render {

struct ReliefMesh {
    std::vector<vec3> positions_mm;
    std::vector<std::uint32_t> indices;
};

// A sheet over everything the background's camera sees, each corner of the relief's grid as far away as it
// says; a background without a relief is a flat picture at twice the distance of the camera's target. Round
// it goes a margin as wide as half the background, for what comes into the picture from outside the
// background.
[[nodiscard]] ReliefMesh relief_mesh(const Background& background);

}  // namespace onggi::render
