// The shape of what a plate shows, so that the camera can move a little and the plate bend along. Any thread;
// pure functions. mm.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/scene.h"

namespace onggi::render {

struct ReliefMesh {
    std::vector<vec3> positions_mm;
    std::vector<std::uint32_t> indices;
};

// A sheet over everything the plate's camera sees, each corner of the relief's grid as far away as it says; a
// plate without a relief is a flat picture at twice the distance of the camera's target. Round it goes a
// margin as wide as half the plate, for what comes into the picture from outside the plate.
[[nodiscard]] ReliefMesh relief_mesh(const Plate& plate);

}  // namespace onggi::render
