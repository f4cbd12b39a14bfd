#include "engine/haptics/hid/dual_sense_driver.h"

#include <algorithm>
#include <cmath>

namespace onggi::haptics::hid {
namespace {

// It reports every 4 ms, whatever happens.
constexpr std::int64_t kSilenceNs = 100 * kMs;
// A worm gear moves the resistance: more often than this it could not follow.
constexpr std::int64_t kLeastIntervalNs = 10 * kMs;
constexpr std::array<std::uint8_t, 3> kWheelStands{0x00, 0x10, 0x40};
constexpr std::array<std::uint8_t, 3> kWheelTurns{0x60, 0x28, 0x00};
constexpr std::uint8_t kMostRumble = 0x60;
constexpr std::uint8_t kRumbleStep = 0x08;  // finer would be a report a tick
constexpr std::uint8_t kPedalDown = 0x40;   // L2, of 255

double from_stick(std::uint8_t value, double dead_band) noexcept {
    const double deflection = std::clamp((static_cast<double>(value) - 128.0) / 127.0, -1.0, 1.0);
    const double size = std::abs(deflection);
    if (size <= dead_band) return 0.0;
    const double beyond = (size - dead_band) / (1.0 - dead_band);
    const double shaped = beyond * beyond * beyond;
    return deflection < 0.0 ? -shaped : shaped;
}

}  // namespace

TriggerEffect trigger_for_wall(const ForceOrder& order, double press_mm,
                               const DualSenseMapping& mapping) noexcept {
    const auto wall = local_wall(order, mapping.stiffness_n_per_mm);
    if (!wall || !wall->is_outside) return trigger_off();  // the trigger presses inwards, and feels only that
    const double rest_mm = order.tool_mm.x + press_mm;     // the tool's radius with the trigger let go
    std::array<std::uint8_t, kTriggerZones> strengths{};
    for (std::size_t zone = 0; zone < kTriggerZones; ++zone) {
        const double travel = (static_cast<double>(zone) + 0.5) / static_cast<double>(kTriggerZones);
        const double force_n = wall->force_n(rest_mm - travel * mapping.press_mm);
        const double share = std::clamp(force_n / mapping.strongest_n, 0.0, 1.0);
        strengths[zone] = static_cast<std::uint8_t>(std::lround(share * kStrongestZone));
    }
    return trigger_resistance(strengths);
}

DeviceCapabilities DualSenseDriver::capabilities() const {
    return {.name = "DualSense",
            .force_axes = 1,
            .peak_force_n = mapping_.strongest_n,
            .continuous_force_n = mapping_.strongest_n,
            .max_stiffness_n_per_mm = mapping_.stiffness_n_per_mm,
            .position_resolution_mm = mapping_.press_mm / 255.0};
}

Result<void> DualSenseDriver::start(const HidDeviceInfo& /*device*/, HidPort& port) {
    state_ = {};
    wheel_turns_ = was_heard_ = false;
    last_sent_.reset();
    last_sent_ns_ = 0;
    return port.write(dual_sense_report({.right_trigger = trigger_off(),
                                         .left_trigger = trigger_off(),
                                         .rumble = DualSenseOrders::Rumble{},
                                         .light = kWheelStands,
                                         .end_start_up_light = true})
                          .view());
}

void DualSenseDriver::take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept {
    const auto state = dual_sense_state(report);
    if (!state) return;
    const bool pressed = (state->buttons & ~state_.buttons & DualSenseState::kCross) != 0;
    if (pressed && was_heard_) wheel_turns_ = !wheel_turns_;
    state_ = *state;
    heard_ns_ = now_ns;
    was_heard_ = true;
}

double DualSenseDriver::press_mm() const noexcept {
    return mapping_.press_mm * state_.right_trigger / 255.0;
}

HandInput DualSenseDriver::input(std::int64_t now_ns) const noexcept {
    HandInput input{.motion = HandInput::Motion::kRate};
    input.is_live = was_heard_ && now_ns - heard_ns_ <= kSilenceNs;
    input.rate_mm_s =
        mapping_.fastest_mm_s * dvec2(from_stick(state_.left_stick[0], mapping_.stick_dead_band),
                                      -from_stick(state_.left_stick[1], mapping_.stick_dead_band));
    input.press_mm = press_mm();
    input.wheel_button = wheel_turns_ || state_.left_trigger >= kPedalDown;
    input.buttons = state_.buttons;
    return input;
}

Result<void> DualSenseDriver::send(HidPort& port, const ForceOrder& order, std::int64_t now_ns) {
    if (last_sent_ && now_ns - last_sent_ns_ < kLeastIntervalNs) return {};
    const double tremor = std::clamp(std::abs(order.tangential_n) / mapping_.strongest_n, 0.0, 1.0);
    const auto rumble =
        static_cast<std::uint8_t>(std::lround(tremor * kMostRumble / kRumbleStep) * kRumbleStep);
    const Report report = dual_sense_report({.right_trigger = trigger_for_wall(order, press_mm(), mapping_),
                                             .rumble = DualSenseOrders::Rumble{.weak = rumble},
                                             .light = order.wheel_turns ? kWheelTurns : kWheelStands});
    if (last_sent_ && report == *last_sent_) return {};
    last_sent_ = report;
    last_sent_ns_ = now_ns;
    return port.write(report.view());
}

void DualSenseDriver::stop(HidPort& port) noexcept {
    // Resistance would stay in the pad for whoever plays next; a failure means it is unplugged, and forgets.
    (void)port.write(dual_sense_report({.right_trigger = trigger_off(),
                                        .left_trigger = trigger_off(),
                                        .rumble = DualSenseOrders::Rumble{},
                                        .light = std::array<std::uint8_t, 3>{}})
                         .view());
}

}  // namespace onggi::haptics::hid
