#include "game/haptic/tick.h"

#include <cassert>

#include "engine/core/hash.h"

namespace onggi::haptic {

// The clay may not include the devices' room, and neither may be wider than the other.
static_assert(clay::kSmallestToolMm == haptics::kMinToolRadiusMm);
static_assert(clay::kLargestToolMm == haptics::kMaxToolRadiusMm);

std::uint64_t HapticState::hash() const {
    StateHash hash;
    hash.add_word(clay.state_hash());
    hash.add(wheel.heading().cosine);
    hash.add(wheel.heading().sine);
    hash.add_word(ticks);
    return hash.value();
}

void HapticState::restart_from(const HapticState& fresh) noexcept {
    assert(clay.element_count() == fresh.clay.element_count());
    clay = fresh.clay;
    wheel = fresh.wheel;
    tool = fresh.tool;
    ticks = fresh.ticks;
}

TickResult tick(HapticState& state, const haptics::ToolState& tool,
                const HapticParameters& parameters) noexcept {
    const double dt_s = parameters.dt_s();
    state.tool = haptics::within_limits(tool, state.tool);
    if (state.tool.wheel_button) state.wheel.turn(parameters.clay.wheel_speed_rad_s * dt_s);

    TickResult result;
    result.forces = state.clay.tick({.position_mm = state.tool.position_mm,
                                     .radius_mm = state.tool.radius_mm,
                                     .wheel_turning = state.tool.wheel_button},
                                    parameters.clay);
    // The gate judges what the device really said, not what the clay was told.
    result.limited_force_n =
        haptics::apply_safety_chain(result.forces.total_n(), {.position_mm = tool.position_mm, .dt_s = dt_s},
                                    parameters.safety, state.safety);

    ++state.ticks;
    result.hash_due = state.ticks % record::kHashInterval == 0;
    if (result.hash_due) result.state_hash = state.hash();
    return result;
}

}  // namespace onggi::haptic
