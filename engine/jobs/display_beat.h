// Whether a display is asked for its beat: a driver that let the whole wait go by (a display that is off, a
// window that nobody sees) is asked again a second later, then two, up to minutes, so that waiting for
// nothing costs next to nothing. Times in ns of one clock; one thread.
#pragma once

#include <algorithm>
#include <cstdint>

namespace onggi::jobs {

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

}  // namespace onggi::jobs
