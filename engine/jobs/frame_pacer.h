// Paces frames at a steady rate, or by the display's refresh if its driver reports it. Main thread. A late
// frame is followed at once by one frame, never by several.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/jobs/pacer.h"

namespace onggi::jobs {

template <PacerClock Clock = MonotonicClock>
class FramePacer {
  public:
    FramePacer(Clock& clock, double rate_hz)
        : clock_(clock),
          pacer_(clock, {.rate_hz = rate_hz, .wait = WaitMode::kSleep, .leave_rest = false}) {}

    // Sleeps until the next frame is due; not at all if it is late. on_beat: the display has just shown the
    // previous frame, so the next is due now, and later ones at whole periods from now. An implausibly early
    // report is limited to kLeastPart of a period.
    void wait(bool on_beat = false) noexcept {
        const std::int64_t before_ns = frame_.start_ns;
        if (on_beat) {
            constexpr double kLeastPart =
                0.75;  // of a period: the previous frame may have begun late, but the refresh is regular
            const auto least_ns = static_cast<std::int64_t>(kLeastPart * pacer_.period_ns());
            pacer_.align_next(std::max(clock_.now_ns(), before_ns + least_ns));
        }
        frame_ = pacer_.wait_for_next();
        if (frame_.tick > 0) interval_ns_.record(frame_.start_ns - before_ns);
    }
    // Call when the frame is drawn.
    void finish() noexcept { pacer_.finish(frame_); }

    [[nodiscard]] std::uint64_t frames() const noexcept { return pacer_.stats().ticks; }
    // The frames' work, from wait() to finish().
    [[nodiscard]] const Histogram& work_ns() const noexcept { return pacer_.stats().tick_ns; }
    // From the start of one frame to the start of the next.
    [[nodiscard]] const Histogram& interval_ns() const noexcept { return interval_ns_; }

  private:
    Clock& clock_;
    Pacer<Clock> pacer_;
    Period frame_;
    Histogram interval_ns_;
};

// Decides whether to wait for the display's refresh. After a timeout (a display that is off, a hidden window)
// it tries again a second later, then two, up to minutes, so that the timeouts cost almost nothing. Times in
// ns of one clock; one thread.
class DisplayBeat {
  public:
    [[nodiscard]] bool is_asked(std::int64_t now_ns) const noexcept { return now_ns >= asked_from_ns_; }
    void was_told() noexcept { pause_ns_ = kFirstPauseNs; }
    void was_not_told(std::int64_t now_ns) noexcept {
        asked_from_ns_ = now_ns + pause_ns_;
        pause_ns_ = std::min(2 * pause_ns_, kLongestPauseNs);
    }

  private:
    static constexpr std::int64_t kFirstPauseNs = 1'000'000'000;
    static constexpr std::int64_t kLongestPauseNs = 256 * kFirstPauseNs;

    std::int64_t asked_from_ns_ = 0;
    std::int64_t pause_ns_ = kFirstPauseNs;
};

// The frame rate for a display. Any thread; pure.

constexpr double kUsualFrameRateHz = 60.0;

// Returns the display's refresh rate, or the largest whole fraction that is not above most_hz, so that every
// frame is shown for the same number of refreshes. An unknown (0) or implausible rate counts as
// kUsualFrameRateHz. most_hz: at least kUsualFrameRateHz.
[[nodiscard]] inline double frame_rate_hz(double refresh_hz, double most_hz) {
    constexpr double kLeastHz = 20.0;
    constexpr double kMostHz = 1000.0;
    constexpr double kRounding = 1.01;  // drivers round 74.97 to 75, and 60.6 to 61
    if (!(refresh_hz >= kLeastHz && refresh_hz <= kMostHz)) return kUsualFrameRateHz;
    return refresh_hz / std::max(1.0, std::ceil(refresh_hz / (kRounding * most_hz)));
}

}  // namespace onggi::jobs
