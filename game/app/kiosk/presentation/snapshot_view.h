// What the picture needs of a snapshot of the haptic loop. Main thread.
#pragma once

#include "game/clay/studio/grip.h"
#include "game/haptic/messages.h"
#include "game/wheel/wheel_view.h"

namespace onggi::app {

// Where the hands are seen that follow a finger: at their work in the clay, or near where a touch would take
// hold, in the pose that it would begin with. Any thread. mm.

// What a finger at that height meets; for clay::studio::grip_of_touch().
[[nodiscard]] clay::studio::GripOutline grip_outline(const pot::Pot& shape, double y_mm);

// Both hands of the view, for a snapshot whose tool is guided.
void show_guided_hands(wheel::WheelView& shown, const haptic::Snapshot& snapshot);

// Refers to the snapshot's pot, which must be there.
[[nodiscard]] wheel::WheelView wheel_view(const haptic::Snapshot& snapshot);

}  // namespace onggi::app
