// Traditional motifs as ready-made strokes, our own drawing, in a box of 100 units. Constant.
#pragma once

#include <span>
#include <vector>

#include "game/decoration/ink.h"
#include "game/decoration/stroke.h"

namespace onggi::decoration {

struct MotifPoint {
    float x = 0.0F;     // -50 to 50, counter-clockwise round the pot: to the right for the viewer
    float y = 0.0F;     // -50 to 50, up
    float half = 1.0F;  // half width of the brush there
};

struct MotifLine {
    Ink ink = Ink::kIron;
    std::vector<MotifPoint> points;  // joined by a smooth line
};

// The lines in drawing order; empty for Motif::kNone.
[[nodiscard]] std::span<const MotifLine> lines_of(Motif motif);

}  // namespace onggi::decoration
