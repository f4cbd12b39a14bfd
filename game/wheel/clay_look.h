// What clay looks like: bodies from wet to glazed, as materials. Any thread; pure functions. Linear light.
#pragma once

#include "engine/render/scene.h"
#include "game/clay/studio/pot.h"

namespace onggi::wheel {

// The body at its stage. Wet: with the water and the film it has where a snapshot does not say.
[[nodiscard]] render::LatheMaterial clay_material(clay::ClayBody body, clay::Firing stage);

// How dark water makes clay of that liquidity index, 0 dry to 1: leather-hard clay at the plastic limit is
// still damp.
[[nodiscard]] float darkness_of(float liquidity);

// Of a wall that has been cut: fresh clay, paler than its skin.
[[nodiscard]] vec3 section_colour(const render::LatheMaterial& material);

}  // namespace onggi::wheel
