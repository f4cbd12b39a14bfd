// What stands between a force that somebody wants and a visitor's hand: ordered lists of pure stages. Any one
// thread at a time; the whole chain takes some tens of ns, allocates nothing and cannot fail. mm, N, s.
//
// Force is limited here and nowhere else but for what this thread cannot know. In the order of its way:
//   kSafetyChain    once a tick, of the loop: what is wanted becomes what the tool may get.
//   kMotorStages    then of each hand there is (Hands::write): several hands share one chain, but each has
//                   motors of its own, which were warm or loose before it got the tool.
//   hid::ForceGate  last, on each device's I/O thread: the tick may have stopped, or the device may have been
//                   plugged in a moment ago, and nothing on the haptic thread would know. It only takes away.
// What the last two leave of a force comes back as SafetyInput::applied_share, so that the observer counts
// what really went out. SAFETY.md beside this file says what each stage does, with its numbers, and why.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "engine/haptics/safety/limits.h"
#include "engine/haptics/safety/stages.h"
#include "engine/haptics/safety/state.h"
#include "engine/math/math.h"

namespace onggi::haptics {

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
