// A studio pot as the closed solid that is shared: outer wall, rim, inner wall, floor and foot. Any thread
// but the haptic one.
#pragma once

#include "engine/asset/mesh.h"
#include "engine/core/result.h"
#include "game/share/pot_faces.h"

namespace onggi::share {

// Metres, +Y up, base at y = 0, the wheel's axis at x = z = 0, the clay's direction 0 along +X. Closed by
// position, outward, vertices twice only where the surface has an edge. A vessel is one part with V - E + F =
// 2; clay without a floor is a tube, 0; a hollow that clay has closed over is a part of its own, inside.
//
// The clay's volume is kept as in pot_mesh.h: thinning and corners move a wall by micrometres, and one factor
// near 1 on everything across the axis gives the mesh exactly the volume that the rings own.
struct PotSolid {
    asset::Mesh mesh;
    int corners = 0;
    double tolerance_mm = 0.0;  // how far thinning may have moved a face; 0: rows were left out instead
    double across_scale = 1.0;  // that factor, before shrinkage
    std::size_t rows = 0;
};

// The finest of seven settings that stays within kMaxTriangles of pot_mesh.h and cannot push one face of a
// wall through the other: from 0.008 mm and 128 corners, which calm pots get, to 0.5 mm and 48. What is too
// rough for all has rows left out evenly. shrinkage: what every length is times (pot.h). kBadInput if there
// is less than a millimetre of clay, or if its rings are no numbers. The same clay gives the same bits on
// every machine.
Result<PotSolid> build_pot_solid(const clay::studio::Rings& rings, double shrinkage = 1.0);

}  // namespace onggi::share
