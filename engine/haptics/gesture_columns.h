// The columns right of tool_radius_mm that are understood. Any other name is somebody else's, and its values
// are not looked at. Any thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/tool_state.h"

namespace onggi::haptics {

// The words of a table that are not ours: those of the work that the gesture is meant for.
struct GestureWords {
    std::span<const std::string_view> tools{};  // in the order of ToolKind's numbers; none: no such columns
    std::span<const std::string_view> commands{};  // in the order of WorkCommand's
    std::string_view command{};                    // what the columns are called; empty: there are none
    std::string_view command_height{};
};

enum class GestureColumn {
    kTool,           // one of GestureWords::tools
    kSide,           // auto, outer, inner or rim: where a hand that comes to the work means to be
    kWater,          // 0 to 1: how wet the hand or its tool is
    kWheelSpeed,     // rev/min of the pedal while the button is 1
    kAssistGap,      // mm between the hand and a second one held opposite; 0: none
    kShaft,          // mm, radius of what carries an inside tool from above
    kCommand,        // one of GestureWords::commands
    kCommandHeight,  // mm
    kSecondX,        // mm; empty in a row in which there is no second hand
    kSecondY,
    kSecondZ,
    kSecondRadius,  // mm; without the column as large as the first
    kSecondTool,    // as tool
    kGuided,        // 0 or 1: the place is a finger's, which skilled hands follow
    kPressing,      // 0 or 1: without it no hand is in the work
    kNotOurs,
};

[[nodiscard]] GestureColumn gesture_column(std::string_view name, const GestureWords& words);

// Whether it is one of the three that say where the second hand is.
[[nodiscard]] constexpr bool is_place_of_second(GestureColumn column) {
    return column == GestureColumn::kSecondX || column == GestureColumn::kSecondY ||
           column == GestureColumn::kSecondZ;
}

// Takes one field of one row. An empty one leaves what the row has by default. Gives what was expected where
// the field is not that.
[[nodiscard]] std::optional<std::string> take_field(GestureColumn column, std::string_view field,
                                                    const GestureWords& words, ToolState& tool);

// The name of a column that one of these needs and that is not among them: a command its height, a second
// hand its whole place.
[[nodiscard]] std::optional<std::string_view> missing_column(const std::vector<GestureColumn>& columns,
                                                             const GestureWords& words);

}  // namespace onggi::haptics
