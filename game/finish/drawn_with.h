// Amounts of each pigment in a pot's drawing, to tell whether a glaze would hide it. Any thread; pure.
#pragma once

#include <array>
#include <cstdint>

#include "game/decoration/stroke.h"
#include "game/decoration/texture.h"
#include "game/finish/glaze.h"

namespace onggi::finish {

struct DrawnWith {
    // Number of texels that are mostly that pigment, by decoration::Pigment.
    std::array<std::uint32_t, decoration::kPigmentCount> pigment{};
    std::uint32_t wiped = 0;  // texels where fingers wiped through the coat
    bool inlaid = false;      // some of the slip is inlaid in a cut line

    [[nodiscard]] bool nothing() const;
    friend bool operator==(const DrawnWith&, const DrawnWith&) = default;
};
[[nodiscard]] DrawnWith drawn_with(const decoration::Texture& texture, const decoration::Strokes& strokes);

// Whether less than about a tenth of the drawing is visible against this glaze. Finger wipes are grooves as
// well, and always visible.
[[nodiscard]] bool hides(const GlazeMaterial& glaze, const DrawnWith& drawn);

}  // namespace onggi::finish
