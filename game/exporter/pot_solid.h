// A pot as the closed solid to share: outer wall and rim, inner wall and floor if it has an inside, and foot.
// Any thread but the haptic one.
#pragma once

#include "engine/asset/mesh.h"
#include "engine/core/result.h"
#include "game/exporter/pot_faces.h"

namespace onggi::exporter {

constexpr std::size_t kMaxTriangles = 50000;        // for printing
constexpr std::size_t kMaxSharedTriangles = 20000;  // for viewing on a phone, with pictures
// No two rows of a glazed solid are nearer, in the file's mm: clients draw them as hairlines.
constexpr double kNearestGlazedRowsMm = 0.3;
constexpr double kGlazeRoundingMm = 1.2;  // from an edge to where its rounding begins

constexpr double kOutsideOfPictures = 2.0 / 3.0;  // visitors decorate the outside and look at it

// A row of the pot's pictures (pot_pictures.h): the values that are constant all the way round.
struct PictureRow {
    double v = 0.0;  // texture coordinate, 0 top to 1 bottom
    double radius_mm = 0.0;
    double y_mm = 0.0;
    dvec2 normal{1.0, 0.0};  // of the mesh there, (outwards, up)
    bool inside = false;
};

struct SolidOptions {
    double shrinkage = 1.0;  // factor on every length (pot.h)
    std::size_t most_triangles = kMaxTriangles;
    // Adds texture coordinates: u goes once round the pot from the clay's direction 0, counter-clockwise seen
    // from above; v from the middle of the floor (or of the top of solid clay) up the inside, over the rim
    // and down the outside to the middle of the foot, by length, but the outside takes kOutsideOfPictures at
    // least. Vertices are doubled where u begins, and repeated for each corner in the middle of a disc.
    bool unwraps = false;
    // Rounds the edges as a glaze does: shared normals, and rows at least kNearestGlazedRowsMm apart.
    bool is_glazed = false;
};

// Metres, +Y up, base at y = 0, the wheel's axis at x = z = 0, the clay's direction 0 along +X. Closed by
// position, normals outward: each edge is shared by two triangles that run it in opposite directions.
// Vertices are doubled only at edges of the surface, in a glazed solid only round a foot without floor. A pot
// without an inside and a vessel are one part with V
// - E + F = 2; clay without a floor is a tube, 0; a hollow that is closed over is a separate part inside.
//
// There are two approximations: faces are thinned (pot_faces.h), and a circle of radius R becomes a regular
// polygon of n corners, whose area n/2 sin(2 pi/n) R^2 is too small. One horizontal scale near 1 restores
// exactly the volume that the rings own. With 128 corners it is 1.0002: at R = 60 mm corners lie 12 um
// outside the circle and the middles of edges 6 um inside.
struct PotSolid {
    asset::Mesh mesh;
    int corners = 0;            // of each row
    double tolerance_mm = 0.0;  // largest error of thinning; 0: not thinned
    double across_scale = 1.0;  // the horizontal scale, before shrinkage
    std::size_t rows = 0;
    // The rows of its corners, wet size, before across_scale; the last walk goes up the outside and down the
    // inside.
    std::vector<pot::Walk> walks;
    std::vector<PictureRow> picture_rows;  // top first; only if unwrapped. Lengths as in the mesh
    int rings = 0;  // rings used for the faces; fewer than the pot's if it is too rough
};

// Uses the finest of seven settings that stays within the triangle budget and cannot push one face of a wall
// through the other: from 0.008 mm and 128 corners for smooth pots to 0.5 mm and 48. A pot too rough for all
// (thousands of ledges, more than a hand makes) gets evenly fewer rings while these hold the same clay within
// a hundredth, or else merged rings, each with its clay, until it fits. kBadInput if check_rings() fails or
// no setting fits. The same clay leads to the same bits on every machine: no libm trigonometry.
Result<PotSolid> build_pot_solid(const PotRings& rings, const SolidOptions& options = {});

}  // namespace onggi::exporter
