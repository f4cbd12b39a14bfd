// What the safety chain is told each tick, and what it remembers from one to the next. Plain values; the
// thread that runs the chain. mm, N, s, mJ (N mm).
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/math/math.h"

namespace onggi::haptics {

struct SafetyInput {
    dvec3 position_mm{0.0};         // of the tool, as the device said it
    double dt_s = 0.0;              // since the last tick: one step, two at most
    dvec3 velocity_mm_s{0.0};       // of the tool, from a windowed estimator: velocity_estimator.h
    dvec3 driven_force_n{0.0};      // the part of the force that a motor is behind: a turning wheel's drag
    double applied_fraction = 1.0;  // of the force that the chain gave last, what really went out: a device
                                    // may have ramps and limits of its own
    std::uint32_t late = 0;         // periods that were missed since the last tick
    bool position_is_new = true;    // the device has refreshed it since the last tick
    bool hand_is_there = true;      // a dead-man's switch, an inkwell, a capacitive grip
    bool stop = false;              // somebody wants it to stop, whatever else is true
};

enum class Fault : std::uint8_t {
    kNone,
    kForceNotFinite,
    kPositionNotFinite,
    kOutsideWorkspace,
    kStopped,  // by a person, or by a watchdog on their behalf
};
// For logs and screens: what was wrong, in words.
[[nodiscard]] std::string_view words_for(Fault fault);

struct SafetyState {
    dvec3 applied_force_n{0.0};     // what the device got last
    dvec3 applied_driven_n{0.0};    // the part of it that a motor was behind
    dvec3 driven_force_n{0.0};      // the same of the force on its way through the chain
    double ramp = 0.0;              // 0 to 1
    int calm_ticks = 0;             // ticks in a row with a small force, while the ramp waits
    Fault fault = Fault::kNone;     // latched: zero force until rearm()
    std::uint32_t fault_count = 0;  // faults since the state was made

    std::uint32_t speed_stops = 0;  // how often the tool was too fast in contact
    double late_fraction = 0.0;     // of the periods of the last second
    std::uint64_t late_count = 0;   // periods missed since the state was made
    double gain = 1.0;              // what lateness leaves of the force

    dvec3 last_position_mm{0.0};
    bool has_last_position = false;
    double energy_mj = 0.0;  // the observer's balance; below zero the loop has given more than it took
    double damping_n_s_per_mm = 0.0;  // what the controller adds now
    double taken_mj = 0.0;            // by the device from the hand, since the state was made
    double given_mj = 0.0;            // by the device to the hand, a turning wheel's fraction included

    double stale_s = 0.0;  // since the position was refreshed
    int stale_ticks = 0;
    double presence = 1.0;  // 0 to 1; falls while nobody is there

    double heat_n2 = 0.0;  // mean of the squared force
};

// From nothing again, through the ramp; a latched fault stays.
void restart_ramp(SafetyState& state) noexcept;
// Takes a latched fault back. The force starts again from nothing, through the ramp; a cause that persists
// latches again on the next tick.
void rearm(SafetyState& state) noexcept;

}  // namespace onggi::haptics
