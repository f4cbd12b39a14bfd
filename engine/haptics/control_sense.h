// Distinguishes a person at a control from wear of the control. A control is anything with a value: a stick,
// a trigger, a pedal, the position of a touch, a mouse or a hand. A person changes the value. A value that
// stays, varies within its noise or drifts slowly is no sign of life.
//
// A control that does not come to rest for minutes is worn. From then on only values well outside its own
// range count, until it has rested.
//
// Pure: no clock, time is the sum of the steps; no allocation, fit for the tick. Values in the control's own
// unit, time in s.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/math/math.h"

namespace onggi::haptics {

constexpr double kControlRestsS = 60.0;  // at rest after this time without a change
constexpr double kNeverRestsAfterS =
    600.0;  // flagged after this time without a rest, or away from its rest position

class ControlSense {
  public:
    // noise: smaller changes are ignored. widest: a control that ranges farther is used by people and is
    // never worn; for controls that many people use without a pause.
    explicit ControlSense(double noise, double widest = std::numeric_limits<double>::infinity())
        : noise_(noise),
          widest_(widest) {}

    // Takes the value after another dt_s. Returns whether it is a sign of life, judged by distance and not by
    // speed, so that slow work counts. The first value is no sign of life. Ignores a value that is not
    // finite. is_held: the control is away from its rest position, if it has one.
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
    // Takes an event of a control, such as a press: a change even if the value is the same.
    [[nodiscard]] bool struck_at(const dvec3& value) noexcept {
        if (!std::exchange(knows_a_value_, true)) now_ = before_ = {value, value};
        return changed_to(value);
    }
    // Advances the time without a value.
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
        if (is_worn_ && since_life_s_ >= window_s_) own_ = now_;  // no person was there: follow the wear
        before_ = now_;
        now_ = {still_, still_};
        window_s_ = 0.0;
    }

    // The time since the last sign of life.
    [[nodiscard]] double still_s() const noexcept { return since_life_s_; }
    // Whether the control is worn, or held for as long.
    [[nodiscard]] bool never_rests() const noexcept { return is_worn_ || held_s_ >= kNeverRestsAfterS; }

  private:
    // A range of values for each axis.
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
        // Whether the value is within the range, widened by half its width and the noise on either side.
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
    dvec3 still_{0.0};  // the value at the last change; follows a drift
    double since_change_s_ = 0.0;
    double since_life_s_ = 0.0;
    double busy_s_ = 0.0;  // duration of signs of life without a rest
    double held_s_ = 0.0;
    bool is_worn_ = false;
    Range own_;     // the range of a worn control without a person
    Range now_;     // the range in this window of kControlRestsS
    Range before_;  // the range in the previous window
    double window_s_ = 0.0;
};

}  // namespace onggi::haptics
