// What stands between a force that somebody wants and a visitor's hand: ordered lists of pure stages. Any one
// thread at a time; the whole chain takes some tens of ns, allocates nothing and cannot fail. mm, N, s.
//
// Force is limited here and nowhere else but for what this thread cannot know. In the order of its way:
//   kSafetyChain    once a tick, of the loop: what is wanted becomes what the tool may get.
//   kMotorStages    then of each hand there is (Hands::write): several hands share one chain, but each has
//                   motors of its own, which were warm or loose before it got the tool.
//   hid::ForceGate  last, on each device's I/O thread: the tick may have stopped, or the device may have been
//                   plugged in a moment ago, and nothing on the haptic thread would know. It only takes away.
// What the last two leave of a force comes back as SafetyInput::applied_fraction, so that the observer counts
// what really went out. SAFETY.md beside this file says what each stage does, with its numbers, and why.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "engine/haptics/hand_sample.h"
#include "engine/haptics/haptic_device.h"
#include "engine/math/math.h"

namespace onggi::haptics {

// Every number of the safety chain in one place, and how a device's own limits lower them. Plain values; any
// thread. mm, N, s, mJ (N mm).

// The kiosk's profile, for every device and every stage; a weaker device lowers it, a stronger one never
// raises it.
constexpr double kKioskPeakForceN = 3.3;
constexpr double kKioskContinuousForceN = 0.88;

struct SafetyLimits {
    // gate
    double workspace_mm = kWorkspaceMm;  // each coordinate within +-
    // speed: in contact, from the first on the force gives way to a brake; above the second there is none.
    double brake_speed_mm_s = 600.0;
    double stop_speed_mm_s = 1200.0;
    double brake_n_s_per_mm = 0.002;
    // late: a larger fraction of late periods than this makes the touch softer, down to the least gain.
    double late_fraction = 0.01;
    double least_gain = 0.25;
    double late_memory_s = 1.0;
    double soften_s = 0.05;  // from full gain to none
    double harden_s = 1.0;   // and back
    // passivity: the damping it may add, and how much energy it keeps in hand or is owed.
    double damping_n_s_per_mm = 0.002;
    double energy_credit_mj = 0.02;  // a long dissipative past must not pay for a shake
    double energy_debt_mj = 10.0;    // bounds how long the damping stays on
    double forget_s = 0.05;          // out of contact
    // hand: nobody there, or a position that is no longer refreshed.
    int stale_ticks = 2;
    double device_period_s = 0.0;  // a device slower than the loop is stale after two of its own periods
    double decay_s = 0.005;        // from full force to none
    double return_s = 0.25;        // and back, if it never came to none; else through the ramp
    // ramp
    double ramp_s = 1.0;         // from nothing to full force, at the start and after a fault
    double small_force_n = 0.2;  // the ramp begins only after a force below this ...
    int small_force_ticks = 3;   // ... for more than so many ticks in a row: no start inside a wall
    // budget: the mean of the squared force over budget_s, what heats a motor, stays below the square of
    // this.
    double continuous_force_n = kKioskPeakForceN;
    double budget_s = 10.0;
    // clamp
    double peak_force_n = kKioskPeakForceN;
    // slew
    double slew_n_per_s = 200.0;      // how fast the force may grow or turn
    double release_n_per_s = 2000.0;  // how fast it may fall: the peak is gone in 2 ms
};

// The kiosk's profile, lowered to what the device can give. A device without motors (a picture of a tool) has
// no continuous limit but its peak, and no limit of speed.
[[nodiscard]] SafetyLimits limits_for(const DeviceCapabilities& device);

// What the safety chain is told each tick, and what it remembers from one to the next. Plain values; the
// thread that runs the chain. mm, N, s, mJ (N mm).
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

// The stages of the safety chain, each usable and tested alone: force in, force out. What a stage remembers
// is in the state, what bounds it in the limits; nothing else goes in or out. A stage that takes a fraction
// of the force takes the same of the part that a motor is behind. Any one thread at a time; no stage
// allocates, locks, reads a clock or fails. mm, N, s, mJ.

// gate: a force or position that is not finite, a tool outside the workspace, or a wish to stop latches a
// fault; zero force as long as one is latched.
dvec3 gate(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// speed: a tool that is faster in contact than a potter's hand is thrown or shaken. First a brake takes the
// place of the force; faster still, there is none, and the ramp starts anew.
dvec3 speed(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// late: a loop that misses periods is a slower loop, and a wall that is stable at the full rate buzzes at a
// slower one. So it makes the wall softer: gain scheduling.
dvec3 late(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// passivity: dead matter never gives a hand more energy than it took, but a sampled one does: its force is
// held for a tick while the hand moves on. The observer adds up the work of the force that the device really
// applied, F_{k-1} (x_k - x_{k-1}), exactly what was given; F_{k-1} is what the chain let out, in the
// fraction that the device's own ramps and limits left of it. When the balance is below zero the controller
// adds the damping that would pay it back within a tick, up to a limit. A turning wheel has a motor and may
// do work: what it really put in, the driven part of F_{k-1}, is put on the credit side. Source: B. Hannaford
// and J.-H. Ryu, "Time-domain passivity control of haptic interfaces", IEEE Trans. on Robotics and Automation
// 18(1), 2002. Differs: the observer counts every step of the encoder, but the controller damps the windowed
// velocity:
//   damping each step by itself made a rattle of 0.4 mm of its own at 4 kHz in the bench of stability.h.
// Differs: the balance is kept between a small credit and a debt, and out of contact it is forgotten: a long
//   press would otherwise pay for minutes of shaking.
dvec3 passivity(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// hand: no hand, or a position that is not refreshed any more, lets the force go in some ms. Once it is gone
// it comes back through the ramp.
dvec3 hand(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// ramp: nothing until the force has been small for a moment, then growing from 0 to 1 times the force.
dvec3 ramp(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// budget: the peak force for a moment, the continuous force for ever. The bound goes from the one to the
// other while the mean of the squared force goes from half of the continuous force's square to all of it, so
// it can never pass it.
dvec3 budget(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// clamp: at most the peak force, by scaling the vector: an axis-wise clamp would bend the push aside.
dvec3 clamp(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// slew: first lets go of what is no longer wanted, at the release rate, then grows or turns at the slew rate.
// A latched fault drops the force at once.
dvec3 slew(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

struct SafetyStage {
    std::string_view name;
    std::string_view does;  // one line for a person
    dvec3 (*apply)(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;
};

// The order is the chain's meaning. Nothing that is not finite may reach the arithmetic. What shapes the
// force comes before the observer, so that it judges the force that is meant; what takes force away for
// a person's sake comes after it, so that not even its damping is felt by nobody. The clamp bounds what the
// slew aims at, and the slew is last because it alone knows what the device got before.
inline constexpr std::array<SafetyStage, 9> kSafetyChain{{
    {"gate", "zero force and a latched fault on NaN, infinity, a tool outside the workspace, or stop", &gate},
    {"speed", "a tool too fast in contact is braked, then let go", &speed},
    {"late", "a softer touch while the loop misses periods", &late},
    {"passivity", "damping that takes back what the sampled loop gave too much", &passivity},
    {"hand", "no force without a hand, or when its position is stale", &hand},
    {"ramp", "from nothing to full force at the start and after a fault, once the force is small", &ramp},
    {"budget", "the peak force for a moment, the continuous force for ever", &budget},
    {"clamp", "at most the peak force, direction kept", &clamp},
    {"slew", "bounded change from tick to tick; letting go is faster than pushing", &slew},
}};

// The whole chain: the wanted force in, what the device may get out.
dvec3 apply_safety_chain(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
                         SafetyState& state) noexcept;

// What a hand's own motors get of it, in the chain's own stages: after a change of hands from nothing, and
// never more than they bear. Not among the stages of the loop, which knows one tool: a motor stays warm while
// another hand works, and the loop's ramp is over when a hand that lay in the work takes over.
inline constexpr std::array<SafetyStage, 3> kMotorStages{{
    {"ramp", "from nothing to full force once a hand has the tool and the force is small", &ramp},
    {"budget", "this hand's own mean force, in use and out of it", &budget},
    {"clamp", "this hand's own peak force, direction kept", &clamp},
}};

// Any stages in their order. What remembers the applied force is the slew; without it the caller's force is
// remembered here.
dvec3 apply_stages(std::span<const SafetyStage> stages, const dvec3& force_n, const SafetyInput& input,
                   const SafetyLimits& limits, SafetyState& state) noexcept;

}  // namespace onggi::haptics
