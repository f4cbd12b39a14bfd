#include "game/haptic/simulated_device.h"

#include "engine/haptics/safety_chain.h"

namespace onggi::haptic {

void SimulatedDevice::set_target(const tool::ToolState& target) noexcept {
    const tool::Wire before = last_target_.tool.wire;
    const tool::ToolState tool = last_target_.tool = within_limits(target, last_target_.tool);
    if (tool.wire != tool::Wire::kNone && tool.wire != before) {
        last_target_.wire = tool.wire;
        last_target_.wire_height_mm = tool.wire_height_mm;
        ++last_target_.cuts;
    }
    target_.put(last_target_);
}

Result<void> SimulatedDevice::open() {
    rest();
    return {};
}

void SimulatedDevice::rest() noexcept {
    velocity_mm_s_ = force_n_ = dvec3(0.0);
    at_rest_ = true;
    cuts_done_ = target_.latest().cuts;
}

haptics::DeviceCapabilities SimulatedDevice::capabilities() const {
    return {.name = "simulated device (mouse or touch)",
            .force_axes = 3,
            .peak_force_n = haptics::kKioskPeakForceN,
            .continuous_force_n = haptics::kKioskPeakForceN,
            .max_stiffness_n_per_mm = 0.5,
            .position_resolution_mm = 0.0,
            .has_motors = false};
}

void SimulatedDevice::take_over(const dvec3& position_mm) noexcept {
    position_mm_ = position_mm;
    velocity_mm_s_ = force_n_ = dvec3(0.0);
    at_rest_ = false;
}

tool::ToolState SimulatedDevice::read_tool(std::uint64_t /*tick*/, double dt_s) noexcept {
    const Target& newest = target_.latest();
    tool::ToolState target = newest.tool;
    // A cut counts once, even if its target was replaced before this read.
    if (newest.cuts != cuts_done_) {
        cuts_done_ = newest.cuts;
        target.wire = newest.wire;
        target.wire_height_mm = newest.wire_height_mm;
    }
    // Putting a finger down counts as motion, even at the same position.
    is_moving_ = sense_.moved_to(target.position_mm, dt_s) || target.wheel_button != last_button_ ||
                 target.pressing != last_pressing_;
    last_button_ = target.wheel_button;
    last_pressing_ = target.pressing;
    if (at_rest_) {
        position_mm_ = target.position_mm;
        at_rest_ = false;
    }
    if (target.guided) {
        // A finger's position is taken as it is; the simulated hands in the work lag behind it.
        position_mm_ = target.position_mm;
        velocity_mm_s_ = force_n_ = dvec3(0.0);
        return target;
    }
    // N / kg is m/s^2; positions are in mm.
    constexpr double kMmPerM = 1000.0;
    const double step_over_mass = dt_s / model_.mass_kg * kMmPerM;
    const double held_back =
        1.0 + (model_.damping_n_s_per_mm + model_.coupling_n_per_mm * dt_s) * step_over_mass;
    const dvec3 push_n = model_.coupling_n_per_mm * (target.position_mm - position_mm_) + force_n_;
    velocity_mm_s_ = (velocity_mm_s_ + push_n * step_over_mass) / held_back;
    position_mm_ += velocity_mm_s_ * dt_s;
    target.position_mm = position_mm_;
    return target;
}

}  // namespace onggi::haptic
