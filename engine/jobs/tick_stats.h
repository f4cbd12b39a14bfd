// What a fixed-rate loop measures of itself. Written by its own thread, read by others after it has ended.
#pragma once

#include <cstdint>

#include "engine/jobs/histogram.h"

namespace onggi::jobs {

struct TickStats {
    Histogram tick_ns;  // how long the work took
    Histogram
        wake_latency_ns;      // start of the work minus the deadline that was waited for, after any spinning
    std::uint64_t ticks = 0;  // how often the work ran
    std::uint64_t skipped_periods = 0;  // periods that had gone by before their work could begin
    std::uint64_t overrun_periods = 0;  // periods whose work ended after the next deadline

    // Periods whose tick had not finished one period after its deadline, skipped periods counted.
    [[nodiscard]] std::uint64_t missed_deadlines() const noexcept {
        return skipped_periods + overrun_periods;
    }
};

}  // namespace onggi::jobs
