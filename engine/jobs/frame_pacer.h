// The picture's clock: frames at a steady rate of their own, or by the display's beat where its driver tells
// of it. One thread, the main one; a late frame is followed at once, never by a bunch.
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

// Whether a display is asked for its beat: a driver that let the whole wait go by (a display that is off, a
// window that nobody sees) is asked again a second later, then two, up to minutes, so that waiting for
// nothing costs next to nothing. Times in ns of one clock; one thread.
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

// How many frames a second suit a display. Any thread; pure.

constexpr double kUsualFrameRateHz = 60.0;

// The display's own rate, or the largest whole fraction of it that is not above most_hz: every frame is then
// shown for as many refreshes as the next. A display that says nothing (0), or what none does, is a usual
// one. most_hz: from kUsualFrameRateHz on.
[[nodiscard]] inline double frame_rate_hz(double refresh_hz, double most_hz) {
    constexpr double kLeastHz = 20.0;
    constexpr double kMostHz = 1000.0;
    constexpr double kRounding = 1.01;  // drivers say 75 of 74.97, and 61 of 60.6
    if (!(refresh_hz >= kLeastHz && refresh_hz <= kMostHz)) return kUsualFrameRateHz;
    return refresh_hz / std::max(1.0, std::ceil(refresh_hz / (kRounding * most_hz)));
}

}  // namespace onggi::jobs
