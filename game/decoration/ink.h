// The effect of a stroke on a texel that it covers to some degree. Any thread; pure.
#pragma once

#include <cstdint>

#include "game/decoration/stroke.h"
#include "game/decoration/stroke_mask.h"
#include "game/decoration/texture.h"

namespace onggi::decoration {

enum class Ink { kWipe, kIron, kCobalt, kWhiteInlay, kBlackInlay, kBrushedSlip };

[[nodiscard]] Ink ink_of(Technique technique, Slip slip);
[[nodiscard]] inline Tip tip_of(Ink ink) {
    return ink == Ink::kWipe ? Tip::kFinger : Tip::kBrush;
}

// `under`: the texel before the stroke. cover: from StrokeMask.
[[nodiscard]] Texel inked(const Texel& under, Ink ink, std::uint8_t cover, int column, int row);

// Adds the coat that fingers wipe through, unless there is one.
[[nodiscard]] Texel coated(const Texel& under, int column, int row);

}  // namespace onggi::decoration
