// Where the hands of a snapshot are seen. The ball of a device is seen where it is. A finger on a screen
// leads skilled hands: at their work in the clay, or near where a touch would take hold, in the pose that it
// would begin with. Any thread; pure. mm.
#pragma once

#include <array>

#include "game/haptic/messages.h"
#include "game/wheel/tool_pose.h"

namespace onggi::wheel {

// Both hands of a snapshot, which must have its pot.
[[nodiscard]] std::array<DrawnHand, 2> hands_of(const haptic::Snapshot& snapshot);

// Fills in what a hand needs to know of the pot that is seen.
void meet(DrawnHand& hand, const pot::Pot& pot);

}  // namespace onggi::wheel
