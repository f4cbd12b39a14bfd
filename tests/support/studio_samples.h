// Pots of the studio clay for tests and for programs that are not ours: each stresses another part of an
// export. Any thread.
#pragma once

#include <string>
#include <vector>

#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::support {

struct StudioSample {
    std::string name;
    clay::StudioClay clay;
    clay::Firing stage = clay::Firing::kWet;
    int euler = 2;  // V - E + F of the solid
    int parts = 1;
    double off_axis_mm = 0.0;  // by dents, a bump, or clay beside the axis
    bool calm = true;          // left by a smooth hand: within 0.02 mm, normals as on a smooth wall
};

// A fresh lump (solid, off centre), a thrown cylinder as it stands and glaze-fired, a thrown vase
// bisque-fired, a cylinder dented by a standing finger, a cylinder that was never centred, a wet bowl that
// the wheel spun apart, a tube, a cup upside down, a hollow closed over, walls of a millimetre, a ring of
// clay, and a jagged wall such as no hand makes.
std::vector<StudioSample> all_studio_samples();

}  // namespace onggi::support
