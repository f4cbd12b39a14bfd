// The lump a pot is thrown from: a low dome, a little off centre. Units: g, mm.
#pragma once

#include "game/clay/studio/rings.h"

namespace onggi::clay {

// The clay body; it sets the linear shrinkage from wet to glaze-fired.
enum class ClayBody { kStoneware, kPorcelain, kEarthenware };

constexpr double kLeastLumpG = 100.0;
constexpr double kLargestLumpG = 5000.0;
constexpr int kFewestRings = 200;
constexpr int kMostRings = 4000;

struct StudioLump {
    double mass_g = 1000.0;  // 100 to 5000
    ClayBody body = ClayBody::kStoneware;
    double liquidity_index = 0.6;  // 0 plastic limit, 1 liquid limit; 0 to 1.2
    int rings = 2000;              // N, nominal for a pot of 200 mm; 200 to 4000
    int sectors = 256;             // S, a power of two from 16 to 256
    double off_centre_mm = 2.0;    // 0 to 5
};

namespace studio {

// Replaces the rings by a fresh lump. Precondition: the lump is within its limits and the rings have its
// capacity and sectors. No allocation.
void put_lump(Rings& rings, Ledger& ledger, const StudioLump& lump);

// The ring capacity that a lump needs.
int ring_capacity(const StudioLump& lump);

}  // namespace studio
}  // namespace onggi::clay
