#include "game/haptic/work_felt.h"

#include <algorithm>
#include <numbers>

namespace onggi::haptic {
namespace {

constexpr double kKpaPerNMm2 = 1000.0;

}  // namespace

haptics::WorkFelt work_felt(const HapticState& state, const TickResult& result,
                            const HapticParameters& parameters) noexcept {
    haptics::WorkFelt felt{.touches = result.forces.contacts > 0,
                           .stiffness_n_per_mm = result.forces.local_stiffness_n_per_mm};
    if (parameters.feel.most_stiffness_n_per_mm > 0.0)
        felt.stiffness_n_per_mm = std::min(felt.stiffness_n_per_mm, parameters.feel.most_stiffness_n_per_mm);
    const clay::StudioClay* studio = state.studio();
    if (studio == nullptr) {
        felt.wheel_rad_s = state.tool.wheel_button ? parameters.paper.wheel_speed_rad_s : 0.0;
        return felt;
    }
    felt.wheel_rad_s = studio->wheel().speed_rad_s();
    felt.load = studio->load_index();
    const clay::studio::Rings& rings = studio->rings();
    if (rings.count == 0 || !felt.touches) return felt;
    const int ring = rings.ring_at(state.tool.position_mm.y);
    if (!rings.is_hollow(ring)) return felt;
    felt.wall_mm = rings.wall_mm(ring);
    // The force with which a wall of that thickness bends aside: the studio clay's own limit (force.h).
    const double strength_n_mm2 =
        static_cast<double>(rings.strength_kpa[static_cast<std::size_t>(ring)]) / kKpaPerNMm2;
    felt.most_force_n = 2.0 * std::numbers::pi * strength_n_mm2 * felt.wall_mm * felt.wall_mm;
    return felt;
}

}  // namespace onggi::haptic
