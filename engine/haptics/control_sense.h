// Tells a person at a control from the wear of the control. A control is anything that says a value: a stick,
// a trigger, a pedal, the place of a touch, of a mouse or of a hand. A person changes it. What stays where it
// is, trembles within its noise or drifts slowly is no sign of life.
//
// A control that does not come to rest for minutes is worn: from then on only what goes well beyond its own
// motion counts, until it has rested.
//
// Pure: no clock, time is the sum of the steps; no allocation, fit for the tick. Values in the control's own
// unit, s.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/math/math.h"

namespace onggi::haptics {

constexpr double kControlRestsS = 60.0;      // without a change for so long, it is at rest
constexpr double kNeverRestsAfterS = 600.0;  // without a rest, or held away from its rest, for so long

class ControlSense {
  public:
    // noise: a change by less counts for nothing. widest: what goes about farther than that is a person,
    // however long it goes on; for controls that many people use one after the other without a pause.
    explicit ControlSense(double noise, double widest = std::numeric_limits<double>::infinity())
        : noise_(noise),
          widest_(widest) {}

    // After dt_s more the control says `value`. Whether that is a sign of life: by how far it has come, not
    // by how fast, so that slow work counts. The first value is none. A value that is not a number is
    // ignored. is_held: away from the place at which the control rests, where it has one.
    [[nodiscard]] bool moved_to(const dvec3& value, double dt_s, bool is_held = false) noexcept {
        pass(dt_s, is_held);
        const dvec3 way = value - still_;
        const double length = std::sqrt(glm::dot(way, way));
        if (!(length <= std::numeric_limits<double>::max())) return false;
        if (!std::exchange(knows_a_value_, true)) {
            still_ = value;
            now_ = before_ = {value, value};
            return false;
        }
        if (length > noise_) return changed_to(value);
        constexpr double kDriftS = 20.0;  // a change by the noise that takes longer is drift
        const double most = noise_ * dt_s / kDriftS;
        still_ += length > most ? way * (most / length) : way;
        now_.take(value);
        return false;
    }
    // An event of a control, such as a press: a change even where the value is the same.
    [[nodiscard]] bool struck_at(const dvec3& value) noexcept {
        if (!std::exchange(knows_a_value_, true)) now_ = before_ = {value, value};
        return changed_to(value);
    }
    // Time passes, and nothing is known of the value.
    void pass(double dt_s, bool is_held = false) noexcept {
        held_s_ = is_held ? held_s_ + dt_s : 0.0;
        since_change_s_ += dt_s;
        since_life_s_ += dt_s;
        window_s_ += dt_s;
        if (since_change_s_ >= kControlRestsS) is_worn_ = false;
        const bool goes_on = since_life_s_ < kControlRestsS;
        const bool goes_about = !is_worn_ && !now_.with(before_).is_within(widest_);
        busy_s_ = goes_on && !goes_about ? busy_s_ + dt_s : 0.0;
        if (busy_s_ >= kNeverRestsAfterS) {
            is_worn_ = true;
            own_ = now_.with(before_);
            busy_s_ = 0.0;
        }
        if (window_s_ < kControlRestsS) return;
        if (is_worn_ && since_life_s_ >= window_s_) own_ = now_;  // nobody was there: it follows the wear
        before_ = now_;
        now_ = {still_, still_};
        window_s_ = 0.0;
    }

    // Since the last sign of life.
    [[nodiscard]] double still_s() const noexcept { return since_life_s_; }
    // Worn, or held for as long.
    [[nodiscard]] bool never_rests() const noexcept { return is_worn_ || held_s_ >= kNeverRestsAfterS; }

  private:
    // All values between two, axis by axis.
    struct Range {
        dvec3 low{0.0};
        dvec3 high{0.0};

        void take(const dvec3& value) noexcept {
            low = glm::min(low, value);
            high = glm::max(high, value);
        }
        [[nodiscard]] Range with(const Range& other) const noexcept {
            return {glm::min(low, other.low), glm::max(high, other.high)};
        }
        [[nodiscard]] bool is_within(double size) const noexcept {
            const dvec3 way = high - low;
            return glm::dot(way, way) <= size * size;
        }
        // Half as wide again on either side, and the noise.
        [[nodiscard]] bool nearly_holds(const dvec3& value, double noise) const noexcept {
            const dvec3 margin = 0.5 * (high - low) + dvec3(noise);
            return glm::all(glm::greaterThanEqual(value, low - margin)) &&
                   glm::all(glm::lessThanEqual(value, high + margin));
        }
    };

    bool changed_to(const dvec3& value) noexcept {
        still_ = value;
        since_change_s_ = 0.0;
        now_.take(value);
        if (is_worn_ && own_.nearly_holds(value, noise_)) return false;
        since_life_s_ = 0.0;
        return true;
    }

    double noise_;
    double widest_;
    bool knows_a_value_ = false;
    dvec3 still_{0.0};  // where it was when it last changed; follows a drift
    double since_change_s_ = 0.0;
    double since_life_s_ = 0.0;
    double busy_s_ = 0.0;  // signs of life without a rest
    double held_s_ = 0.0;
    bool is_worn_ = false;
    Range own_;     // what a worn control does by itself
    Range now_;     // its values in this window of kControlRestsS
    Range before_;  // in the one before
    double window_s_ = 0.0;
};

}  // namespace onggi::haptics
