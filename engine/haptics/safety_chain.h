// What stands between the clay's forces and a visitor's hand: an ordered list of pure stages. Any one thread
// at a time; the whole chain takes some tens of ns, allocates nothing and cannot fail. mm, N, s.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "engine/haptics/haptic_device.h"
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
// force comes before the observer, so that it judges the force the clay shall have; what takes force away for
// a person's sake comes after it, so that not even its damping is felt by nobody. The clamp bounds what the
// slew aims at, and the slew is last because it alone knows what the device got before.
inline constexpr std::array<SafetyStage, 9> kSafetyChain{{
    {"gate", "zero force and a latched fault on NaN, infinity, a tool outside the workspace, or stop", &gate},
    {"speed", "a tool too fast in contact is braked, then let go", &speed},
    {"late", "a softer clay while the loop misses periods", &late},
    {"passivity", "damping that takes back what the sampled loop gave too much", &passivity},
    {"hand", "no force without a hand, or when its position is stale", &hand},
    {"ramp", "from nothing to full force at the start and after a fault, once the force is small", &ramp},
    {"budget", "the peak force for a moment, the continuous force for ever", &budget},
    {"clamp", "at most the peak force, direction kept", &clamp},
    {"slew", "bounded change from tick to tick; letting go is faster than pushing", &slew},
}};

// The whole chain: the clay's force in, what the device may get out.
dvec3 apply_safety_chain(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
                         SafetyState& state) noexcept;

// Any stages in their order. What remembers the applied force is the slew; without it the caller's force is
// remembered here.
dvec3 apply_stages(std::span<const SafetyStage> stages, const dvec3& force_n, const SafetyInput& input,
                   const SafetyLimits& limits, SafetyState& state) noexcept;

// For a log or a person: the stages in their order with what each does, one a line.
[[nodiscard]] std::string describe_safety_chain();
// The state's counters in one line: fault, ramp, gain, energy taken and given, heat.
[[nodiscard]] std::string describe(const SafetyState& state, const SafetyLimits& limits);

}  // namespace onggi::haptics
