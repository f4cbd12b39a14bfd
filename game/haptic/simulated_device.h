// A simulated haptic device for mouse or touch: the pointer sets a target, a small mass on a spring (a
// virtual coupling) follows it, and the work's force pushes the mass back. The visitor sees that the tool
// lags behind the pointer when the work resists.
//
// m a = k (target - x) - b v + F, integrated by Euler's method, implicit in spring and damper, explicit in
// the work's force, which arrives one tick late:
//     v' = (v + dt/m (k (target - x) + F)) / (1 + b dt/m + k dt^2/m),   x' = x + dt v'.
// Free, it is stable at every dt and does not overshoot. Against a wall of stiffness K and viscosity c it is
// stable (Jury's criterion) if
//     K dt^2/m < 4 + 2 (b - c) dt/m + k dt^2/m   and   c dt/m < 2 + b dt/m + k dt^2/m.
// With the values below and the work's K = 0.5 N/mm, c = 0.002 N s/mm: 2.5 < 7 and 1 < 5 at 100 Hz, with more
// to spare at every higher rate.
#pragma once

#include <cstdint>

#include "engine/haptics/control_sense.h"
#include "engine/jobs/mailbox.h"
#include "game/haptic/tool_device.h"

namespace onggi::haptic {

struct SimulatedDeviceModel {
    double mass_kg = 0.02;
    // At the kiosk's peak force the tool lags 16.5 mm behind the pointer.
    double coupling_n_per_mm = 0.2;
    // Critical: 2 sqrt(k m), no overshoot; the tool settles in about 60 ms.
    double damping_n_s_per_mm = 0.004;
};

class SimulatedDevice final : public ToolDevice {
  public:
    explicit SimulatedDevice(const SimulatedDeviceModel& model = {}) : model_(model) {}

    // Main thread, any time, wait-free. Sets the tool's target position, its radius and the wheel button,
    // clamped to the limits of tool_state.h. A read uses only the newest target; a cut in a target that no
    // read used is done at the next read.
    void set_target(const tool::ToolState& target) noexcept;

    // Never fails. The tool starts at rest at the target.
    Result<void> open() override;
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override;

    // Advances the mass by dt_s under the last written force.
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double dt_s) noexcept override;
    void write(const dvec3& force_n) noexcept override { force_n_ = force_n; }

    // Haptic thread, or before open(). The next read starts at rest at the target and ignores earlier cuts.
    void rest() noexcept;

    [[nodiscard]] bool is_moving() const noexcept override { return is_moving_; }
    void take_over(const dvec3& position_mm) noexcept override;

  private:
    struct Target {
        tool::ToolState tool;
        // The last cut of any target, and the number of cuts.
        tool::Wire wire = tool::Wire::kNone;
        double wire_height_mm = 0.0;
        std::uint64_t cuts = 0;
    };

    SimulatedDeviceModel model_;
    Target last_target_;  // main thread only
    jobs::Mailbox<Target> target_;
    // Haptic thread only.
    std::uint64_t cuts_done_ = 0;
    dvec3 position_mm_{0.0};
    dvec3 velocity_mm_s_{0.0};
    dvec3 force_n_{0.0};
    bool at_rest_ = true;  // the next read starts at the target
    haptics::ControlSense sense_{1.0};
    bool last_button_ = false;
    bool last_pressing_ = true;
    bool is_moving_ = false;
};

}  // namespace onggi::haptic
