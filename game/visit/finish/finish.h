// Firing: what other steps of a visit use. Any thread.
#pragma once

#include "game/visit/flow/step.h"

namespace onggi::visit {

// Whether the screen shows the glaze firing.
[[nodiscard]] bool kiln_burns(const State& state);

}  // namespace onggi::visit
