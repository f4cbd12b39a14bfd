// A device that reads a smooth, endless path of a tool into and out of the clay, computed without libm's
// trigonometry so that it is the same everywhere, and stores what was written to it. One thread.
#pragma once

#include <cmath>

#include "game/haptic/tool_device.h"

namespace onggi::test {

inline tool::ToolState scripted_tool(std::uint64_t tick) {
    const double t = static_cast<double>(tick % 3000) / 3000.0;
    const double there_and_back = 1.0 - std::abs(2.0 * t - 1.0);
    tool::ToolState tool;
    tool.position_mm = {75.0 - 9.03 * there_and_back, 20.013 + 160.0 * t, 3.0 * t};
    tool.radius_mm = 8.0 + 6.0 * t;
    tool.wheel_button = tick % 3000 > 200;
    return tool;
}

class ScriptedDevice : public haptic::ToolDevice {
  public:
    Result<void> open() override {
        ++opened;
        return {};
    }
    void close() noexcept override { ++closed; }
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override { return {.name = "script"}; }
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double dt_s) noexcept override {
        ++reads;
        last_tick = tick;
        longest_dt_s = std::fmax(longest_dt_s, dt_s);
        return scripted_tool(tick);
    }
    void write(const dvec3& force_n) noexcept override {
        ++writes;
        last_force_n = force_n;
        largest_force_n = std::fmax(largest_force_n, std::sqrt(glm::dot(force_n, force_n)));
    }

    int opened = 0;
    int closed = 0;
    std::uint64_t reads = 0;
    std::uint64_t writes = 0;
    std::uint64_t last_tick = 0;
    double longest_dt_s = 0.0;
    dvec3 last_force_n{0.0};
    double largest_force_n = 0.0;
};

}  // namespace onggi::test
