// One haptic tick as a pure function of state and input: clay, wheel and safety, no thread and no clock.
// The same inputs give the same bits everywhere (live, throw, replay). Any one thread at a time; the tick
// allocates nothing and cannot fail. mm, N, s, rad.
#pragma once

#include <cstdint>

#include "engine/haptics/safety_chain.h"
#include "engine/haptics/tool_state.h"
#include "engine/math/math.h"
#include "game/clay/paper_clay.h"

namespace onggi::haptic {

// A state hash is taken after every so many ticks; a session stores them, replay compares them.
constexpr std::uint64_t kTicksPerHash = 1000;

struct HapticParameters {
    clay::PaperParameters clay;  // holds the tick rate
    haptics::SafetyLimits safety;

    [[nodiscard]] double dt_s() const { return 1.0 / clay.rate_hz; }
};

// All that a later tick depends on.
struct HapticState {
    explicit HapticState(const clay::PaperLump& lump = {}) : clay(lump) {}

    clay::PaperClay clay;
    dvec2 wheel_direction{1.0, 0.0};  // cos and sin of the wheel's angle, seen from above, counter-clockwise
    haptics::SafetyState safety;      // of the device, not of the clay: it outlives a fresh lump
    std::uint64_t ticks = 0;          // since the lump was fresh

    // Of the clay, the wheel and the count, not of the device's safety: a replay has no device. No
    // allocation.
    [[nodiscard]] std::uint64_t hash() const;
    // Puts a fresh lump on the wheel; the safety state stays. No allocation when `fresh` has as many
    // elements.
    void restart_from(const HapticState& fresh) noexcept;
};

struct TickResult {
    clay::ContactForces forces;    // Eqs. (5) to (7); their sum F of Eq. (3) is what is recorded
    dvec3 limited_force_n{0.0};    // what goes to the device
    bool hash_due = false;         // this tick ended a run of kTicksPerHash
    std::uint64_t state_hash = 0;  // when due
};

// Reads the tool, moves wheel and clay by one fixed step and works out the forces. The wheel turns exactly
// while its button is held: at once, as in the paper.
TickResult tick(HapticState& state, const haptics::ToolState& tool,
                const HapticParameters& parameters) noexcept;

}  // namespace onggi::haptic
