// What a place of a pot looks like that was drawn on: the colour of the marks under its glaze, and how their
// relief leans it. Any thread; pure. Linear light.
#pragma once

#include "engine/math/math.h"
#include "game/decoration/texture.h"
#include "game/decoration/wall.h"
#include "game/finish/glaze.h"

namespace onggi::finish {

// What that pigment looks like; of none, iron's.
[[nodiscard]] vec3 pigment_colour(const MarkPalette& palette, decoration::Pigment pigment);

// A colour, and how far it hides what the place would be without it.
struct MarkColour {
    vec3 colour{0.0F};
    float cover = 0.0F;
};
[[nodiscard]] MarkColour mark_colour(const MarkPalette& palette, const decoration::Texel& texel);

// The place's own colour with the mark on it.
[[nodiscard]] inline vec3 marked(const vec3& own, const MarkColour& mark) {
    return glm::mix(own, mark.colour, mark.cover);
}

// How the relief leans the normal there, as slopes: the way turns grow, and up the wall.
[[nodiscard]] vec2 relief_lean(const decoration::Texture& texture, const decoration::Wall& wall, int column,
                               int row);

}  // namespace onggi::finish
