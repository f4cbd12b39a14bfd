// What the picture needs of a snapshot of the haptic loop. Main thread.
#pragma once

#include "game/haptic/messages.h"
#include "game/wheel/pot_view.h"

namespace onggi::app {

// Refers to the snapshot's shape, which must be there.
[[nodiscard]] wheel::PotView pot_view(const haptic::Snapshot& snapshot);

// The shape as large as it is after drying or firing: every length times `scale` (clay::shrunk_scale).
[[nodiscard]] haptic::PotShape shrunk(haptic::PotShape shape, double scale);

}  // namespace onggi::app
