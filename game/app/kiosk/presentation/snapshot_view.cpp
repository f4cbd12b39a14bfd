#include "game/app/kiosk/presentation/snapshot_view.h"

#include "game/app/kiosk/presentation/guided_hands.h"

namespace onggi::app {

wheel::WheelView wheel_view(const haptic::Snapshot& snapshot) {
    const haptic::TickResult& result = snapshot.result;
    const clay::StudioInput told = haptic::studio_input(snapshot.tool);
    wheel::WheelView shown{.pot = snapshot.pot,
                           .peak_load = snapshot.load.index,
                           .peak_load_height_mm = snapshot.load.height_mm,
                           .peak_load_cause = snapshot.load.cause,
                           .wire_shown = told.wire != clay::Wire::kNone,
                           .wire_height_mm = told.wire_height_mm,
                           .wheel_direction = snapshot.wheel_direction,
                           .wheel_turning = snapshot.wheel_turning,
                           .wheel_speed_rad_s = snapshot.wheel_speed_rad_s,
                           .contacts = result.forces.contacts};
    shown.hand = {.position_mm = snapshot.tool.position_mm,
                  .radius_mm = snapshot.tool.radius_mm,
                  .tool = told.hand.tool,
                  .side = result.side,
                  .touching = result.forces.contacts > 0};
    const bool assists = result.has_second && !told.has_second;  // with the first hand's size
    shown.second_hand = {
        .position_mm = result.has_second ? result.second_position_mm : told.second.position_mm,
        .radius_mm = assists ? told.hand.radius_mm : told.second.radius_mm,
        .tool = assists ? clay::StudioTool::kHand : told.second.tool,
        .side = result.second_side,
        .shown = result.has_second || told.has_second,
        .touching = result.second_forces.contacts > 0};
    if (snapshot.tool.guided) show_guided_hands(shown, snapshot);
    return shown;
}

}  // namespace onggi::app
