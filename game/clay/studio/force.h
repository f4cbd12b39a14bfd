// Forces on the hand, and the load that the hand puts on the wheel. Haptic thread; no allocation. Units: mm,
// N, N mm, kPa.
#pragma once

#include "game/clay/paper_clay.h"
#include "game/clay/studio/contact.h"

namespace onggi::clay::studio {

struct Feel {
    ContactForces forces;          // F_s, F_v and F_f as in Eq. (3)
    double wheel_load_n_mm = 0.0;  // opposes the turning
};

// Two resistances act in series: indentation, Nc su times the contact area pi 2 R* d, and, for an unsupported
// wall, its hinge, 2 pi su t^2. Friction is mu times that force, against the sliding. film: 0 dry to 1 wet,
// of hand or face. supported: by the other hand, 0 to 1.
// Differs: the paper's clay has K = 0.1 N/mm while the wheel turns and 0.5 while it stands. Here stiffness
//   follows from the clay's strength, turning or not; 13 kPa under a ball of 10 mm is some 4 N/mm, dry clay
//   far more.
// Differs: Eq. (7)'s friction grows with speed and not with pressure; here it grows with pressure, as on
//   clay.
Feel feel(const Rings& rings, const Contact& contact, const Hand& hand, const dvec3& velocity_mm_s,
          double wheel_speed_rad_s, double film, double supported,
          const StudioParameters& parameters) noexcept;

}  // namespace onggi::clay::studio
