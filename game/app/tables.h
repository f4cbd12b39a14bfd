// The tables and numbers that `throw` writes: profile and forces as CSV, nine significant digits whatever the
// locale. Any thread; pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "game/clay/paper_clay.h"

namespace onggi::app {

// y_mm,outer_mm: one row an element, bottom first; y is the element's middle.
[[nodiscard]] std::string profile_table(const clay::PaperClay& clay);

constexpr std::string_view kForcesHeader =
    "tick,t_s,contacts,fs_x_N,fs_y_N,fs_z_N,fv_x_N,fv_y_N,fv_z_N,ff_x_N,ff_y_N,ff_z_N\n";
// Appends the row of one tick.
void append_forces_row(std::string& table, std::uint64_t tick, double rate_hz,
                       const clay::ContactForces& forces);

}  // namespace onggi::app
