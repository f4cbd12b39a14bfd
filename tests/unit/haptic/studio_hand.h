// A hand that throws on a studio lump of 500 g: opens it at the axis, widens it, lets go, presses the
// outside, lets go, fairs it with a rib, and cuts the rim. One hand's way in straight pieces, the same at
// every rate.
#pragma once

#include <array>
#include <cstdint>

#include "game/haptic/tick.h"
#include "game/haptic/tool_device.h"
#include "game/tool/tool.h"

namespace onggi::test {

constexpr double kStudioHandSeconds = 9.0;

inline tool::ToolState studio_hand(std::uint64_t tick, double rate_hz) {
    struct Place {
        double t_s;
        double x_mm;
        double y_mm;
    };
    constexpr std::array kWay{
        Place{0.0, 0.0, 90.0},  Place{0.3, 0.0, 55.0},   Place{2.3, 0.0, 22.0},   Place{4.3, 22.0, 22.0},
        Place{4.6, 10.0, 80.0}, Place{5.0, 90.0, 80.0},  Place{5.2, 90.0, 16.0},  Place{5.5, 52.0, 16.0},
        Place{6.7, 50.0, 60.0}, Place{6.8, 90.0, 60.0},  Place{7.3, 90.0, 20.0},  Place{7.6, 51.0, 24.0},
        Place{8.4, 49.0, 30.0}, Place{8.6, 100.0, 90.0}, Place{9.0, 100.0, 90.0}, Place{1e9, 100.0, 90.0}};
    const double t_s = static_cast<double>(tick) / rate_hz;
    std::size_t i = 0;
    while (kWay[i + 1].t_s <= t_s)
        ++i;
    const double part = (t_s - kWay[i].t_s) / (kWay[i + 1].t_s - kWay[i].t_s);
    tool::ToolState tool;
    tool.position_mm = {kWay[i].x_mm + part * (kWay[i + 1].x_mm - kWay[i].x_mm),
                        kWay[i].y_mm + part * (kWay[i + 1].y_mm - kWay[i].y_mm), 0.0};
    tool.wheel_button = true;
    tool.water = t_s < 7.0 ? 1.0 : 0.0;
    tool.shaft_mm = t_s > 2.3 && t_s < 4.6 ? 8.0 : 0.0;
    tool.assist_gap_mm = t_s > 5.1 && t_s < 6.8 ? 5.0 : 0.0;
    tool.tool = t_s < 7.0 ? tool::Tool::kHand : tool::Tool::kRib;
    if (t_s > 8.8 && t_s < 8.9) {
        tool.wire = tool::Wire::kCutRim;
        tool.wire_height_mm = 40.0;
    }
    return tool;
}

class StudioHand final : public haptic::ToolDevice {
  public:
    explicit StudioHand(double rate_hz) : rate_hz_(rate_hz) {}
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override { return {.name = "script"}; }
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double /*dt_s*/) noexcept override {
        return studio_hand(tick, rate_hz_);
    }
    void write(const dvec3& /*force_n*/) noexcept override {}

  private:
    double rate_hz_;
};

inline haptic::HapticState studio_start() {
    return haptic::HapticState(clay::StudioClay({.mass_g = 500.0, .rings = 1000}));
}

}  // namespace onggi::test
