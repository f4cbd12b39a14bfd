#include "engine/haptics/gesture_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/core/number_in.h"

namespace onggi::haptics {
namespace {

using Complaint = std::optional<std::string>;

Complaint take_number(std::string_view field, double least, double most, double& number) {
    const auto found = number_in<double>(field);
    if (!found || !std::isfinite(*found)) return "a finite number";
    if (*found < least || *found > most) return fmt::format("{} to {}", least, most);
    number = *found;
    return std::nullopt;
}

// The words stand in the order of the enum's numbers.
template <typename Enum>
Complaint take_word(std::string_view field, std::span<const std::string_view> words, Enum& value) {
    const auto found = std::find(words.begin(), words.end(), field);
    if (found == words.end()) return fmt::format("{}", fmt::join(words, ", "));
    value = static_cast<Enum>(found - words.begin());
    return std::nullopt;
}

Complaint take_bit(std::string_view field, bool& bit) {
    if (field != "0" && field != "1") return "0 or 1";
    bit = field == "1";
    return std::nullopt;
}

// The columns' names in the order of GestureColumn, kNotOurs excepted; empty where the work names them.
constexpr std::array<std::string_view, 15> kNames{
    "tool",       "side",       "water",      "wheel_rev_min",   "assist_gap_mm", "shaft_mm", "",        "",
    "hand2_x_mm", "hand2_y_mm", "hand2_z_mm", "hand2_radius_mm", "hand2_tool",    "guided",   "pressing"};

constexpr std::array<std::string_view, 4> kSides{"auto", "outer", "inner", "rim"};

Complaint take_coordinate(std::string_view field, double& number, bool& present) {
    auto complaint = take_number(field, -kWorkspaceMm, kWorkspaceMm, number);
    present = !complaint;
    return complaint;
}

}  // namespace

GestureColumn gesture_column(std::string_view name, const GestureWords& words) {
    if (name.empty()) return GestureColumn::kNotOurs;
    if (name == words.command) return GestureColumn::kCommand;
    if (name == words.command_height) return GestureColumn::kCommandHeight;
    const auto column =
        static_cast<GestureColumn>(std::find(kNames.begin(), kNames.end(), name) - kNames.begin());
    const bool is_tool = column == GestureColumn::kTool || column == GestureColumn::kSecondTool;
    return is_tool && words.tools.empty() ? GestureColumn::kNotOurs : column;
}

std::optional<std::string> take_field(GestureColumn column, std::string_view field, const GestureWords& words,
                                      ToolState& tool) {
    if (field.empty()) return std::nullopt;
    SecondHand& second = tool.second;
    switch (column) {
        case GestureColumn::kTool:
            return take_word(field, words.tools, tool.tool);
        case GestureColumn::kSide:
            return take_word(field, kSides, tool.side);
        case GestureColumn::kWater:
            return take_number(field, 0.0, 1.0, tool.water);
        case GestureColumn::kWheelSpeed:
            return take_number(field, 0.0, kMaxWheelSpeedRevMin, tool.wheel_speed_rev_min);
        case GestureColumn::kAssistGap:
            return take_number(field, 0.0, kMaxAssistGapMm, tool.assist_gap_mm);
        case GestureColumn::kShaft:
            return take_number(field, 0.0, kMaxToolRadiusMm, tool.shaft_mm);
        case GestureColumn::kCommand:
            return take_word(field, words.commands, tool.command);
        case GestureColumn::kCommandHeight:
            return take_number(field, 0.0, kWorkspaceMm, tool.command_height_mm);
        case GestureColumn::kSecondX:
            return take_coordinate(field, second.position_mm.x, second.present);
        case GestureColumn::kSecondY:
            return take_number(field, -kWorkspaceMm, kWorkspaceMm, second.position_mm.y);
        case GestureColumn::kSecondZ:
            return take_number(field, -kWorkspaceMm, kWorkspaceMm, second.position_mm.z);
        case GestureColumn::kSecondRadius:
            return take_number(field, kMinToolRadiusMm, kMaxToolRadiusMm, second.radius_mm);
        case GestureColumn::kSecondTool:
            return take_word(field, words.tools, second.tool);
        case GestureColumn::kGuided:
            return take_bit(field, tool.guided);
        case GestureColumn::kPressing:
            return take_bit(field, tool.pressing);
        case GestureColumn::kNotOurs:
            break;
    }
    return std::nullopt;
}

std::optional<std::string_view> missing_column(const std::vector<GestureColumn>& columns,
                                               const GestureWords& words) {
    using enum GestureColumn;
    const auto has = [&](GestureColumn column) {
        return std::find(columns.begin(), columns.end(), column) != columns.end();
    };
    if (has(kCommand) && !has(kCommandHeight)) return words.command_height;
    constexpr std::array kSecond{kSecondX, kSecondY, kSecondZ, kSecondRadius, kSecondTool};
    if (std::none_of(kSecond.begin(), kSecond.end(), has)) return std::nullopt;
    for (const GestureColumn column : std::span(kSecond).first(3)) {
        if (!has(column)) return kNames[static_cast<std::size_t>(column)];
    }
    return std::nullopt;
}

}  // namespace onggi::haptics
