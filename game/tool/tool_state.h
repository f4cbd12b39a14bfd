// A hand in the clay and its tool at one instant: the common type of gestures, sessions, the tick and the
// clay. mm, rev/min.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/haptics/hand_sample.h"
#include "engine/math/math.h"
#include "game/tool/tool.h"

namespace onggi::tool {

// Limits of every tool, whether from gestures, sessions, devices or keys.
constexpr double kMinToolRadiusMm = 2.0;
constexpr double kMaxToolRadiusMm = 40.0;
constexpr double kMaxWheelSpeedRevMin = 300.0;
constexpr double kMaxAssistGapMm = 60.0;

// The second hand, if present.
struct SecondHand {
    bool present = false;
    Tool tool = Tool::kHand;
    double radius_mm = 10.0;              // kMinToolRadiusMm to kMaxToolRadiusMm
    dvec3 position_mm{0.0, 1000.0, 0.0};  // within the workspace

    friend bool operator==(const SecondHand&, const SecondHand&) = default;
};

// The first three fields are a plain tool, which is all that the paper's clay uses. The defaults of the
// others describe a bare hand at an electric wheel.
struct ToolState {
    dvec3 position_mm{0.0};     // centre of the tool's sphere, the haptic interface point; wheel frame, +Y up
    double radius_mm = 10.0;    // kMinToolRadiusMm to kMaxToolRadiusMm
    bool wheel_button = false;  // held: the wheel turns

    Tool tool = Tool::kHand;  // one of the first kClayTools
    Side side = Side::kFree;
    double water = 0.0;  // wetness of the hand or its tool: 0 dry, 1 dripping
    Wire wire = Wire::kNone;
    double wire_height_mm = 0.0;  // 0 to 1000
    // set by the pedal while the button is held; 0 to kMaxWheelSpeedRevMin
    double wheel_speed_rev_min = 120.0;
    // The assist: a second hand held opposite the first across the wall. It rests there and, while the first
    // hand climbs, squeezes until their surfaces are this far apart. Used only without a second hand; 0
    // switches it off. At most kMaxAssistGapMm.
    double assist_gap_mm = 0.0;
    double shaft_mm = 0.0;  // hand inside: radius of the arm above the ball; 0 to kMaxToolRadiusMm
    SecondHand second{};
    // The position is that of a finger on the upright plane through the axis (x, y), which skilled hands
    // follow, and not that of a ball in the clay; z states its push (push_of()). A second hand is then a
    // second finger.
    bool guided = false;
    bool pressing = true;  // false: the hand is not in the clay

    friend bool operator==(const ToolState&, const ToolState&) = default;
};

// How hard a finger on a screen pushes, of the push of one without a measured pressure: 1, kLeastPush to 2.
// It is in z, which no finger has, so that every session holds it.
constexpr double kLeastPush = 0.1;
constexpr double kPushMm = 10.0;
[[nodiscard]] inline double push_of(const ToolState& tool) noexcept {
    return std::clamp(1.0 + tool.position_mm.z / kPushMm, kLeastPush, 2.0);
}
[[nodiscard]] inline double z_of_push(double push) noexcept {
    return (push - 1.0) * kPushMm;
}

// Keeps only a plain tool's fields; the others get their defaults, because the paper's clay has no sides or
// tools.
[[nodiscard]] inline ToolState plain_tool(const ToolState& tool) noexcept {
    return {.position_mm = tool.position_mm, .radius_mm = tool.radius_mm, .wheel_button = tool.wheel_button};
}

// sample_of: a device's part of a tool. moved_by: the tool after a device's sample.
[[nodiscard]] inline haptics::HandSample sample_of(const ToolState& tool) noexcept {
    return {.position_mm = tool.position_mm,
            .button = tool.wheel_button,
            .rev_min = tool.wheel_speed_rev_min,
            .on_screen = tool.guided,
            .presses = tool.pressing};
}
[[nodiscard]] inline ToolState moved_by(const haptics::HandSample& sample, ToolState tool) noexcept {
    if (tool.guided && !sample.on_screen) tool.second = {};  // a finger is no ball in the clay
    tool.position_mm = sample.position_mm;
    tool.wheel_button = sample.button;
    tool.wheel_speed_rev_min = sample.rev_min;
    tool.guided = sample.on_screen;
    tool.pressing = sample.presses;
    return tool;
}

// Clamps the tool to its limits, so that a recording never contains one that a reader would refuse. Values
// that are not finite are replaced by the last good tool's. Any thread; fit for the tick.
[[nodiscard]] inline ToolState within_limits(const ToolState& tool, const ToolState& last_good) noexcept {
    const auto place = [](const dvec3& at, const dvec3& last) {
        const bool finite = std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z);
        return finite ? glm::clamp(at, -haptics::kWorkspaceMm, haptics::kWorkspaceMm) : last;
    };
    const auto number = [](double value, double least, double most, double last) {
        return std::isfinite(value) ? std::clamp(value, least, most) : last;
    };
    ToolState good = tool;
    good.position_mm = place(tool.position_mm, last_good.position_mm);
    good.radius_mm = number(tool.radius_mm, kMinToolRadiusMm, kMaxToolRadiusMm, last_good.radius_mm);
    good.wire_height_mm = number(tool.wire_height_mm, 0.0, haptics::kWorkspaceMm, last_good.wire_height_mm);
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

}  // namespace onggi::tool
