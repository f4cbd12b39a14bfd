// All fields of a tool as bytes, little-endian: both hands' x, y, z; both radii, the assist's gap, the wire's
// height, the wheel's speed, the shaft, the water (doubles); button, tool, side, wire, presence of a second
// hand, its tool, guided, pressing (bytes). Reading is fit for the tick.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "game/tool/tool_state.h"

namespace onggi::tool {

constexpr std::size_t kBothPositionsBytes = 6 * 8;
constexpr std::size_t kWholeToolBytes = kBothPositionsBytes + 7 * 8 + 8;

void put_whole_tool(std::vector<std::byte>& bytes, const ToolState& tool);
void put_both_positions(std::vector<std::byte>& bytes, const ToolState& tool);

// Precondition: `bytes` holds kWholeToolBytes in which fault_of_whole_tool() finds no fault.
[[nodiscard]] ToolState get_whole_tool(const std::byte* bytes) noexcept;
void get_both_positions(const std::byte* bytes, ToolState& tool) noexcept;

// A value outside a tool's limits, and its offset.
struct ToolFault {
    std::size_t offset = 0;
    std::string expected;
    std::string found;
};
[[nodiscard]] std::optional<ToolFault> fault_of_whole_tool(const std::byte* bytes);
[[nodiscard]] std::optional<ToolFault> fault_of_both_positions(const std::byte* bytes);

}  // namespace onggi::tool
