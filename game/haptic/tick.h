// One haptic tick as a pure function of state and input: clay, wheel and safety, no thread and no clock.
// The same inputs give the same bits everywhere (live, throw, replay). Any one thread at a time; the tick
// allocates nothing and cannot fail. mm, N, s, rad.
#pragma once

#include <cstdint>
#include <utility>

#include "engine/haptics/safety_chain.h"
#include "engine/haptics/tool_state.h"
#include "engine/record/session_format.h"
#include "game/clay/paper_clay.h"
#include "game/clay/wheel_angle.h"

namespace onggi::haptic {

struct HapticParameters {
    clay::PaperParameters clay;  // holds the tick rate; clay::check() must hold
    haptics::SafetyLimits safety;

    [[nodiscard]] double dt_s() const { return 1.0 / clay.rate_hz; }
};

// All that a later tick depends on.
struct HapticState {
    HapticState() = default;
    explicit HapticState(clay::PaperClay start) : clay(std::move(start)) {}

    clay::PaperClay clay;
    clay::WheelAngle wheel;
    // The tool of the last tick, within its limits: what is recorded. Far above the clay before the first.
    haptics::ToolState tool{.position_mm = {0.0, haptics::kWorkspaceMm, 0.0}};
    haptics::SafetyState safety;  // of the device, not of the clay: it outlives a fresh lump
    std::uint64_t ticks = 0;      // since the lump was fresh

    // Of what makes the clay and the wheel what they are, not of the device's safety: a replay has no device.
    [[nodiscard]] std::uint64_t hash() const;
    // Puts a fresh lump on the wheel; the safety state stays. No allocation when `fresh` has as many
    // elements.
    void restart_from(const HapticState& fresh) noexcept;
};

struct TickResult {
    clay::ContactForces forces;    // Eqs. (5) to (7); their sum F of Eq. (3) is what is recorded
    dvec3 limited_force_n{0.0};    // what goes to the device
    bool hash_due = false;         // this tick was the last of a run of record::kHashInterval
    std::uint64_t state_hash = 0;  // after this tick, when due
};

// Takes the tool, turns the wheel and the clay by one fixed step and works out the forces. The wheel turns
// exactly while its button is held: at full speed at once, as in the paper.
TickResult tick(HapticState& state, const haptics::ToolState& tool,
                const HapticParameters& parameters) noexcept;

}  // namespace onggi::haptic
