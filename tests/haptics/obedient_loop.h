// The whole loop, tick by tick on a virtual clock, with a scripted device. For tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "game/haptic/job.h"
#include "tests/support/scripted_device.h"

namespace onggi::haptic {

inline double size_of(const dvec3& force_n) {
    return std::sqrt(glm::dot(force_n, force_n));
}

// Keeps the last force, as real devices do, until it is silenced.
class ObedientDevice : public test::ScriptedDevice {
  public:
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double dt_s) noexcept override {
        tool::ToolState tool = ScriptedDevice::read_tool(tick, dt_s);
        // Out of the clay, and into it once the ramp is done; then it stays there.
        tool.position_mm = {std::max(68.0, 120.0 - 0.02 * static_cast<double>(tick)), 100.0, 0.0};
        tool.radius_mm = 10.0;
        tool.wheel_button = false;
        return tool;
    }
    [[nodiscard]] haptics::DeviceSigns signs() const noexcept override { return signs_now; }
    void silence() noexcept override {
        last_force_n = dvec3(0.0);
        ++silenced;
    }

    haptics::DeviceSigns signs_now;
    int silenced = 0;
};

struct Loop {
    explicit Loop(const HapticJobOptions& options = {}) {
        auto owned = std::make_unique<ObedientDevice>();
        device = owned.get();
        HapticParameters parameters;
        parameters.set_rate_hz(1000.0);
        work = std::make_unique<HapticWork>(HapticState(), parameters, std::move(owned), options);
    }
    void run(int ticks) {
        for (int k = 0; k < ticks; ++k) {
            EXPECT_TRUE(work->tick(period));
            ++period.index;
            ++period.tick;
            TickRecord record;
            while (work->take_record(record))
                records.push_back(record);
        }
    }
    [[nodiscard]] double force_n() const { return size_of(device->last_force_n); }

    ObedientDevice* device = nullptr;
    std::unique_ptr<HapticWork> work;
    jobs::Period period{.dt_s = 0.001};
    std::vector<TickRecord> records;
};

}  // namespace onggi::haptic
