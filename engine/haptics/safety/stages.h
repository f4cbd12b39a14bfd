// The stages of the safety chain, each usable and tested alone: force in, force out. What a stage remembers
// is in the state, what bounds it in the limits; nothing else goes in or out. A stage that takes a fraction
// of the force takes the same of the part that a motor is behind. Any one thread at a time; no stage
// allocates, locks, reads a clock or fails. mm, N, s, mJ.
#pragma once

#include "engine/haptics/safety/limits.h"
#include "engine/haptics/safety/state.h"
#include "engine/math/math.h"

namespace onggi::haptics {

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

}  // namespace onggi::haptics
