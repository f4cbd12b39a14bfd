#include "game/haptic/device_force.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/haptics/stability.h"
#include "game/haptic/tick.h"

namespace onggi::haptic {
namespace {

using haptics::DeviceCapabilities;

// The largest stiffness at which any clay is rendered: it already feels hard.
constexpr double kStiffEnoughNPerMm = 1.0;

Error nothing_is_stable(const DeviceCapabilities& device, double rate_hz) {
    return bad_input(
        fmt::format("{}: expected a device on which some clay is stable, found none at {:.0f} Hz",
                    device.name, haptics::loop_of(device, rate_hz).rate_hz));
}

// A device's own walls need no limit; forces sent over its bus are limited to the range that is stable over
// it.
Result<void> fit_to_walls(HapticParameters& parameters, const DeviceCapabilities& device,
                          double viscosity_n_s_per_mm) {
    // A spring whose force grows beyond its stiffness would have to be updated over the bus as the hand
    // moves.
    parameters.feel.most_stiffness_n_per_mm = device.max_stiffness_n_per_mm;
    if (device.wire_rate_hz <= 0.0) return {};
    const double most =
        haptics::stiffest_for(device, parameters.rate_hz(), kStiffEnoughNPerMm, viscosity_n_s_per_mm);
    parameters.feel.most_wire_stiffness_n_per_mm = most;
    return most > 0.0 ? Result<void>() : nothing_is_stable(device, parameters.rate_hz());
}

// Uses the largest stable stiffness, and a smaller one where the clay's viscosity requires it.
Result<void> fit_studio(HapticParameters& parameters, const DeviceCapabilities& device) {
    constexpr double kSofter = 0.9;
    constexpr double kSoftestNPerMm = 0.01;
    const double viscosity = parameters.studio.viscosity_c2_n_s_per_mm;
    const double bound =
        device.max_stiffness_n_per_mm > 0.0 ? device.max_stiffness_n_per_mm : kStiffEnoughNPerMm;
    double most =
        haptics::stiffest_for(device, parameters.rate_hz(), std::min(bound, kStiffEnoughNPerMm), viscosity);
    Result<void> fits = nothing_is_stable(device, parameters.rate_hz());
    for (; !fits && most >= kSoftestNPerMm; most *= kSofter) {
        parameters.feel.most_stiffness_n_per_mm = most;
        fits = haptics::check_work_on_device(device, parameters.rate_hz(), most, viscosity);
    }
    return fits;
}

}  // namespace

DeviceForce device_force(const clay::ContactForces& forces, const dvec3& velocity_mm_s,
                         double viscosity_c2_n_s_per_mm, bool friction_follows_pressure,
                         const DeviceFeel& feel, bool shows_wall) noexcept {
    DeviceForce force;
    if (forces.contacts == 0) return force;
    const bool too_stiff =
        feel.most_stiffness_n_per_mm > 0.0 && forces.local_stiffness_n_per_mm > feel.most_stiffness_n_per_mm;
    const double fraction = too_stiff ? feel.most_stiffness_n_per_mm / forces.local_stiffness_n_per_mm : 1.0;
    const dvec3 stiffness_n = forces.stiffness_n * fraction;
    if (friction_follows_pressure) {
        force.driven_n = forces.friction_n * fraction;
    } else {
        const double pressed_n = std::sqrt(glm::dot(stiffness_n, stiffness_n));
        force.driven_n = forces.friction_n * std::min(1.0, pressed_n / feel.friction_reference_n);
    }
    force.wanted_n = stiffness_n - velocity_mm_s * viscosity_c2_n_s_per_mm + force.driven_n;
    const double shown_n_per_mm = forces.local_stiffness_n_per_mm * fraction;
    if (feel.most_wire_stiffness_n_per_mm > 0.0 && shown_n_per_mm > feel.most_wire_stiffness_n_per_mm) {
        const double wire = feel.most_wire_stiffness_n_per_mm / shown_n_per_mm;
        // Along the wall normal the device's own spring acts, so this axis is not reduced.
        const dvec3 of_axes(shows_wall ? 1.0 : wire, wire, 1.0);
        force.wanted_n *= of_axes;
        force.driven_n *= of_axes;
    }
    return force;
}

Result<void> fit_to_device(HapticParameters& parameters, const haptics::DeviceCapabilities& device,
                           bool is_paper) {
    parameters.safety = haptics::limits_for(device);
    parameters.feel = {};
    if (device.force_axes == 0 || !device.has_motors) return {};
    const clay::PaperParameters& paper = parameters.paper;
    if (device.has_own_walls) {
        return fit_to_walls(
            parameters, device,
            is_paper ? paper.viscosity_c2_n_s_per_mm : parameters.studio.viscosity_c2_n_s_per_mm);
    }
    if (is_paper) {
        return haptics::check_work_on_device(
            device, parameters.rate_hz(),
            std::max(paper.stiffness_standing_n_per_mm, paper.stiffness_turning_n_per_mm),
            paper.viscosity_c2_n_s_per_mm);
    }
    return fit_studio(parameters, device);
}

}  // namespace onggi::haptic
