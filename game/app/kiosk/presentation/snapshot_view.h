// What the picture needs of a snapshot of the haptic loop. Main thread.
#pragma once

#include "game/haptic/messages.h"
#include "game/wheel/wheel_view.h"

namespace onggi::app {

// Refers to the snapshot's pot, which must be there.
[[nodiscard]] wheel::WheelView wheel_view(const haptic::Snapshot& snapshot);

}  // namespace onggi::app
