// What a device besides the force may show of the clay: how stiff and how thick it is where it is touched,
// how near it is to giving way, how fast it turns. Pure; fit for the tick. mm, N, rad/s.
#pragma once

#include "engine/haptics/haptic_device.h"
#include "game/haptic/tick.h"

namespace onggi::haptic {

// Of the tick that has just been.
[[nodiscard]] haptics::WorkFelt work_felt(const HapticState& state, const TickResult& result,
                                          const HapticParameters& parameters) noexcept;

}  // namespace onggi::haptic
