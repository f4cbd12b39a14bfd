// The picture's clock: frames at a steady rate of their own, or by the display's beat where its driver tells
// of it. One thread, the main one; a late frame is followed at once, never by a bunch.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/jobs/pacer.h"

namespace onggi::jobs {

template <PacerClock Clock = MonotonicClock>
class FramePacer {
  public:
    FramePacer(Clock& clock, double rate_hz)
        : clock_(clock),
          pacer_(clock, {.rate_hz = rate_hz, .wait = WaitMode::kSleep, .leave_rest = false}) {}

    // Sleeps until the next frame is due; not at all if it is late. on_beat: the display has this moment
    // shown the frame before, so that the next is due now, and those after it a period each from now. A
    // driver that says so sooner than any display can is not believed.
    void wait(bool on_beat = false) noexcept {
        const std::int64_t before_ns = frame_.start_ns;
        if (on_beat) {
            constexpr double kLeastPart = 0.75;  // of a period: a frame may have begun late, the beat is not
            const auto least_ns = static_cast<std::int64_t>(kLeastPart * pacer_.period_ns());
            pacer_.align_next(std::max(clock_.now_ns(), before_ns + least_ns));
        }
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
    Clock& clock_;
    Pacer<Clock> pacer_;
    Period frame_;
    Histogram interval_ns_;
};

}  // namespace onggi::jobs
