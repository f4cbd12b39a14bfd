// Firing: what its files and other steps of a visit use. Any thread.
#pragma once

#include "game/visit/flow/step.h"

namespace onggi::visit {

// Whether the screen shows the glaze firing.
[[nodiscard]] bool kiln_burns(const State& state);

// The scale, u per mm, at which the picture of a pot on a shelf fits a box.
[[nodiscard]] float fitting_scale(const pot::Section& shape, float box_width, float box_height);

}  // namespace onggi::visit
