// A pot's outline turned about the axis: the closed solid that is shared. Any thread but the haptic one.
#pragma once

#include "engine/asset/mesh.h"
#include "game/share/export.h"
#include "game/share/pot_profile.h"

namespace onggi::share {

// Neighbouring pieces of the outline that turn more than this meet in an edge: cos 20 degrees. A line thinned
// to the finest setting turns by 15 degrees a corner where a tool of 2 mm has pressed, so all that is round
// stays smooth.
constexpr double kCreaseCosine = 0.9396926207859084;

// Phones turn a model of this size smoothly, and it stays below 1 MB on the wire.
constexpr std::size_t kMaxTriangles = 50000;

// Metres, +Y up, base at y = 0, axis at x = z = 0. Closed by position: each edge is shared by two triangles
// that run it in opposite directions. Vertices stand twice only where the surface has an edge.
//
// Two approximations, and what keeps the clay's volume in spite of them: the outline is thinned
// (pot_profile.h), and a circle of radius R becomes a regular polygon of n corners, whose area is
// n/2 sin(2 pi/n) R^2 and so too small. All radii are scaled by one factor near 1 that gives the polygons of
// the thinned outline exactly the clay's volume. With 128 corners it is 1.0002: at R = 60 mm corners lie 12
// um outside the circle and the middles of edges 6 um inside.
struct PotMesh {
    asset::Mesh mesh;
    Profile profile;            // the rings that were built, radii scaled
    int sectors = 0;            // corners of each ring
    double tolerance_mm = 0.0;  // how far thinning may have moved a radius
    std::size_t elements = 0;   // that the outline was taken from; fewer than the pot's if it is too rough
    double radius_scale = 1.0;
};

// The finest of four settings that stays within kMaxTriangles: from 0.008 mm and 128 corners, which smooth
// pots get, to 0.064 mm and 48. What is too rough for all four (thousands of ledges, as no hand makes them)
// is blurred: its elements are merged, each keeping its clay, until the last setting fits. Precondition:
// check_shape. The same shape gives the same bits on every machine: no libm trigonometry.
PotMesh build_pot_mesh(const PotShape& shape);

// n unit vectors (cos, sin) at 2 pi k/n, from halved angles and exact square roots. n = 2^a or 3 x 2^a, a
// >= 2.
std::vector<dvec2> unit_circle(int n);

}  // namespace onggi::share
