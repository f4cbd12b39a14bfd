// The pictures (textures) of an exported pot: its look baked onto its unwrapped solid; exporter/pot_solid.h
// describes the texture coordinates. Any thread but the haptic one; pure: the same pot leads to the same
// bytes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_clay.h"
#include "game/decoration/canvas.h"
#include "game/exporter/export.h"
#include "game/exporter/pot_rings.h"
#include "game/exporter/pot_solid.h"
#include "game/finish/glaze.h"

namespace onggi::look {

// A pot's look at each place of its surface, for exported pictures. There are two looks: the turned clay as
// on the wheel (shaders/lathe.h), and the glaze as on the kiosk's cards (finish/glaze_surface.h). Any thread
// but the haptic one; pure. mm, rad; linear light.
struct Place {
    float height_mm = 0.0F;
    // Along the outline, from the foot up the outside, over the rim and down the inside.
    float along_mm = 0.0F;
    bool inside = false;
};

struct Surface {
    vec3 colour{0.5F};
    float roughness = 0.6F;
    float coat = 0.0F;        // layer of water or glass, 0 to 1
    float lean_round = 0.0F;  // slope of the normal, in the direction of growing angle
    float lean_up = 0.0F;     // slope of the normal, upwards
};

struct PotLook {
    std::string name;
    float coat_roughness = 0.1F;
    // Fills in the surfaces of a row of the pictures, one a column.
    std::function<void(const Place& row, std::span<Surface> round)> at;
};

// With streaks of fingers, and water if the material holds some.
[[nodiscard]] PotLook lathe_look(const render::LatheMaterial& material, std::string name);
// For a pot of that height.
[[nodiscard]] PotLook glaze_look(const finish::GlazeMaterial& glaze, float height_mm);
// The look with marks on the outside, under a glaze.
[[nodiscard]] PotLook marked_look(PotLook look, const decoration::Marks& marks,
                                  const finish::MarkPalette& palette, float height_mm);

constexpr int kPictureSide = 1024;  // a power of two, for mipmaps

struct PotPictures {
    asset::Image base_colour;  // sRGB
    asset::Image normal;       // tangent space: red round the pot, green up the pictures, blue out
    asset::Image surface;      // red: ambient visibility, green: roughness, blue: metal
    asset::Image coat;         // red: amount of water or glass
    bool is_coated = false;
};

// `rows` are the solid's, at the rings' size times `shrinkage`.
[[nodiscard]] PotPictures bake(const std::vector<exporter::PictureRow>& rows, const exporter::PotRings& rings,
                               double shrinkage, const PotLook& look);

// The pot with its look and its story, at the size of its stage, for GLB and USDZ. kBadInput: see
// build_pot_solid().
[[nodiscard]] Result<exporter::PotFile> dressed_pot(const clay::StudioClay& clay, clay::Firing stage,
                                                    const PotLook& look, exporter::PotStory story = {});
// The same as a GLB.
[[nodiscard]] Result<std::vector<std::byte>> dressed_glb(const clay::StudioClay& clay, clay::Firing stage,
                                                         const PotLook& look, exporter::PotStory story = {});

}  // namespace onggi::look
