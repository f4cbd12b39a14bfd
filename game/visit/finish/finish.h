// Firing, as the rest of a visit knows it. Any thread.
#pragma once

#include "game/visit/flow/step.h"

namespace onggi::visit {

// The glaze kiln is burning before the visitor's eyes.
[[nodiscard]] bool kiln_burns(const State& state);

}  // namespace onggi::visit
