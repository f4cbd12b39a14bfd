// What a pot was drawn on with, and how much of it, so that a glaze can be said to hide it. Any thread; pure.
#pragma once

#include <array>
#include <cstdint>

#include "game/decoration/stroke.h"
#include "game/decoration/texture.h"
#include "game/finish/glaze.h"

namespace onggi::finish {

struct DrawnWith {
    // Texels that are mostly that pigment, by decoration::Pigment.
    std::array<std::uint32_t, decoration::kPigmentCount> pigment{};
    std::uint32_t wiped = 0;  // where fingers went through the coat
    bool inlaid = false;      // some of the slip by a cut line

    [[nodiscard]] bool nothing() const;
    friend bool operator==(const DrawnWith&, const DrawnWith&) = default;
};
[[nodiscard]] DrawnWith drawn_with(const decoration::Texture& texture, const decoration::Strokes& strokes);

// Hardly a tenth of what was drawn is to be told from this glaze where there is none of it. What fingers left
// is a groove as well and is always seen.
[[nodiscard]] bool hides(const GlazeMaterial& glaze, const DrawnWith& drawn);

}  // namespace onggi::finish
