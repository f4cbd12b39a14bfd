// The pictures that a pot wears when it leaves: its look baked onto its unwrapped solid (exporter/pot_solid.h
// says how that lies in them). Any thread but the haptic one; pure: the same pot gives the same bytes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "game/decoration/canvas.h"
#include "game/exporter/export.h"
#include "game/exporter/pot_rings.h"
#include "game/exporter/pot_solid.h"
#include "game/finish/glaze.h"

namespace onggi::look {

// What a pot looks like at each place of its surface, for pictures that leave with it. Two looks: the turned
// clay as the wheel shows it (shaders/lathe.h), and the glaze as the kiosk's cards show it
// (finish/glaze_surface.h). Any thread but the haptic one; pure. mm, rad; linear light.
struct Place {
    float height_mm = 0.0F;
    float along_mm = 0.0F;  // of the outline, from the foot up the outside, over the rim and down inside
    float angle = 0.0F;     // from the clay's direction 0, counter-clockwise seen from above
    bool inside = false;
};

struct Surface {
    vec3 colour{0.5F};
    float roughness = 0.6F;
    float coat = 0.0F;        // of water or glass over it, 0 to 1
    float lean_round = 0.0F;  // of the normal, as slopes: the way the angle grows
    float lean_up = 0.0F;     // and up
};

struct PotLook {
    std::string name;
    float coat_roughness = 0.1F;
    std::function<Surface(const Place&)> at;
};

// With the streaks of fingers, and water where the material holds some.
[[nodiscard]] PotLook lathe_look(const render::LatheMaterial& material, std::string name);
// On a pot of that height.
[[nodiscard]] PotLook glaze_look(const finish::GlazeMaterial& glaze, float height_mm);
// The same, drawn on outside: with those marks under a glaze.
[[nodiscard]] PotLook marked_look(PotLook look, const decoration::Marks& marks,
                                  const finish::MarkPalette& palette, float height_mm);

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
