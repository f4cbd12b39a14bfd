#include "game/tool/tool_bytes.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "engine/core/little_endian.h"

namespace onggi::tool {

using little_endian::get_double;
using little_endian::put;

namespace {

// The doubles after the positions, in the order of the file.
struct Number {
    std::string_view what;
    double least;
    double most;
};
constexpr std::array kNumbers{Number{"a tool radius, mm", kMinToolRadiusMm, kMaxToolRadiusMm},
                              Number{"a second tool radius, mm", kMinToolRadiusMm, kMaxToolRadiusMm},
                              Number{"an assist's gap, mm", 0.0, kMaxAssistGapMm},
                              Number{"a command's height, mm", 0.0, haptics::kWorkspaceMm},
                              Number{"a wheel's speed, rev/min", 0.0, kMaxWheelSpeedRevMin},
                              Number{"a shaft's radius, mm", 0.0, kMaxToolRadiusMm},
                              Number{"water", 0.0, 1.0}};

template <typename State>
auto numbers_of(State& tool) {
    return std::array{&tool.radius_mm,      &tool.second.radius_mm,    &tool.assist_gap_mm,
                      &tool.wire_height_mm, &tool.wheel_speed_rev_min, &tool.shaft_mm,
                      &tool.water};
}

// The bytes after the doubles, in the order of the file.
struct Choice {
    std::string_view what;
    unsigned most;
};
constexpr std::array kChoices{Choice{"a button", 1},      Choice{"a tool", kClayTools - 1},
                              Choice{"a side", 3},        Choice{"a command", kWireWords.size() - 1},
                              Choice{"a second hand", 1}, Choice{"a second tool", kClayTools - 1},
                              Choice{"being guided", 1},  Choice{"pressing", 1}};

constexpr std::size_t kChoicesAt = kBothPositionsBytes + kNumbers.size() * 8;
static_assert(kChoicesAt + kChoices.size() == kWholeToolBytes);

unsigned byte_at(const std::byte* bytes, std::size_t choice) {
    return std::to_integer<unsigned>(bytes[kChoicesAt + choice]);
}

std::optional<ToolFault> fault_of(const std::byte* bytes, std::size_t offset, const Number& number) {
    const double found = get_double(bytes + offset);
    if (found >= number.least && found <= number.most) return std::nullopt;
    return ToolFault{offset, fmt::format("{} of {} to {}", number.what, number.least, number.most),
                     fmt::format("{}", found)};
}

}  // namespace

void put_both_positions(std::vector<std::byte>& bytes, const ToolState& tool) {
    for (const dvec3& at : {tool.position_mm, tool.second.position_mm}) {
        put(bytes, at.x);
        put(bytes, at.y);
        put(bytes, at.z);
    }
}

void put_whole_tool(std::vector<std::byte>& bytes, const ToolState& tool) {
    put_both_positions(bytes, tool);
    for (const double* number : numbers_of(tool))
        put(bytes, *number);
    for (const unsigned choice :
         {unsigned{tool.wheel_button}, static_cast<unsigned>(tool.tool), static_cast<unsigned>(tool.side),
          static_cast<unsigned>(tool.wire), unsigned{tool.second.present},
          static_cast<unsigned>(tool.second.tool), unsigned{tool.guided}, unsigned{tool.pressing}})
        bytes.push_back(static_cast<std::byte>(choice));
}

void get_both_positions(const std::byte* bytes, ToolState& tool) noexcept {
    tool.position_mm = {get_double(bytes), get_double(bytes + 8), get_double(bytes + 16)};
    tool.second.position_mm = {get_double(bytes + 24), get_double(bytes + 32), get_double(bytes + 40)};
}

ToolState get_whole_tool(const std::byte* bytes) noexcept {
    ToolState tool;
    get_both_positions(bytes, tool);
    std::size_t at = kBothPositionsBytes;
    for (double* number : numbers_of(tool)) {
        *number = get_double(bytes + at);
        at += 8;
    }
    tool.wheel_button = byte_at(bytes, 0) == 1;
    tool.tool = static_cast<Tool>(byte_at(bytes, 1));
    tool.side = static_cast<Side>(byte_at(bytes, 2));
    tool.wire = static_cast<Wire>(byte_at(bytes, 3));
    tool.second.present = byte_at(bytes, 4) == 1;
    tool.second.tool = static_cast<Tool>(byte_at(bytes, 5));
    tool.guided = byte_at(bytes, 6) == 1;
    tool.pressing = byte_at(bytes, 7) == 1;
    return tool;
}

std::optional<ToolFault> fault_of_both_positions(const std::byte* bytes) {
    constexpr Number kCoordinate{"a coordinate, mm,", -haptics::kWorkspaceMm, haptics::kWorkspaceMm};
    for (std::size_t at = 0; at < kBothPositionsBytes; at += 8) {
        if (auto fault = fault_of(bytes, at, kCoordinate)) return fault;
    }
    return std::nullopt;
}

std::optional<ToolFault> fault_of_whole_tool(const std::byte* bytes) {
    if (auto fault = fault_of_both_positions(bytes)) return fault;
    for (std::size_t i = 0; i < kNumbers.size(); ++i) {
        if (auto fault = fault_of(bytes, kBothPositionsBytes + i * 8, kNumbers[i])) return fault;
    }
    for (std::size_t i = 0; i < kChoices.size(); ++i) {
        if (const unsigned found = byte_at(bytes, i); found > kChoices[i].most) {
            return ToolFault{kChoicesAt + i, fmt::format("{} of 0 to {}", kChoices[i].what, kChoices[i].most),
                             fmt::format("{}", found)};
        }
    }
    return std::nullopt;
}

}  // namespace onggi::tool
