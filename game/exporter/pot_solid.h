// A pot as the closed solid that is shared: outer wall and rim, inner wall and floor where it has an inside,
// and foot. Any thread but the haptic one.
#pragma once

#include "engine/asset/mesh.h"
#include "engine/core/result.h"
#include "game/exporter/pot_faces.h"

namespace onggi::exporter {

constexpr std::size_t kMaxTriangles = 50000;        // of what is printed
constexpr std::size_t kMaxSharedTriangles = 30000;  // of what is looked at, on a phone, under pictures

// A row of the pictures that a pot wears (pot_pictures.h): all that is the same the whole way round.
struct PictureRow {
    double v = 0.0;  // where it lies in them, 0 top to 1 bottom
    double radius_mm = 0.0;
    double y_mm = 0.0;
    dvec2 normal{1.0, 0.0};  // of the mesh there, outwards and up
    bool inside = false;
};

struct SolidOptions {
    double shrinkage = 1.0;  // what every length is times (pot.h)
    std::size_t most_triangles = kMaxTriangles;
    // With places in pictures: u goes once round the pot from the clay's direction 0, counter-clockwise seen
    // from above; v from the middle of the floor (or of the top, where it is solid) up the inside, over the
    // rim and down the outside to the middle of the foot. Vertices then stand twice where u begins, and in
    // the middle of a disc once a corner.
    bool unwraps = false;
};

// Metres, +Y up, base at y = 0, the wheel's axis at x = z = 0, the clay's direction 0 along +X. Closed by
// position, outward: each edge is shared by two triangles that run it in opposite directions. Vertices stand
// twice only where the surface has an edge. A pot without an inside and a vessel are one part with V - E + F
// = 2; clay without a floor is a tube, 0; a hollow that clay has closed over is a part of its own, inside.
//
// Two approximations, and what keeps the clay's volume in spite of them: faces are thinned (pot_faces.h), and
// a circle of radius R becomes a regular polygon of n corners, whose area is n/2 sin(2 pi/n) R^2 and so too
// small. One factor near 1 on everything across the axis gives the mesh exactly the volume that the rings
// own. With 128 corners it is 1.0002: at R = 60 mm corners lie 12 um outside the circle and the middles of
// edges 6 um inside.
struct PotSolid {
    asset::Mesh mesh;
    int corners = 0;            // of each row
    double tolerance_mm = 0.0;  // how far thinning may have moved a face; 0: it was not thinned
    double across_scale = 1.0;  // that factor, before shrinkage
    std::size_t rows = 0;
    std::vector<PictureRow> picture_rows;  // top first; of an unwrapped one. Lengths as in the mesh
    int rings = 0;  // that the faces were taken from; fewer than the pot's if it is too rough
};

// The finest of seven settings that stays within the triangles asked for and cannot push one face of a wall
// through the other: from 0.008 mm and 128 corners, which smooth pots get, to 0.5 mm and 48. What is too
// rough for all (thousands of ledges, as no hand makes them) has rings left out evenly while the rest hold
// the same clay within a hundredth, or else merged, each keeping its clay, until it fits. kBadInput if
// check_rings() or if nothing of this helps. The same clay gives the same bits on every machine: no libm
// trigonometry.
Result<PotSolid> build_pot_solid(const PotRings& rings, const SolidOptions& options = {});

}  // namespace onggi::exporter
