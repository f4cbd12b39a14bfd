// Movements of a hand for the tests of the paper's clay, computed without libm, so that they have the same
// bits on every machine. Any thread. Units: mm; one tool a tick.
#pragma once

#include <cstdint>
#include <vector>

#include "game/clay/paper_clay.h"

namespace onggi::clay {

constexpr double kWallRadiusMm = 60.0;  // R_0 of the default lump

// A tool at a height, pressed depth_mm into the wall of an untouched lump, on the +X side.
[[nodiscard]] inline ToolInput tool_in_wall(double depth_mm, bool wheel_turning, double tool_radius_mm = 10.0,
                                            double height_mm = 100.0) {
    return {.position_mm = {kWallRadiusMm + tool_radius_mm - depth_mm, height_mm, 0.0},
            .radius_mm = tool_radius_mm,
            .wheel_turning = wheel_turning};
}

// Throws a vase: foot, belly, neck and lip in six passes, with a change of tool, a pause of the wheel and a
// touch on the standing clay. About 14 s.
[[nodiscard]] std::vector<ToolInput> vase_gesture(double rate_hz);

// A hand that goes anywhere: along the wall, deep into it, over both ends, through the axis, off the clay;
// the wheel and the tool change at random. Never on the element grid. The same seed gives the same movement.
[[nodiscard]] std::vector<ToolInput> random_gesture(std::uint64_t seed, int ticks);

}  // namespace onggi::clay
