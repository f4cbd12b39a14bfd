// The tables and numbers that `throw` writes: profile and forces as CSV, nine significant digits whatever the
// locale. Any thread; pure.
#pragma once

#include <cstdint>
#include <string>

#include "game/haptic/tick.h"

namespace onggi::app {

// y_mm,outer_mm, and of the studio's clay inner_mm (0 where it is solid): one row an element or ring, bottom
// first; y is its middle.
[[nodiscard]] std::string profile_table(const haptic::HapticState& state);

// The header line of the forces, with its end: of the first hand; of the studio's clay also its side (free,
// outer, inner or rim), how many rings the second hand or the assist touches, the wheel's speed, the hands'
// friction on it, and the largest load index.
[[nodiscard]] std::string forces_header(const haptic::HapticState& state);
// Appends the row of one tick; `state` is the one after it.
void append_forces_row(std::string& table, std::uint64_t tick, double rate_hz,
                       const haptic::TickResult& result, const haptic::HapticState& state);

}  // namespace onggi::app
