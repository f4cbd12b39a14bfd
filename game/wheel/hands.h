// Places the hands of a snapshot in the picture. A device's ball is drawn where it is. For a finger on a
// screen, skilled hands are drawn at their work in the clay, or near the place where a touch would take hold,
// in its initial pose. Any thread; pure. mm.
#pragma once

#include <array>

#include "game/haptic/messages.h"
#include "game/wheel/tool_pose.h"

namespace onggi::wheel {

// Both hands of a snapshot, which must have its pot.
[[nodiscard]] std::array<DrawnHand, 2> hands_of(const haptic::Snapshot& snapshot);

// Fills in the properties of the visible pot that a hand needs.
void meet(DrawnHand& hand, const pot::Pot& pot);

}  // namespace onggi::wheel
