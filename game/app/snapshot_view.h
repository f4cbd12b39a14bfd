// What the picture needs of a snapshot of the haptic loop. Main thread.
#pragma once

#include "game/haptic/messages.h"
#include "game/wheel/pot_view.h"

namespace onggi::app {

// Refers to the snapshot's radii.
[[nodiscard]] inline wheel::PotView pot_view(const haptic::Snapshot& snapshot, double height_mm) {
    return {.radii_mm = snapshot.radii_mm,
            .height_mm = height_mm,
            .tool_position_mm = snapshot.tool.position_mm,
            .tool_radius_mm = snapshot.tool.radius_mm,
            .tool_shown = true,
            .wheel_direction = snapshot.wheel_direction,
            .wheel_turning = snapshot.wheel_turning,
            .contacts = snapshot.forces.contacts};
}

}  // namespace onggi::app
