// Motifs of heritage for who cannot draw, as strokes of our own drawing in a box of 100 units. Constant.
#pragma once

#include <span>
#include <vector>

#include "game/decoration/ink.h"
#include "game/decoration/stroke.h"

namespace onggi::decoration {

struct MotifPoint {
    float x = 0.0F;     // -50 to 50, counter-clockwise round the pot: to the right for who looks at it
    float y = 0.0F;     // -50 to 50, up
    float half = 1.0F;  // width of the brush there, its half
};

struct MotifLine {
    Ink ink = Ink::kIron;
    std::vector<MotifPoint> points;  // a smooth line through them
};

// In the order in which they are laid; none for Motif::kNone.
[[nodiscard]] std::span<const MotifLine> lines_of(Motif motif);

}  // namespace onggi::decoration
