// The picture's own clock: frames at a steady rate where the display does not pace them (no display, or one
// whose driver does not wait). One thread, the main one; a late frame is followed at once, never by a bunch.
#pragma once

#include <cstdint>

#include "engine/jobs/pacer.h"

namespace onggi::jobs {

template <PacerClock Clock = MonotonicClock>
class FramePacer {
  public:
    FramePacer(Clock& clock, double rate_hz)
        : pacer_(clock, {.rate_hz = rate_hz, .wait = WaitMode::kSleep, .leave_rest = false}) {}

    // Sleeps until the next frame is due; not at all if it is late.
    void wait() noexcept {
        const std::int64_t before_ns = frame_.start_ns;
        frame_ = pacer_.wait_for_next();
        if (frame_.tick > 0) interval_ns_.record(frame_.start_ns - before_ns);
    }
    // The frame is drawn.
    void finish() noexcept { pacer_.finish(frame_); }

    [[nodiscard]] std::uint64_t frames() const noexcept { return pacer_.stats().ticks; }
    // How long the frames' work took, from wait() to finish().
    [[nodiscard]] const Histogram& work_ns() const noexcept { return pacer_.stats().tick_ns; }
    // From the start of one frame to the start of the next.
    [[nodiscard]] const Histogram& interval_ns() const noexcept { return interval_ns_; }

  private:
    Pacer<Clock> pacer_;
    Period frame_;
    Histogram interval_ns_;
};

}  // namespace onggi::jobs
