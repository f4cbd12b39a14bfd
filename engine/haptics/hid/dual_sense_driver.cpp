#include "engine/haptics/hid/dual_sense_driver.h"

#include <algorithm>
#include <cmath>

namespace onggi::haptics::hid {
namespace {

// The pad reports every 4 ms, even at rest.
constexpr std::int64_t kSilenceNs = 100 * kMs;
// A worm gear moves the resistance and cannot follow more often than this.
constexpr std::int64_t kLeastIntervalNs = 10 * kMs;
constexpr std::array<std::uint8_t, 3> kWheelStands{0x00, 0x10, 0x40};
constexpr std::array<std::uint8_t, 3> kAtEase{0x18, 0x50, 0x08};
constexpr std::array<std::uint8_t, 3> kStrained{0x60, 0x28, 0x00};
constexpr std::array<std::uint8_t, 3> kGivingWay{0x80, 0x04, 0x00};
constexpr std::uint8_t kCalibration = 0x05;  // a feature report
constexpr std::size_t kCalibrationBytes = 41;
constexpr double kLightSteps = 8.0;
constexpr double kSoftestNPerMm = 0.05;
constexpr double kTouchWidth = 1919.0;
constexpr double kGyroDegSPerStep = 1.0 / 16.0;
constexpr double kSensorSPerStep = 1.0 / 3e6;
constexpr double kLongestSensorS = 0.05;
constexpr std::uint8_t kMostRumble = 0x60;
constexpr std::uint8_t kRumbleStep = 0x08;  // a finer step would need a report every tick
constexpr std::uint8_t kPedalDown = 0x40;   // L2, of 255

// -1 to 1: zero within the dead band, then even, as the thumb pushes.
double from_stick(std::uint8_t value, double dead_band) noexcept {
    const double deflection = std::clamp((static_cast<double>(value) - 128.0) / 127.0, -1.0, 1.0);
    const double size = std::abs(deflection);
    if (size <= dead_band) return 0.0;
    const double beyond = (size - dead_band) / (1.0 - dead_band);
    return deflection < 0.0 ? -beyond : beyond;
}

}  // namespace

TriggerEffect trigger_for_wall(const ForceOrder& order, double press_mm,
                               const DualSenseMapping& mapping) noexcept {
    const double stiffness =
        order.work.stiffness_n_per_mm > 0.0
            ? std::clamp(order.work.stiffness_n_per_mm, kSoftestNPerMm, mapping.most_stiffness_n_per_mm)
            : mapping.stiffness_n_per_mm;
    const auto wall = local_wall(order, stiffness);
    if (!wall || !wall->is_outside)
        return trigger_off();  // the trigger presses inwards and can only resist forces outwards
    const double rest_mm = order.tool_mm.x + press_mm;  // the tool's radius with the trigger released
    std::array<std::uint8_t, kTriggerZones> strengths{};
    for (std::size_t zone = 0; zone < kTriggerZones; ++zone) {
        const double travel = (static_cast<double>(zone) + 0.5) / static_cast<double>(kTriggerZones);
        double force_n = wall->force_n(rest_mm - travel * mapping.press_mm);
        if (order.work.most_force_n > 0.0) force_n = std::min(force_n, order.work.most_force_n);
        const double fraction = std::clamp(force_n / mapping.strongest_n, 0.0, 1.0);
        strengths[zone] = static_cast<std::uint8_t>(std::lround(fraction * kStrongestZone));
    }
    return trigger_resistance(strengths);
}

std::array<std::uint8_t, 3> light_for(const ForceOrder& order) noexcept {
    if (!order.turns) return kWheelStands;
    const double load = std::clamp(std::isfinite(order.work.load) ? order.work.load : 0.0, 0.0, 1.0);
    const double step = std::floor(load * kLightSteps) / kLightSteps;
    const auto& from = step < 0.5 ? kAtEase : kStrained;
    const auto& to = step < 0.5 ? kStrained : kGivingWay;
    const double fraction = step < 0.5 ? 2.0 * step : 2.0 * step - 1.0;
    std::array<std::uint8_t, 3> light{};
    for (std::size_t colour = 0; colour < light.size(); ++colour) {
        light[colour] =
            static_cast<std::uint8_t>(std::lround((1.0 - fraction) * from[colour] + fraction * to[colour]));
    }
    return light;
}

DeviceCapabilities DualSenseDriver::capabilities() const {
    return {.name = "DualSense",
            .force_axes = 1,
            .peak_force_n = mapping_.strongest_n,
            .continuous_force_n = mapping_.strongest_n,
            .max_stiffness_n_per_mm = mapping_.most_stiffness_n_per_mm,
            .position_resolution_mm = mapping_.press_mm / 255.0,
            .has_own_walls = true};
}

Result<void> DualSenseDriver::start(const HidDeviceInfo& device, HidPort& port) {
    is_by_radio_ = device.bus == HidBusType::kBluetooth;
    if (is_by_radio_) {
        // Over Bluetooth, the pad sends short reports until its calibration is read.
        std::array<std::uint8_t, kCalibrationBytes> calibration{kCalibration};
        if (auto asked = port.get_feature(calibration); !asked) return asked.error();
    }
    state_ = {};
    wheel_turns_ = was_heard_ = false;
    last_sent_.reset();
    last_sent_ns_ = 0;
    return tell(port, dual_sense_report({.right_trigger = trigger_off(),
                                         .left_trigger = trigger_off(),
                                         .rumble = DualSenseOrders::Rumble{},
                                         .light = kWheelStands,
                                         .end_start_up_light = true}));
}

// A pad that refuses the report still moves the tool, so the report is repeated at the next occasion.
Result<void> DualSenseDriver::tell(HidPort& port, const Report& report) {
    auto sent = port.write(is_by_radio_ ? by_radio(report, sequence_++).view() : report.view());
    if (sent || !port.is_there()) return sent;
    last_sent_.reset();
    return {};
}

void DualSenseDriver::take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept {
    const auto state = dual_sense_state(report);
    if (!state) return;
    const bool pressed = (state->buttons & ~state_.buttons & DualSenseState::kCross) != 0;
    if (pressed && was_heard_) wheel_turns_ = !wheel_turns_;
    if (was_heard_) travel(*state);
    state_ = *state;
    heard_ns_ = now_ns;
    was_heard_ = true;
}

// Adds the motion of a finger that stays down, and the tilt of the pad. Height grows upwards, whereas the
// pad's y grows downwards.
void DualSenseDriver::travel(const DualSenseState& now) noexcept {
    const DualSenseTouch& before = state_.touches[0];
    const DualSenseTouch& finger = now.touches[0];
    if (before.touching && finger.touching && before.id == finger.id) {
        const dvec2 drawn(static_cast<double>(finger.x) - before.x, static_cast<double>(before.y) - finger.y);
        travelled_mm_ += drawn * (mapping_.touch_mm / kTouchWidth);
    }
    if ((now.buttons & DualSenseState::kL1) == 0) return;
    const double dt_s = std::min(static_cast<double>(now.sensor_time - state_.sensor_time) * kSensorSPerStep,
                                 kLongestSensorS);
    const auto turned_deg = [&](std::int16_t gyro) {
        const double deg_s = static_cast<double>(gyro) * kGyroDegSPerStep;
        return std::abs(deg_s) <= mapping_.tilt_dead_deg_s ? 0.0 : deg_s * dt_s;
    };
    // Tilting up moves up. Turning right (clockwise from above) moves outwards; the pad reports it as
    // negative.
    travelled_mm_ += mapping_.tilt_mm_per_deg * dvec2(-turned_deg(now.gyro[1]), turned_deg(now.gyro[0]));
}

double DualSenseDriver::press_mm() const noexcept {
    return mapping_.press_mm * state_.right_trigger / 255.0;
}

DeviceInput DualSenseDriver::input(std::int64_t now_ns) const noexcept {
    DeviceInput input{.motion = DeviceInput::Motion::kRate};
    input.is_live = was_heard_ && now_ns - heard_ns_ <= kSilenceNs;
    input.is_fresh = was_heard_ && heard_ns_ == now_ns;
    input.push = {from_stick(state_.left_stick[0], mapping_.stick_dead_band),
                  -from_stick(state_.left_stick[1], mapping_.stick_dead_band)};
    input.rate_mm_s = mapping_.fastest_mm_s * (input.push * input.push * input.push);
    input.travelled_mm = travelled_mm_;
    input.press_mm = press_mm();
    if (state_.left_trigger >= kPedalDown)
        input.rev_min = mapping_.fastest_rev_min * state_.left_trigger / 255.0;
    input.button = wheel_turns_ || state_.left_trigger >= kPedalDown;
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
                                             .light = light_for(order)});
    if (last_sent_ && report == *last_sent_) return {};
    last_sent_ = report;
    last_sent_ns_ = now_ns;
    return tell(port, report);
}

void DualSenseDriver::stop(HidPort& port) noexcept {
    // Without this report the pad would keep its resistance. If it fails, the pad is unplugged and has lost
    // the resistance.
    (void)tell(port, dual_sense_report({.right_trigger = trigger_off(),
                                        .left_trigger = trigger_off(),
                                        .rumble = DualSenseOrders::Rumble{},
                                        .light = std::array<std::uint8_t, 3>{}}));
}

}  // namespace onggi::haptics::hid
