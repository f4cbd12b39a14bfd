// A pot of rings of a millimetre each, for tests that need a pot without throwing.
#pragma once

#include <cmath>

#include "game/pot/pot.h"

namespace onggi::test {

// Solid to the floor, a bore above it; both faces wider by `lean` a millimetre of height. A kilogram is a
// lump 62 mm wide and 44 high.
inline pot::Pot millimetre_pot(double height_mm, double outer_mm, double floor_mm, double bore_mm,
                               double lean = 0.0) {
    pot::Pot pot;
    pot.height_mm = height_mm;
    pot.floor_mm = floor_mm;
    for (int ring = 0; ring < static_cast<int>(std::lround(height_mm)); ++ring) {
        pot.outer_mm.push_back(static_cast<float>(outer_mm + lean * ring));
        pot.inner_mm.push_back(ring < floor_mm ? 0.0F : static_cast<float>(bore_mm + lean * ring));
        pot.top_mm.push_back(static_cast<float>(ring + 1));
    }
    return pot;
}

}  // namespace onggi::test
