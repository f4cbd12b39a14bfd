// The numbers that --stats writes, as JSON. Main thread.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "engine/jobs/histogram.h"
#include "game/app/command_line/live_loop.h"
#include "game/haptic/tick.h"

namespace onggi::app {

// Returns {p50, p99, p999, max} of a histogram, divided by `unit` (1000 converts ns to us).
[[nodiscard]] nlohmann::ordered_json percentiles(const jobs::Histogram& histogram, double unit = 1.0);

// The fields of every run: ticks, tick_ns, rate_hz, clay_volume_mm3, ledger_error (a fraction of the lump;
// null for the paper's clay, which keeps no ledger). For the studio clay also mass, height, widest diameter,
// floor, walls, capacity, its clay ledger, the number of rings, the load, a failure's sentence, and all
// measures wet and glaze-fired (exporter/studio_export.h).
[[nodiscard]] nlohmann::ordered_json common_stats(std::uint64_t ticks, const jobs::Histogram& tick_ns,
                                                  double rate_hz, const haptic::HapticState& state);

// The additional fields of a live run.
[[nodiscard]] nlohmann::ordered_json live_stats(const LiveReport& report);

}  // namespace onggi::app
