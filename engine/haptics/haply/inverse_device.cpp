#include "engine/haptics/haply/inverse_device.h"

namespace onggi::haptics {
namespace {

constexpr dvec3 kStartMm{110.0, 60.0, 0.0};  // outside the lump
constexpr double kSilenceS = 0.05;
constexpr double kNoiseMm = 1.5;

// What its stiffness is judged by (stability.h). From its maker's public description: that forces are
// newtons, and that it answers each message with one, so that the rate is ours. All else is assumed, until
// somebody measures one: a message waits up to a period on either side of the service; the arm is as light as
// a small stylus and as free as hardly any (both are harder to steady); its encoders are no finer than such a
// stylus's.
constexpr double kServicePeriods = 2.0;
constexpr double kMovingKg = 0.045;
constexpr double kDampingNSPerMm = 0.0001;
constexpr double kFrictionN = 0.0;
constexpr double kEncoderStepMm = 0.055;

}  // namespace

InverseDevice::InverseDevice(const haply::InverseOptions& options)
    : options_(options),
      client_(link_, options),
      offset_mm_(kStartMm),
      tool_{.position_mm = kStartMm},
      sense_(kNoiseMm) {}

Result<void> InverseDevice::open() {
    if (thread_.running()) return {};
    return thread_.start(client_, "onggi-inverse");
}

DeviceCapabilities InverseDevice::capabilities() const {
    return {.name = "Haply Inverse3",
            .force_axes = 3,
            .peak_force_n = options_.peak_n,
            .continuous_force_n = options_.continuous_n,
            .position_resolution_mm = kEncoderStepMm,
            .report_rate_hz = options_.rate_hz,
            .wire_delay_s = kServicePeriods / options_.rate_hz,
            .moving_mass_kg = kMovingKg,
            .damping_n_s_per_mm = kDampingNSPerMm,
            .coulomb_friction_n = kFrictionN};
}

ToolState InverseDevice::read(std::uint64_t /*tick*/, double dt_s) noexcept {
    const haply::SpaceInput& input = link_.input.latest();
    is_new_ = input.heartbeat != last_heartbeat_;
    silence_s_ = is_new_ ? 0.0 : silence_s_ + dt_s;
    last_heartbeat_ = input.heartbeat;
    force_fraction_ = input.force_fraction;
    const bool was_here = is_here_;
    is_here_ = input.is_live && silence_s_ <= kSilenceS;
    is_moving_ = is_here_ && sense_.moved_to(input.place_mm);
    // Back again, it goes on from where the tool was left, wherever the hand has been meanwhile.
    if (is_here_ && !was_here) offset_mm_ = tool_.position_mm - input.place_mm;
    if (is_here_) tool_.position_mm = input.place_mm + offset_mm_;
    return tool_;
}

void InverseDevice::write(const dvec3& force_n) noexcept {
    link_.order.put({.force_n = force_n, .ticks = ++ticks_});
}

void InverseDevice::take_over(const ToolState& tool) noexcept {
    offset_mm_ += tool.position_mm - tool_.position_mm;
    tool_.position_mm = tool.position_mm;
}

}  // namespace onggi::haptics
