// The pictures that a pot wears when it leaves: its look baked onto its unwrapped solid (exporter/pot_solid.h
// says how that lies in them). Any thread but the haptic one; pure: the same pot gives the same bytes.
#pragma once

#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/exporter/export.h"
#include "game/exporter/pot_rings.h"
#include "game/exporter/pot_solid.h"
#include "game/look/pot_look.h"

namespace onggi::look {

constexpr int kPictureSide = 1024;  // a power of two, as mipmaps want it

struct PotPictures {
    asset::Image base_colour;  // sRGB
    asset::Image normal;       // tangent space: red round the pot, green up the pictures, blue out
    asset::Image surface;      // red: the sky it sees, green: roughness, blue: metal
    asset::Image coat;         // red: how much water or glass lies on it
    bool is_coated = false;
};

// `rows` are those of the solid, at a size that is the rings' times `shrinkage`.
[[nodiscard]] PotPictures bake(const std::vector<exporter::PictureRow>& rows, const exporter::PotRings& rings,
                               double shrinkage, const PotLook& look);

// The pot as a GLB that wears its look; extras as exporter::PotFile has them. kBadInput as build_pot_solid().
[[nodiscard]] Result<std::vector<std::byte>> dressed_glb(const exporter::PotRings& rings, const PotLook& look,
                                                         exporter::PotFile file);

}  // namespace onggi::look
