// Materials of clay bodies from wet to glazed. Any thread; pure functions. Linear light.
#pragma once

#include "engine/render/scene.h"
#include "game/clay/studio/pot.h"

namespace onggi::wheel {

// The body at its stage. Wet: with default water and film, for a pot without values of its own.
[[nodiscard]] render::LatheMaterial clay_material(clay::ClayBody body, clay::Firing stage);

// How much a film of water gleams, 0 (dry) to 1: half of the gleam comes with the first quarter of the water.
[[nodiscard]] float gloss_of(float film);

// How much water darkens clay, 0 (dry) to 1: the water in it, of that liquidity index (leather-hard clay at
// the plastic limit is still damp), and a film of water on it, 0 (dry) to 1.
[[nodiscard]] float darkness_of(float liquidity, float film);

// Colour of a cut wall: fresh clay, paler than its surface.
[[nodiscard]] vec3 section_colour(const render::LatheMaterial& material);

}  // namespace onggi::wheel
