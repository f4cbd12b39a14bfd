// Corners of a regular polygon, without libm's trigonometry, which differs from machine to machine. Any
// thread.
#pragma once

#include <vector>

#include "engine/math/math.h"

namespace onggi::pot {

// n unit vectors (cos, sin) at 2 pi k/n, from halved angles and exact square roots. n = 2^a or 3 x 2^a, a
// >= 2.
std::vector<dvec2> unit_circle(int n);

}  // namespace onggi::pot
