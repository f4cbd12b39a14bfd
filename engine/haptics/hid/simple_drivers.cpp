#include "engine/haptics/hid/simple_drivers.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/core/little_endian.h"

namespace onggi::haptics::hid {
namespace {

constexpr std::uint8_t kTranslation = 0x01;
constexpr std::uint8_t kRotation = 0x02;
constexpr std::uint8_t kButtons = 0x03;
constexpr std::uint8_t kLamp = 0x04;
constexpr std::uint8_t kBattery = 0x17;
constexpr std::size_t kThreeAxes = 7;
constexpr std::size_t kSixAxes = 13;

std::array<std::int16_t, 3> three_axes(std::span<const std::uint8_t> report, std::size_t at) noexcept {
    return {little_endian::get<std::int16_t>(report, at), little_endian::get<std::int16_t>(report, at + 2),
            little_endian::get<std::int16_t>(report, at + 4)};
}

}  // namespace

bool take_space_mouse_report(std::span<const std::uint8_t> report, SpaceMouseState& state) noexcept {
    if (report.size() < 2) return false;
    switch (report[0]) {
        case kTranslation:
            if (report.size() < kThreeAxes) return false;
            state.translation = three_axes(report, 1);
            if (report.size() >= kSixAxes) state.rotation = three_axes(report, kThreeAxes);
            return true;
        case kRotation:
            if (report.size() < kThreeAxes) return false;
            state.rotation = three_axes(report, 1);
            return true;
        case kButtons:
            state.buttons = 0;
            for (std::size_t byte = 0; byte < std::min<std::size_t>(report.size() - 1, 4); ++byte)
                state.buttons |= std::uint32_t{report[byte + 1]} << (8U * byte);
            return true;
        case kBattery:
            state.battery_percent = std::min<int>(report[1], 100);
            return true;
        default:
            return false;
    }
}

Report space_mouse_lamp(bool on) noexcept {
    Report report;
    report.bytes[0] = kLamp;
    report.bytes[1] = on ? 1 : 0;
    report.size = 2;
    return report;
}

double pushed_axis(std::int16_t value, const SpaceMouseMapping& mapping) noexcept {
    const double size = std::min(std::abs(static_cast<double>(value)), mapping.full_scale);
    if (size <= mapping.dead_band) return 0.0;
    const double beyond = (size - mapping.dead_band) / (mapping.full_scale - mapping.dead_band);
    return value < 0 ? -beyond : beyond;
}

double shaped_axis(std::int16_t value, const SpaceMouseMapping& mapping) noexcept {
    const double pushed = pushed_axis(value, mapping);
    return pushed * pushed * pushed;
}

dvec2 space_mouse_rate_mm_s(const SpaceMouseState& state, const SpaceMouseMapping& mapping) noexcept {
    return mapping.fastest_mm_s *
           dvec2(shaped_axis(state.translation[0], mapping), -shaped_axis(state.translation[2], mapping));
}

namespace {

// At rest a SpaceMouse falls silent after a few zeros; pushed, it reports every 8 to 16 ms. After this much
// silence while pushed, the device is gone or its release was lost.
constexpr std::int64_t kSpaceMouseSilenceNs = 100 * kMs;
constexpr std::uint32_t kFirstButton = 1;

}  // namespace

DeviceCapabilities SpaceMouseDriver::capabilities() const {
    return {.name = "SpaceMouse"};
}

Result<void> SpaceMouseDriver::start(const HidDeviceInfo& /*device*/, HidPort& port) {
    state_ = {};
    wheel_turns_ = false;
    (void)port.write(space_mouse_lamp(true).view());  // a failure is ignored: the lamp is only decoration
    return {};
}

void SpaceMouseDriver::take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept {
    const std::uint32_t before = state_.buttons;
    if (!take_space_mouse_report(report, state_)) return;
    heard_ns_ = now_ns;
    if ((state_.buttons & ~before & kFirstButton) != 0) wheel_turns_ = !wheel_turns_;
}

DeviceInput SpaceMouseDriver::input(std::int64_t now_ns) const noexcept {
    DeviceInput input{.motion = DeviceInput::Motion::kRate};
    input.is_live = state_.at_rest() || now_ns - heard_ns_ <= kSpaceMouseSilenceNs;
    input.is_fresh = state_.at_rest() || heard_ns_ == now_ns;
    input.rate_mm_s = space_mouse_rate_mm_s(state_, mapping_);
    input.push = {pushed_axis(state_.translation[0], mapping_),
                  -pushed_axis(state_.translation[2], mapping_)};
    input.button = wheel_turns_;
    // A twist to the right is positive about the axis that points down, and speeds the wheel up.
    input.change_rev_min_s = mapping_.fastest_change_rev_min_s * shaped_axis(state_.rotation[2], mapping_);
    input.buttons = state_.buttons;
    return input;
}

bool SpaceMouseDriver::has_moved(std::span<const std::uint8_t> before,
                                 std::span<const std::uint8_t> now) const noexcept {
    SpaceMouseState was;
    SpaceMouseState is;
    if (!take_space_mouse_report(now, is)) return false;
    const bool is_first = !take_space_mouse_report(before, was);
    if ((is.buttons & ~was.buttons) != 0) return true;
    const auto differs = [&](std::int16_t one, std::int16_t other) {
        return std::abs(pushed_axis(one, mapping_) - pushed_axis(other, mapping_)) > kPushNoise;
    };
    return !is_first && !(std::ranges::equal(is.translation, was.translation, std::not_fn(differs)) &&
                          std::ranges::equal(is.rotation, was.rotation, std::not_fn(differs)));
}

void SpaceMouseDriver::stop(HidPort& port) noexcept {
    (void)port.write(space_mouse_lamp(false).view());  // a failure only leaves the lamp on
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

DeviceInput VecPedalDriver::input(std::int64_t /*now_ns*/) const noexcept {
    // It reports changes only: silence is normal, and the port detects a removal.
    DeviceInput input;
    input.is_live = input.is_fresh = true;
    input.button = state_.any();
    constexpr double kChangeRevMinS = 40.0;
    input.change_rev_min_s = (state_.right ? kChangeRevMinS : 0.0) - (state_.left ? kChangeRevMinS : 0.0);
    input.buttons = (state_.left ? 1U : 0U) | (state_.middle ? 2U : 0U) | (state_.right ? 4U : 0U);
    return input;
}

}  // namespace onggi::haptics::hid
