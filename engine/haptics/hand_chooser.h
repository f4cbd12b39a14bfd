// Which of several hands has the tool. Pure: no clock, time is the sum of the steps; no allocation. s.
#pragma once

#include <cstddef>
#include <span>

namespace onggi::haptics {

struct HandChooserOptions {
    // A hand that has the tool keeps it until it has been still for so long; then the next that moves takes
    // it. Two people do not tear the tool to and fro, and nobody waits for somebody who has gone.
    double still_s = 0.5;
    // Hand 0 is no person but a recording, which always moves: others take the tool from it at once, and it
    // waits longer until it goes on.
    bool first_yields = false;
    double recording_waits_s = 3.0;
    // A hand that has gone for so long is not coming back at once: the first, which is always there, has the
    // tool again, and takes it out of the work where it was left.
    double gone_s = 0.5;
};

// What is known of one hand in this tick.
struct HandSeen {
    bool is_here = false;
    bool is_moving = false;
};

class HandChooser {
  public:
    explicit HandChooser(const HandChooserOptions& options = {}) : options_(options) {}

    // The hand that has the tool now: hand 0 at first. A holder that is gone keeps it a moment, without
    // moving it, unless another hand moves. With several moving at once it is the one named last, so list
    // devices that push back after those that do not.
    [[nodiscard]] std::size_t choose(std::span<const HandSeen> hands, double dt_s) noexcept {
        const HandSeen& holder = hands[holder_];
        const bool is_at_work = holder.is_here && holder.is_moving;
        still_s_ = is_at_work ? 0.0 : still_s_ + dt_s;
        const bool yields = options_.first_yields && holder_ == 0;
        for (std::size_t other = hands.size(); other-- > 0;) {
            if (other == holder_ || !hands[other].is_here || !hands[other].is_moving) continue;
            const double wait_s =
                options_.first_yields && other == 0 ? options_.recording_waits_s : options_.still_s;
            if (!holder.is_here || yields || still_s_ >= wait_s) {
                holder_ = other;
                still_s_ = 0.0;
                break;
            }
        }
        if (!hands[holder_].is_here && hands[0].is_here && still_s_ >= options_.gone_s) {
            holder_ = 0;
            still_s_ = 0.0;
        }
        return holder_;
    }

  private:
    HandChooserOptions options_;
    std::size_t holder_ = 0;
    double still_s_ = 0.0;
};

}  // namespace onggi::haptics
