// A visit as a pure function: state x event x time -> state and effects. It draws nothing, saves nothing and
// reads no clock. The steps' screens show the state, and the program carries out the effects. Any thread.
#pragma once

#include <vector>

#include "game/kiosk/events.h"
#include "game/kiosk/rules.h"

namespace onggi::visit {

std::vector<kiosk::Effect> advance(kiosk::State& state, const kiosk::Event& event, double now_s,
                                   const kiosk::Rules& rules);

// The state of a kiosk at its start: attract, with defaults. The first effect of the attract screen is
// StartDemo.
[[nodiscard]] kiosk::State first_state(const kiosk::Rules& rules, double now_s);

// Returns the whole seconds left of the idle panel's countdown.
[[nodiscard]] int seconds_left(const kiosk::State& state, double countdown_s, double now_s);

// Returns the whole seconds until a PIN digit is accepted again; 0 means now.
[[nodiscard]] int pin_seconds_left(const kiosk::State& state, double now_s);

}  // namespace onggi::visit
