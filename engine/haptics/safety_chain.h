// Limits the force that reaches a visitor's hand: ordered lists of pure stages. Any one thread at a time; the
// whole chain takes some tens of ns, allocates nothing and cannot fail. mm, N, s.
//
// All force limits are here, except for conditions that this thread cannot know. In order:
//   kSafetyChain    once per tick, for the loop: from the wanted to the allowed force.
//   kMotorStages    then for each device (DeviceGroup::write): several devices share one chain, but each has
//                   motors of its own, which were warm or loose before it got the tool.
//   hid::ForceGate  last, on each device's I/O thread: the tick may have stopped, or the device may have been
//                   plugged in a moment ago, which the haptic thread cannot know. It only reduces a force.
// SafetyInput::applied_fraction is the fraction of a force that remains after the last two, so that the
// observer counts the applied force. SAFETY.md describes each stage, with its numbers and reasons.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "engine/haptics/hand_sample.h"
#include "engine/haptics/haptic_device.h"
#include "engine/math/math.h"

namespace onggi::haptics {

// All numbers of the safety chain; limits_for() lowers them to a device's own limits. Plain values; any
// thread. mm, N, s, mJ (N mm).

// The force limits of the kiosk, for every device and stage. A weaker device lowers them, a stronger one
// never raises them.
constexpr double kKioskPeakForceN = 3.3;
constexpr double kKioskContinuousForceN = 0.88;

struct SafetyLimits {
    // every stage: an input beyond these limits, or NaN, is not sound
    double longest_tick_s = 0.1;  // five times two periods of the slowest loop
    double most_driven_n = 1e6;   // of each coordinate of the driven part, so that its work stays finite
    // gate
    double workspace_mm = kWorkspaceMm;  // each coordinate within +-
    // speed: in contact, a brake replaces the force above the first speed; above the second the force is
    // zero.
    double brake_speed_mm_s = 600.0;
    double stop_speed_mm_s = 1200.0;
    double brake_n_s_per_mm = 0.002;
    // late: above this fraction of missed periods the gain falls, but not below least_gain.
    double late_fraction = 0.01;
    double least_gain = 0.25;
    double late_memory_s = 1.0;
    double soften_s = 0.05;  // from full gain to zero
    double harden_s = 1.0;   // and back
    // passivity: the largest damping it may add, and the bounds of the energy balance.
    double damping_n_s_per_mm = 0.002;
    double energy_credit_mj = 0.02;  // dissipation long ago must not pay for a vibration now
    double energy_debt_mj = 10.0;    // bounds how long the damping stays on
    double forget_s = 0.05;          // out of contact
    // work of the device on the hand, minus the work it took and the wheel's drive, over the memory
    double most_generated_mj = 250.0;
    double generated_memory_s = 1.0;
    // hand: the hand is absent, or the position is stale.
    int stale_ticks = 2;
    double device_period_s = 0.0;  // a device slower than the loop is stale after two of its own periods
    double decay_s = 0.005;        // from full force to zero
    double return_s = 0.25;        // and back, if it did not reach zero; otherwise through the ramp
    // ramp
    double ramp_s = 1.0;         // from zero to full force, at the start and after a fault
    double small_force_n = 0.2;  // the ramp begins only after a force below this ...
    // ... for more than this number of ticks in a row, so that the force does not start inside a wall
    int small_force_ticks = 3;
    // budget: the mean of the squared force over budget_s, which heats a motor, stays below the square of
    // continuous_force_n.
    double continuous_force_n = kKioskPeakForceN;
    double budget_s = 10.0;
    double budget_knee = 0.5;  // of the full mean; up to here the peak is allowed
    // clamp
    double peak_force_n = kKioskPeakForceN;
    // slew
    double slew_n_per_s = 200.0;      // how fast the force may grow or turn
    double release_n_per_s = 2000.0;  // how fast it may fall: the peak is gone in 2 ms
};

// The kiosk's limits, lowered to the device's. For a device without motors (a drawn tool) the continuous
// limit is the peak, and speed is unlimited.
[[nodiscard]] SafetyLimits limits_for(const DeviceCapabilities& device);

// The input of the safety chain in each tick. Plain values; the thread that runs the chain. mm, N, s, mJ (N
// mm).
struct SafetyInput {
    dvec3 position_mm{0.0};         // of the tool, as the device reported it
    double dt_s = 0.0;              // since the last tick: one step, two at most; 0 to longest_tick_s
    dvec3 velocity_mm_s{0.0};       // of the tool, from a windowed estimator: velocity_estimator.h
    dvec3 driven_force_n{0.0};      // the part that the wheel's motor drives: the drag of the turning work
    double applied_fraction = 1.0;  // fraction of the chain's last force that was applied, 0 to 1: a device
                                    // may have ramps and limits of its own
    std::uint32_t late = 0;         // periods missed since the last tick
    bool position_is_new = true;    // the device has refreshed it since the last tick
    bool hand_is_there = true;      // a dead-man's switch, an inkwell, a capacitive grip
    bool stop = false;              // request to stop the force, whatever else is true
};

enum class Fault : std::uint8_t {
    kNone,
    kForceNotFinite,
    kPositionNotFinite,
    kOutsideWorkspace,
    kStopped,  // by a person, or by a watchdog on their behalf
    kInputNotSound,
    kEnergyGenerated,
};
// Text for logs and screens.
[[nodiscard]] std::string_view words_for(Fault fault);

struct SafetyState {
    dvec3 applied_force_n{0.0};     // the force last sent to the device
    dvec3 applied_driven_n{0.0};    // the part that the wheel's motor drove
    dvec3 driven_force_n{0.0};      // the same part of the force now in the chain
    double ramp = 0.0;              // 0 to 1
    int calm_ticks = 0;             // ticks in a row with a small force, while the ramp waits
    Fault fault = Fault::kNone;     // latched: zero force until rearm()
    std::uint32_t fault_count = 0;  // faults since the state was made

    std::uint32_t speed_stops = 0;  // times the tool was too fast in contact
    double late_fraction = 0.0;     // of the periods of the last second
    std::uint64_t late_count = 0;   // periods missed since the state was made
    double gain = 1.0;              // factor on the force from stage late

    dvec3 last_position_mm{0.0};
    bool has_last_position = false;
    double energy_mj = 0.0;           // the observer's balance; below zero the loop has added energy
    double damping_n_s_per_mm = 0.0;  // added by the controller now
    double taken_mj = 0.0;            // by the device from the hand, since the state was made
    double given_mj = 0.0;            // by the device to the hand, a turning wheel's fraction included
    double generated_mj = 0.0;        // given less taken and driven in the last second, never below zero

    double stale_s = 0.0;  // since the position was refreshed
    int stale_ticks = 0;
    double presence = 1.0;  // 0 to 1; falls while the hand is absent

    double heat_n2 = 0.0;  // mean of the squared force
};

// Restarts from zero force through the ramp, with no energy generated; a latched fault stays.
void restart_ramp(SafetyState& state) noexcept;
// Clears a latched fault. The force starts from zero through the ramp; a cause that persists latches again on
// the next tick.
void rearm(SafetyState& state) noexcept;

// The stages of the safety chain, each usable and tested alone: force in, force out. A stage keeps its memory
// in the state and its bounds in the limits, and has no other input or output. A stage that scales the force
// scales its driven part alike. Any one thread at a time; no stage allocates, locks, reads a clock or fails.
// Only the gate may get an input that is not sound (apply_stages). mm, N, s, mJ.

// gate: a number that is not finite, an input that is not sound, a tool outside the workspace, or a stop
// request latches a fault; the force is zero while a fault is latched.
dvec3 gate(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// speed: a tool that moves faster in contact than a potter's hand has been thrown or shaken. A brake replaces
// the force; at a still higher speed the force is zero and the ramp restarts.
dvec3 speed(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// late: a loop that misses periods is a slower loop, and a wall that is stable at the full rate vibrates at a
// slower one. So the gain falls (gain scheduling).
dvec3 late(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// passivity: a passive wall never returns more energy than it took, but a sampled one does, because its force
// is held for a tick while the hand moves on. The observer sums the work of the applied force, F_{k-1} (x_k -
// x_{k-1}), where F_{k-1} is the chain's force times applied_fraction. When the balance is below zero the
// controller adds the damping that would pay it back within a tick, up to a limit. The turning wheel has a
// motor and may do work, so the work of the driven part of F_{k-1} is credited. Source: B. Hannaford and
// J.-H. Ryu, "Time-domain passivity control of haptic interfaces", IEEE Trans. on Robotics and Automation
// 18(1), 2002. Differs: the observer counts every step of the encoder, but the controller damps the windowed
// velocity:
//   damping on single encoder steps itself caused a vibration of 0.4 mm at 4 kHz on the bench of stability.h.
// Differs: the balance is clamped between a small credit and a debt, and decays out of contact: a long
//   press would otherwise pay for minutes of vibration.
// Differs: a device that has generated more than most_generated_mj is let go, and a fault is latched: no
//   damping within the controller's limit stops that loop.
dvec3 passivity(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// hand: if the hand is absent or the position stale, the force falls to zero within some ms. From zero it
// comes back through the ramp.
dvec3 hand(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// ramp: zero until the force has been small for a moment, then a factor that grows from 0 to 1.
dvec3 ramp(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// budget: the peak force for a moment, the continuous force without a time limit. The bound falls from peak
// to continuous force while the mean of the squared force rises from budget_knee of the continuous force's
// square to its full value. The bound is always so low that the longest tick cannot lift the mean beyond that
// value. The kept mean is never below the exact one, so neither exceeds it, however long the ticks are.
dvec3 budget(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// clamp: at most the peak force. It scales the vector, since clamping each axis would change the direction.
dvec3 clamp(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

// slew: first reduces the part that is no longer wanted, at the release rate, then grows or turns at the slew
// rate. A latched fault drops the force at once.
dvec3 slew(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;

struct SafetyStage {
    std::string_view name;
    std::string_view does;  // one line for users
    dvec3 (*apply)(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;
};

// The reasons for the order: no value that is not finite may reach the arithmetic, so the gate is first.
// Stages that shape the force come before the observer, which judges the intended force. Stages that remove
// force to protect a person come after it, so that they also limit its damping. The clamp bounds the target
// of the slew. The slew is last, because it compares with the force that the device got before.
inline constexpr std::array<SafetyStage, 9> kSafetyChain{{
    {"gate", "zero force and a latched fault on NaN, infinity, a tool outside the workspace, or stop", &gate},
    {"speed", "a tool too fast in contact is braked, then let go", &speed},
    {"late", "a lower gain while the loop misses periods", &late},
    {"passivity", "damping that removes the energy that sampling adds", &passivity},
    {"hand", "no force without a hand, or when its position is stale", &hand},
    {"ramp", "from zero to full force at the start and after a fault, once the force is small", &ramp},
    {"budget", "the peak force for a moment, the continuous force for ever", &budget},
    {"clamp", "at most the peak force, direction kept", &clamp},
    {"slew", "bounded change from tick to tick; letting go is faster than pushing", &slew},
}};

// Applies the whole chain. Returns the force that the device may get.
dvec3 apply_safety_chain(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
                         SafetyState& state) noexcept;

// The stages for each device's own motors: a ramp after a change of holders, and the motors' limits. The
// loop's chain cannot do this, because it sees only one tool: a motor stays warm while another device works,
// and the loop's ramp is over when a device that lay in the work takes over.
inline constexpr std::array<SafetyStage, 3> kMotorStages{{
    {"ramp", "from zero to full force once a device has the tool and the force is small", &ramp},
    {"budget", "this device's own mean force, while it works and while it rests", &budget},
    {"clamp", "this device's own peak force, direction kept", &clamp},
}};

// Applies the stages in order and stores the applied force in the state. An input that is not sound (time,
// applied fraction or driven part out of bounds, a force that is not finite) reaches only a gate at the head
// of the list, which latches a fault: the force is zero and the ramp restarts. Without a gate nothing is
// latched, because a device's motors have no rearm().
dvec3 apply_stages(std::span<const SafetyStage> stages, const dvec3& force_n, const SafetyInput& input,
                   const SafetyLimits& limits, SafetyState& state) noexcept;

}  // namespace onggi::haptics
