// The columns right of tool_radius_mm that a clay with an inside understands. Any other name is somebody
// else's, and its values are not looked at. Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/tool_state.h"

namespace onggi::haptics {

enum class GestureColumn {
    kTool,        // hand, rib, sponge or trimmer
    kSide,        // auto, outer, inner or rim: where a hand that comes to the clay means to be
    kWater,       // 0 to 1: how wet hand or sponge is
    kWheelSpeed,  // rev/min of the pedal while the button is 1
    kAssistGap,   // mm between the hand and a second one held opposite; 0: none
    kShaft,       // mm, radius of what carries an inside tool from above
    kWire,        // none, rim or off
    kWireHeight,  // mm
    kSecondX,     // mm; empty in a row in which there is no second hand
    kSecondY,
    kSecondZ,
    kSecondRadius,  // mm; without the column as large as the first
    kSecondTool,    // as tool
    kGuided,        // 0 or 1: the place is a finger's, which skilled hands follow
    kPressing,      // 0 or 1: without it no hand is in the clay
    kNotOurs,
};

// The columns' names, kNotOurs excepted, in the order of the numbers.
constexpr std::array<std::string_view, 15> kGestureColumns{
    "tool",       "side",      "water",      "wheel_rev_min", "assist_gap_mm", "shaft_mm",
    "wire",       "wire_y_mm", "hand2_x_mm", "hand2_y_mm",    "hand2_z_mm",    "hand2_radius_mm",
    "hand2_tool", "guided",    "pressing"};

[[nodiscard]] GestureColumn gesture_column(std::string_view name);

// Whether it is one of the three that say where the second hand is.
[[nodiscard]] constexpr bool is_place_of_second(GestureColumn column) {
    return column == GestureColumn::kSecondX || column == GestureColumn::kSecondY ||
           column == GestureColumn::kSecondZ;
}

// Takes one field of one row. An empty one leaves what the row has by default. Gives what was expected where
// the field is not that.
[[nodiscard]] std::optional<std::string> take_field(GestureColumn column, std::string_view field,
                                                    ToolState& tool);

// The name of a column that one of these needs and that is not among them: a wire its height, a second hand
// its whole place.
[[nodiscard]] std::optional<std::string_view> missing_column(const std::vector<GestureColumn>& columns);

}  // namespace onggi::haptics
