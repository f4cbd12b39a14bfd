// The work as the device may show it by itself between two orders: a wall at a radius, of a known stiffness,
// that gives at the tool's place exactly the ordered force. A joystick's own spring or a trigger's resistance
// then answers the hand at the device's speed, not at that of USB. Pure; any thread. mm, N.
// Source: local models of an environment for a slow link, e.g. Adams and Hannaford, "Stable haptic
// interaction with virtual environments", IEEE T-RO 15(3), 1999, for the coupling; the wall is the paper's F
// = K d.
#pragma once

#include <cmath>
#include <optional>

#include "engine/haptics/hid/hand_input.h"

namespace onggi::haptics::hid {

struct LocalWall {
    double contact_mm = 0.0;  // the radius at which the force is zero
    bool is_outside =
        false;  // true: the work lies at smaller radii and pushes outwards; false: the other way
    double stiffness_n_per_mm = 0.0;

    // On a tool at this radius, outwards positive.
    [[nodiscard]] double force_n(double radius_mm) const noexcept {
        const double force = stiffness_n_per_mm * (contact_mm - radius_mm);
        return (force > 0.0) == is_outside ? force : 0.0;
    }
};

// None while the work does not push along the radius.
[[nodiscard]] inline std::optional<LocalWall> local_wall(const ForceOrder& order,
                                                         double stiffness_n_per_mm) noexcept {
    constexpr double kNothingN = 1e-3;
    if (std::abs(order.force_n.x) < kNothingN) return std::nullopt;
    return LocalWall{.contact_mm = order.tool_mm.x + order.force_n.x / stiffness_n_per_mm,
                     .is_outside = order.force_n.x > 0.0,
                     .stiffness_n_per_mm = stiffness_n_per_mm};
}

}  // namespace onggi::haptics::hid
