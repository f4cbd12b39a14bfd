#include "game/app/kiosk/snapshot_view.h"

#include "game/app/kiosk/guided_hands.h"

namespace onggi::app {

wheel::PotView pot_view(const haptic::Snapshot& snapshot) {
    const haptic::PotShape& shape = *snapshot.shape;
    const haptic::TickResult& result = snapshot.result;
    const clay::StudioInput told = haptic::studio_input(snapshot.tool);
    wheel::PotView pot{.radii_mm = shape.outer_mm(),
                       .inner_mm = shape.inner_mm(),
                       .top_mm = shape.top_mm(),
                       .height_mm = shape.height_mm,
                       .floor_mm = shape.floor_mm,
                       .centre_mm = shape.centre_mm(),
                       .dents_mm = shape.dents_mm(),
                       .dent_sectors = haptic::kDentSectors,
                       .film = shape.film(),
                       .liquidity = shape.liquidity(),
                       .load_index = shape.load_index(),
                       .peak_load = snapshot.load.index,
                       .peak_load_height_mm = snapshot.load.height_mm,
                       .peak_load_cause = snapshot.load.cause,
                       .wire_shown = told.wire != clay::Wire::kNone,
                       .wire_height_mm = told.wire_height_mm,
                       .wheel_direction = snapshot.wheel_direction,
                       .wheel_turning = snapshot.wheel_turning,
                       .wheel_speed_rad_s = snapshot.wheel_speed_rad_s,
                       .contacts = result.forces.contacts,
                       .body = snapshot.body};
    pot.hand = {.position_mm = snapshot.tool.position_mm,
                .radius_mm = snapshot.tool.radius_mm,
                .tool = told.hand.tool,
                .side = result.side,
                .touching = result.forces.contacts > 0};
    const bool assists = result.has_second && !told.has_second;  // with the first hand's size
    pot.second_hand = {.position_mm = result.has_second ? result.second_position_mm : told.second.position_mm,
                       .radius_mm = assists ? told.hand.radius_mm : told.second.radius_mm,
                       .tool = assists ? clay::StudioTool::kHand : told.second.tool,
                       .side = result.second_side,
                       .shown = result.has_second || told.has_second,
                       .touching = result.second_forces.contacts > 0};
    if (snapshot.tool.guided) show_guided_hands(pot, snapshot);
    return pot;
}

haptic::PotShape shrunk(haptic::PotShape shape, double scale) {
    shape.height_mm *= scale;
    shape.floor_mm *= scale;
    for (auto* lengths :
         {&shape.outer_mm_, &shape.inner_mm_, &shape.top_mm_, &shape.centre_mm_, &shape.dents_mm_}) {
        for (float& length : *lengths)
            length = static_cast<float>(static_cast<double>(length) * scale);
    }
    return shape;
}

}  // namespace onggi::app
