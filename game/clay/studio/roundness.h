// Deviations from the round: rings off the centre, and sectors off the ring. A turning wheel under a steady
// hand reduces both; on a standing wheel a finger makes dents. Haptic thread; no allocation. Units: mm, s.
#pragma once

#include "game/clay/studio/contact.h"

namespace onggi::clay::studio {

// Rows smoother than this count as round.
constexpr float kSmoothMm = 1e-3F;
constexpr double kLargestResidualMm = 8.0;

// Rings in contact follow the hand's first harmonic: c -= fraction (c - B). fraction is 1 - exp(-dt/tau_c).
void centre_rings(Rings& rings, const Contact& contact, const Hand& hand, double fraction,
                  double yield_mm) noexcept;

// A row is rounded once a millisecond, in which no wheel turns farther than a sector and a half. At a faster
// rate the rings take turns in stripes, and a step of a stripe counts for all its ticks. A power of two.
constexpr int kMostStripes = 8;
constexpr int stripes_at(double rate_hz) {
    int stripes = 1;
    while (stripes < kMostStripes && 2 * stripes * 1000.0 <= rate_hz)
        stripes *= 2;
    return stripes;
}

// Wheel turning: the residuals within eight sectors of the hand decay, weighted by a raised cosine, in this
// tick's stripe of the rings.
void round_sectors(Rings& rings, const Contact& contact, const Hand& hand, int stripe,
                   const StudioParameters& parameters) noexcept;

// Wheel standing: the sectors under the hand yield to it. fraction is 1 - exp(-dt/tau).
void dent_sectors(Rings& rings, const Contact& contact, const Hand& hand, double fraction,
                  double yield_mm) noexcept;

// Moves the mean of ring i's row into its radii, so that the row holds no volume, and updates its roughness.
// Returns true if radii and height changed.
bool tend_row(Rings& rings, int i) noexcept;

}  // namespace onggi::clay::studio
