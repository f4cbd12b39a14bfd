#include "engine/haptics/hid/simple_drivers.h"

namespace onggi::haptics::hid {
namespace {

// At rest a SpaceMouse is silent after a few zeros; pushed, it reports every 8 to 16 ms. Pushed and silent
// for so long, it is no longer there, or its release was lost.
constexpr std::int64_t kSpaceMouseSilenceNs = 100 * kMs;
constexpr std::uint32_t kFirstButton = 1;

}  // namespace

DeviceCapabilities SpaceMouseDriver::capabilities() const {
    return {.name = "SpaceMouse"};
}

Result<void> SpaceMouseDriver::start(const HidDeviceInfo& /*device*/, HidPort& port) {
    state_ = {};
    wheel_turns_ = false;
    return port.write(space_mouse_lamp(true).view());
}

void SpaceMouseDriver::take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept {
    const std::uint32_t before = state_.buttons;
    if (!take_space_mouse_report(report, state_)) return;
    heard_ns_ = now_ns;
    if ((state_.buttons & ~before & kFirstButton) != 0) wheel_turns_ = !wheel_turns_;
}

HandInput SpaceMouseDriver::input(std::int64_t now_ns) const noexcept {
    HandInput input{.motion = HandInput::Motion::kRate};
    input.is_live = state_.at_rest() || now_ns - heard_ns_ <= kSpaceMouseSilenceNs;
    input.is_fresh = state_.at_rest() || heard_ns_ == now_ns;
    input.rate_mm_s = space_mouse_rate_mm_s(state_, mapping_);
    input.wheel_button = wheel_turns_;
    // Twisted to the right it turns faster; about the axis that points down, a positive turn.
    input.wheel_change_rev_min_s =
        mapping_.fastest_change_rev_min_s * shaped_axis(state_.rotation[2], mapping_);
    input.buttons = state_.buttons;
    return input;
}

void SpaceMouseDriver::stop(HidPort& port) noexcept {
    (void)port.write(space_mouse_lamp(false).view());  // a lamp left on is all that a failure costs
}

DeviceCapabilities VecPedalDriver::capabilities() const {
    return {.name = "foot pedal"};
}

Result<void> VecPedalDriver::start(const HidDeviceInfo& /*device*/, HidPort& /*port*/) {
    state_ = {};
    return {};
}

void VecPedalDriver::take_report(std::span<const std::uint8_t> report, std::int64_t /*now_ns*/) noexcept {
    if (const auto state = vec_pedal_state(report)) state_ = *state;
}

HandInput VecPedalDriver::input(std::int64_t /*now_ns*/) const noexcept {
    // It reports changes only: silence means nothing, and a removal is told by the port.
    HandInput input;
    input.is_live = input.is_fresh = true;
    input.wheel_button = state_.any();
    constexpr double kChangeRevMinS = 40.0;
    input.wheel_change_rev_min_s =
        (state_.right ? kChangeRevMinS : 0.0) - (state_.left ? kChangeRevMinS : 0.0);
    input.buttons = (state_.left ? 1U : 0U) | (state_.middle ? 2U : 0U) | (state_.right ? 4U : 0U);
    return input;
}

}  // namespace onggi::haptics::hid
