// Whether a device reports all the time or only what has changed, found out by its own reports. Nothing in a
// descriptor tells it, and it decides what a silence means: a still hand, or a device that has fallen mute.
// One thread at a time; no allocation.
//
// Who says the same twice running does not wait for a change: it reports all the time, and its silence is a
// lack. Who goes on after a long silence is one that may be silent: some firmwares say a last word or two and
// then rest. Until something is known a silence is taken for a still hand, which its driver bounds.
#pragma once

#include <algorithm>
#include <span>

#include "engine/haptics/hid/hid_port.h"

namespace onggi::haptics::hid {

class ReportHabit {
  public:
    // Every report of where the hand is.
    void take(std::span<const std::uint8_t> report) noexcept {
        Report now;
        now.size = std::min(report.size(), now.bytes.size());
        std::copy_n(report.begin(), now.size, now.bytes.begin());
        repeats_ = repeats_ || (was_heard_ && now == last_);
        rests_ = rests_ || silent_rounds_ >= kLongRounds;
        last_ = now;
        was_heard_ = true;
        silent_rounds_ = 0;
    }
    // Every round of the I/O thread: only rounds that listened count, not one that the kernel kept waiting.
    void round() noexcept { silent_rounds_ = std::min(silent_rounds_ + 1, kLongRounds); }

    [[nodiscard]] bool reports_all_the_time() const noexcept { return repeats_ && !rests_; }

  private:
    // A tenth of a second: each listens for 4 ms.
    static constexpr int kLongRounds = 25;

    Report last_;
    bool was_heard_ = false;
    bool repeats_ = false;
    bool rests_ = false;
    int silent_rounds_ = 0;
};

}  // namespace onggi::haptics::hid
