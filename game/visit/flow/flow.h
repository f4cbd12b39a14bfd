// A visit as a pure function: state x event x time -> state and effects. It draws nothing, saves nothing and
// reads no clock; the steps' screens show the state, and the program carries out the effects. Any thread.
#pragma once

#include <vector>

#include "game/kiosk/events.h"
#include "game/kiosk/rules.h"

namespace onggi::visit {

std::vector<kiosk::Effect> advance(kiosk::State& state, const kiosk::Event& event, double now_s,
                                   const kiosk::Rules& rules);

// The state of a kiosk at its start: attract, everything at its default. Its first effect is StartDemo.
[[nodiscard]] kiosk::State first_state(const kiosk::Rules& rules, double now_s);

// Whole seconds left of the idle panel's countdown.
[[nodiscard]] int seconds_left(const kiosk::State& state, double countdown_s, double now_s);

// Whole seconds until a PIN digit is accepted again; 0: now.
[[nodiscard]] int pin_seconds_left(const kiosk::State& state, double now_s);

}  // namespace onggi::visit
