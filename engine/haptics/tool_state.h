// What a hand does at one instant: the one form in which every device, gesture, session and tick speaks of
// it. mm, rev/min.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/math/math.h"

namespace onggi::haptics {

// What is in the hand: nothing, or a tool by its number. What each is, who made the work knows. The numbers
// are in files: never renumber.
enum class ToolKind : std::uint8_t { kHand = 0 };
constexpr unsigned kToolKinds = 4;

// Where a hand that comes to the work means to be. It decides nothing once the hand is there: no hint takes a
// hand through a wall. The numbers are in files.
enum class SideHint : std::uint8_t { kByTheWayItCame = 0, kOutside = 1, kInside = 2, kRim = 3 };

// What is done to the work at once, without a hand on it, by its number; held on, it is done once. The
// numbers are in files.
enum class WorkCommand : std::uint8_t { kNone = 0 };
constexpr unsigned kWorkCommands = 3;

// The other hand, where there is one.
struct SecondHand {
    bool present = false;
    ToolKind tool = ToolKind::kHand;
    double radius_mm = 10.0;              // 2 to 40
    dvec3 position_mm{0.0, 1000.0, 0.0};  // within the workspace

    friend bool operator==(const SecondHand&, const SecondHand&) = default;
};

// The first three fields are a plain tool; the rest speaks to work that has an inside, and says by default
// what a bare hand beside an electric wheel would.
struct ToolState {
    dvec3 position_mm{0.0};     // centre of the tool's sphere, the haptic interface point; wheel frame, +Y up
    double radius_mm = 10.0;    // 2 to 40
    bool wheel_button = false;  // held: the wheel turns

    ToolKind tool = ToolKind::kHand;
    SideHint side = SideHint::kByTheWayItCame;
    double water = 0.0;  // how wet the hand or its tool is, 0 dry to 1 dripping
    WorkCommand command = WorkCommand::kNone;
    double command_height_mm = 0.0;      // 0 to 1000
    double wheel_speed_rev_min = 120.0;  // of the pedal while the button is held; 0 to 300
    // The assist holds a second hand opposite the first, their surfaces no nearer than this; 0: it does not.
    // Taken only where there is no second hand. At most 60.
    double assist_gap_mm = 0.0;
    double shaft_mm = 0.0;  // radius of what carries an inside tool from above; 0 to 40
    SecondHand second{};
    // The place is that of a finger on the upright plane through the axis (x, y), which skilled hands follow;
    // not that of a ball in the work.
    bool guided = false;
    bool pressing = true;  // a hand that does not press is not in the work, wherever it is

    friend bool operator==(const ToolState&, const ToolState&) = default;
};

// Limits of what a tool may be, everywhere a tool comes in (gestures, sessions, devices, keys).
constexpr double kMinToolRadiusMm = 2.0;
constexpr double kMaxToolRadiusMm = 40.0;
constexpr double kWorkspaceMm = 1000.0;  // each coordinate within +-
constexpr double kMaxWheelSpeedRevMin = 300.0;
constexpr double kMaxAssistGapMm = 60.0;

// What work that knows neither sides nor tools is told: all else as by default.
[[nodiscard]] inline ToolState plain_tool(const ToolState& tool) noexcept {
    return {.position_mm = tool.position_mm, .radius_mm = tool.radius_mm, .wheel_button = tool.wheel_button};
}

// The tool brought within those limits, so that a recording never holds one that no reader would take. What
// is not a finite number is replaced by the last good tool's. Any thread; fit for the tick.
[[nodiscard]] inline ToolState within_limits(const ToolState& tool, const ToolState& last_good) noexcept {
    const auto place = [](const dvec3& at, const dvec3& last) {
        const bool finite = std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z);
        return finite ? glm::clamp(at, -kWorkspaceMm, kWorkspaceMm) : last;
    };
    const auto number = [](double value, double least, double most, double last) {
        return std::isfinite(value) ? std::clamp(value, least, most) : last;
    };
    ToolState good = tool;
    good.position_mm = place(tool.position_mm, last_good.position_mm);
    good.radius_mm = number(tool.radius_mm, kMinToolRadiusMm, kMaxToolRadiusMm, last_good.radius_mm);
    good.command_height_mm = number(tool.command_height_mm, 0.0, kWorkspaceMm, last_good.command_height_mm);
    good.wheel_speed_rev_min =
        number(tool.wheel_speed_rev_min, 0.0, kMaxWheelSpeedRevMin, last_good.wheel_speed_rev_min);
    good.assist_gap_mm = number(tool.assist_gap_mm, 0.0, kMaxAssistGapMm, last_good.assist_gap_mm);
    good.water = number(tool.water, 0.0, 1.0, last_good.water);
    good.shaft_mm = number(tool.shaft_mm, 0.0, kMaxToolRadiusMm, last_good.shaft_mm);
    good.second.position_mm = place(tool.second.position_mm, last_good.second.position_mm);
    good.second.radius_mm =
        number(tool.second.radius_mm, kMinToolRadiusMm, kMaxToolRadiusMm, last_good.second.radius_mm);
    return good;
}

}  // namespace onggi::haptics
