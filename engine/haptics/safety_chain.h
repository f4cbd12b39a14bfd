// What stands between the clay's forces and a visitor's hand: an ordered list of pure stages. Any one thread
// at a time; the whole chain takes some tens of ns, allocates nothing and cannot fail. mm, N, s.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/haptics/haptic_device.h"
#include "engine/haptics/tool_state.h"
#include "engine/math/math.h"

namespace onggi::haptics {

// The kiosk's profile; a weaker device lowers it, a stronger one never raises it.
constexpr double kKioskPeakForceN = 3.3;

struct SafetyLimits {
    double peak_force_n = kKioskPeakForceN;
    double slew_n_per_s = 200.0;         // how fast the force may grow or turn
    double release_n_per_s = 2000.0;     // how fast it may fall: 3.3 N are gone in 2 ms
    double ramp_s = 1.0;                 // from nothing to full force, at the start and after a fault
    double small_force_n = 0.2;          // the ramp begins only after a force below this ...
    int small_force_ticks = 3;           // ... for more than so many ticks in a row: no start inside a wall
    double workspace_mm = kWorkspaceMm;  // each coordinate within +-
};

// The profile, lowered to what the device can give.
[[nodiscard]] SafetyLimits limits_for(const DeviceCapabilities& device);

enum class Fault : std::uint8_t { kNone, kForceNotFinite, kPositionNotFinite, kOutsideWorkspace };
// For logs and screens: what was wrong, in words.
[[nodiscard]] std::string_view words_for(Fault fault);

struct SafetyState {
    dvec3 applied_force_n{0.0};     // what the device got last
    double ramp = 0.0;              // 0 to 1
    int calm_ticks = 0;             // ticks in a row with a small force, while the ramp waits
    Fault fault = Fault::kNone;     // latched: zero force until rearm()
    std::uint32_t fault_count = 0;  // faults since the state was made
};

// Takes a latched fault back. The force starts again from nothing, through the ramp; a cause that persists
// latches again on the next tick.
void rearm(SafetyState& state) noexcept;

struct SafetyInput {
    dvec3 position_mm{0.0};  // of the tool
    double dt_s = 0.0;       // the fixed step
};

// The stages, each usable and tested alone; force in, force out.
// gate: a force or position that is not finite, or a tool outside the workspace, latches a fault; zero force
// as long as one is latched.
dvec3 gate(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;
// ramp: nothing until the force has been small for a moment, then growing from 0 to 1 times the force.
dvec3 ramp(const dvec3& force_n, const SafetyInput&, const SafetyLimits&, SafetyState&) noexcept;
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

// The order is the chain's meaning: nothing that is not finite may reach the arithmetic, the clamp bounds
// what the slew aims at, and the slew is last because it alone knows what the device got before.
inline constexpr std::array<SafetyStage, 4> kSafetyChain{{
    {"gate", "zero force and a latched fault on NaN, infinity or a tool outside the workspace", &gate},
    {"ramp", "from nothing to full force at the start and after a fault, once the force is small", &ramp},
    {"clamp", "at most the peak force, direction kept", &clamp},
    {"slew", "bounded change from tick to tick; letting go is faster than pushing", &slew},
}};

// The whole chain: the clay's force in, what the device may get out.
dvec3 apply_safety_chain(const dvec3& force_n, const SafetyInput& input, const SafetyLimits& limits,
                         SafetyState& state) noexcept;

}  // namespace onggi::haptics
