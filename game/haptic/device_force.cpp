#include "game/haptic/device_force.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/stability.h"
#include "game/haptic/tick.h"

namespace onggi::haptic {

DeviceForce device_force(const clay::ContactForces& forces, const dvec3& velocity_mm_s,
                         double viscosity_c2_n_s_per_mm, bool friction_follows_pressure,
                         const DeviceFeel& feel) noexcept {
    DeviceForce force;
    if (forces.contacts == 0) return force;
    const bool too_stiff =
        feel.most_stiffness_n_per_mm > 0.0 && forces.local_stiffness_n_per_mm > feel.most_stiffness_n_per_mm;
    const double share = too_stiff ? feel.most_stiffness_n_per_mm / forces.local_stiffness_n_per_mm : 1.0;
    const dvec3 stiffness_n = forces.stiffness_n * share;
    if (friction_follows_pressure) {
        force.driven_n = forces.friction_n * share;
    } else {
        const double pressed_n = std::sqrt(glm::dot(stiffness_n, stiffness_n));
        force.driven_n = forces.friction_n * std::min(1.0, pressed_n / feel.friction_reference_n);
    }
    force.wanted_n = stiffness_n - velocity_mm_s * viscosity_c2_n_s_per_mm + force.driven_n;
    return force;
}

Result<void> fit_to_device(HapticParameters& parameters, const haptics::DeviceCapabilities& device,
                           bool is_paper) {
    parameters.safety = haptics::limits_for(device);
    parameters.feel = {};
    if (device.force_axes == 0 || !device.has_motors || device.has_own_walls) return {};
    if (is_paper) {
        const clay::PaperParameters& paper = parameters.paper;
        return haptics::check_clay_on_device(
            device, parameters.rate_hz(),
            std::max(paper.stiffness_standing_n_per_mm, paper.stiffness_turning_n_per_mm),
            paper.viscosity_c2_n_s_per_mm);
    }
    // The studio's clay may be anything from slip to leather: it is shown as stiff as the device can.
    constexpr double kStiffEnoughNPerMm = 1.0;
    double most = device.max_stiffness_n_per_mm > 0.0 ? device.max_stiffness_n_per_mm : kStiffEnoughNPerMm;
    if (device.moving_mass_kg > 0.0)
        most = haptics::stiffest_for(device, parameters.rate_hz(), std::min(most, kStiffEnoughNPerMm));
    parameters.feel.most_stiffness_n_per_mm = most;
    return haptics::check_clay_on_device(device, parameters.rate_hz(), most,
                                         parameters.studio.viscosity_c2_n_s_per_mm);
}

}  // namespace onggi::haptic
