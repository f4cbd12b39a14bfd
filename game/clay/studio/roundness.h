// What is not round: rings off the centre, and sectors off the ring. A turning wheel under a steady hand
// undoes both; a standing one lets a finger dent. Haptic thread; no allocation. Units: mm, s.
#pragma once

#include "game/clay/studio/contact.h"

namespace onggi::clay::studio {

// Rows smoother than this count as round.
constexpr float kSmoothMm = 1e-3F;
constexpr double kLargestResidualMm = 8.0;

// Rings in contact follow the hand's own first harmonic: c -= fraction (c - B). fraction is 1 -
// exp(-dt/tau_c).
void centre_rings(Rings& rings, const Contact& contact, const HandState& state, double fraction,
                  double yield_mm) noexcept;

// A row is rounded once a millisecond, in which no wheel turns farther than a sector and a half: at a faster
// rate the rings take turns, each stripe of them standing for all its ticks. A power of two.
constexpr int kMostStripes = 8;
constexpr int stripes_at(double rate_hz) {
    int stripes = 1;
    while (stripes < kMostStripes && 2 * stripes * 1000.0 <= rate_hz)
        stripes *= 2;
    return stripes;
}

// Turning: the residuals within eight sectors of the hand decay, by a raised cosine, in this tick's stripe of
// the rings.
void round_sectors(Rings& rings, const Contact& contact, const Hand& hand, int stripe,
                   const StudioParameters& parameters) noexcept;

// Standing: the sectors under the hand give way to it. fraction is 1 - exp(-dt/tau).
void dent_sectors(Rings& rings, const Contact& contact, const Hand& hand, double fraction,
                  double yield_mm) noexcept;

// Moves the mean of ring i's row into its radii, so that the row moves no clay, and looks how rough the rest
// is. True if radii and height changed.
bool tend_row(Rings& rings, int i) noexcept;

}  // namespace onggi::clay::studio
