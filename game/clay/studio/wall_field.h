// A push on an unsupported wall moves the wall, not only the clay under the finger: one smooth field a hand,
// with compact support, so that clay beyond it keeps its bits. Haptic thread; no allocation.
#pragma once

#include "game/clay/studio/moves.h"

namespace onggi::clay::studio {

// Moves the hollow rings within L = beta sqrt(R t) of the push that contact.field describes.
//
//   u      how far the wall moves at the middle of the push: fraction times the largest x phi
//   y*     that middle, the mean of y weighted with (x phi)^2 h
//   g(s)   (1 - s^2)^2 with s = (y - y*)/L
//   R      mean radius; R' = R + d with d = u g min(1, phi/phi(y*))
//   chi    of the hoop strain d/R, goes into thickness; the rest into height
//   T      slope dR/dy; turning the wall keeps its length along the slope: h' carries
//          sqrt((1 + T^2)/(1 + (T + dT)^2)), dT = u g'/L
//
// Everything is linear in u, which is a few hundredths of a millimetre a tick.
Changed move_wall(Rings& rings, Contact& contact, const Hand& hand, double fraction, double dt_s,
                  const StudioParameters& parameters) noexcept;

// dR/dy at ring i over six rings to either side of the same kind (solid or hollow), clamped to +-3.
double wall_slope(const Rings& rings, int i) noexcept;
// The same for hollow rings; those of a range that has six rings more on either side, all above the floor.
// Solid rings get 0 or any slope. centre_mm[i]: of ring i, for all of these rings.
void slopes_between(const Rings& rings, Rings::Range range, const double* centre_mm, double* out) noexcept;

}  // namespace onggi::clay::studio
