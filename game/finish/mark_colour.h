// The look of a drawn-on place: the colour of the marks under its glaze, and the slope from their relief. Any
// thread; pure. Linear light.
#pragma once

#include "engine/math/math.h"
#include "game/decoration/texture.h"
#include "game/decoration/wall.h"
#include "game/finish/glaze.h"

namespace onggi::finish {

// The colour of that pigment; iron's for kNone.
[[nodiscard]] vec3 pigment_colour(const MarkPalette& palette, decoration::Pigment pigment);

// A colour, and its cover of the place's own colour.
struct MarkColour {
    vec3 colour{0.0F};
    float cover = 0.0F;
};
[[nodiscard]] MarkColour mark_colour(const MarkPalette& palette, const decoration::Texel& texel);

// The place's own colour with the mark blended in.
[[nodiscard]] inline vec3 marked(const vec3& own, const MarkColour& mark) {
    return glm::mix(own, mark.colour, mark.cover);
}

// Slopes of the normal from the relief: in the direction of growing turns, and up the wall.
[[nodiscard]] vec2 relief_lean(const decoration::Texture& texture, const decoration::Wall& wall, int column,
                               int row);

}  // namespace onggi::finish
