// What a stroke leaves on a texel that it covers so far. Any thread; pure.
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

// `under`: before the stroke. cover: of StrokeMask.
[[nodiscard]] Texel inked(const Texel& under, Ink ink, std::uint8_t cover, int column, int row);

// The coat that is laid before fingers go through it, where there is none.
[[nodiscard]] Texel coated(const Texel& under, int column, int row);

}  // namespace onggi::decoration
