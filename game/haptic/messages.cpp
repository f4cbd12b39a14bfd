#include "game/haptic/messages.h"

namespace onggi::haptic {

Snapshot first_snapshot(const HapticState& start) {
    Snapshot first;
    first.radii_mm.resize(start.clay.radii_mm().size());
    fill_snapshot(first, start, {});
    return first;
}

void fill_snapshot(Snapshot& snapshot, const HapticState& state, const TickResult& result) noexcept {
    snapshot.tick = state.ticks;
    snapshot.tool = state.tool;
    snapshot.forces = result.forces;
    snapshot.limited_force_n = result.limited_force_n;
    snapshot.fault = state.safety.fault;
    snapshot.wheel_direction = {state.wheel.heading().cosine, state.wheel.heading().sine};
    snapshot.wheel_turning = state.tool.wheel_button;
    state.clay.copy_radii_mm(snapshot.radii_mm);
}

}  // namespace onggi::haptic
