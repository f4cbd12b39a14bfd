#include "game/haptic/messages.h"

#include <cmath>

namespace onggi::haptic {

Snapshot first_snapshot(const HapticState& start, const HapticParameters& parameters) {
    Snapshot first;
    fill_snapshot(first, start, {}, parameters);
    return first;
}

void fill_snapshot(Snapshot& snapshot, const HapticState& state, const TickResult& result,
                   const HapticParameters& parameters) noexcept {
    snapshot.tick = state.ticks;
    snapshot.tool = state.tool;
    snapshot.result = result;
    snapshot.fault = state.safety.fault;
    snapshot.safety = {.ramp = state.safety.ramp,
                       .gain = state.safety.gain,
                       .presence = state.safety.presence,
                       .energy_mj = state.safety.energy_mj,
                       .taken_mj = state.safety.taken_mj,
                       .given_mj = state.safety.given_mj,
                       .damping_n_s_per_mm = state.safety.damping_n_s_per_mm,
                       .mean_force_n = std::sqrt(state.safety.heat_n2),
                       .late_periods = state.safety.late_count,
                       .fault_count = state.safety.fault_count,
                       .speed_stops = state.safety.speed_stops};
    snapshot.wheel_direction = {state.heading().cosine, state.heading().sine};
    const clay::StudioClay* studio = state.studio();
    if (studio == nullptr) {
        snapshot.wheel_turning = state.tool.wheel_button;
        snapshot.wheel_speed_rad_s = snapshot.wheel_turning ? parameters.paper.wheel_speed_rad_s : 0.0;
        return;
    }
    snapshot.wheel_speed_rad_s = studio->wheel().speed_rad_s();
    snapshot.wheel_turning = snapshot.wheel_speed_rad_s > 0.0;
    const clay::studio::Rings& rings = studio->rings();
    const double loaded_mm = studio->load_height_mm();
    snapshot.load = {
        .index = studio->load_index(),
        .height_mm = loaded_mm,
        .cause = studio->load_cause(),
        .strength_kpa = rings.count > 0
                            ? double{rings.strength_kpa[static_cast<std::size_t>(rings.ring_at(loaded_mm))]}
                            : 0.0,
        .failure = studio->failure()};
    snapshot.on_wheel_mm3 = studio->ledger().on_wheel_mm3();
    snapshot.hand_film = studio->film();
    snapshot.is_cut_off = studio->is_cut_off();
    snapshot.body = studio->lump().body;
}

}  // namespace onggi::haptic
