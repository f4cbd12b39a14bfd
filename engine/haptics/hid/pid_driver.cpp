#include "engine/haptics/hid/pid_driver.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engine/haptics/hid/device_input.h"

namespace onggi::haptics::hid {
namespace {

// The time for which silence counts as a still hand, for a stick that may report only changes: no hand holds
// a 16-bit sensor to the last bit for longer.
constexpr std::int64_t kStillNs = 1000 * kMs;
// The timeout of a stick that reports all the time.
constexpr std::int64_t kJoystickSilenceNs = 100 * kMs;
constexpr int kEffectMs = 500;
constexpr std::int64_t kRestartNs = 200 * kMs;  // twice within an effect's duration
// hid_write waits for the bus, about 1 ms per report: 250 Hz leaves room for four reports.
constexpr std::int64_t kTellIntervalNs = 4 * kMs;
constexpr int kLoadTries = 12;
constexpr int kLoadPauseMs = 5;
constexpr int kResetPauseMs = 10;
// Where a force comes from, in turns.
constexpr double kNorth = 0.0;  // pushes to +Y, towards the hand
constexpr double kWest = 0.75;  // pushes to +X
// Of a condition, east: OpenFFBoard multiplies X's by the sine and Y's by the negative cosine.
constexpr double kConditionDirection = 0.25;
// Friction and damping change constantly by imperceptible amounts: coarse steps save reports.
constexpr double kSteps = 64.0;

double in_steps(double fraction) noexcept {
    return std::round(fraction * kSteps) / kSteps;
}

// A report that the device lacks is empty; it is skipped without error.
Result<void> write(HidPort& port, const Report& report) {
    if (report.size == 0) return {};
    return port.write(report.view());
}

bool touches(const ForceOrder& order) noexcept {
    return order.force_n != dvec2(0.0) || order.tangential_n != 0.0;
}

}  // namespace

DeviceCapabilities PidDriver::capabilities() const {
    // The coarsest stick of the known tables counts from -4096 to 4096.
    constexpr double kCountsOfTravel = 8192.0;
    // The loop that a constant force closes. The rate is this driver's; the delay is a report's wait for the
    // I/O thread plus a write's wait for the bus. Mass and friction are assumed, because no maker states
    // them: lighter than any grip, with less friction than any belt or gear, in mm of the tool, which moves
    // two for one of the stick.
    constexpr double kTellsPerS = 250.0;
    constexpr double kBusDelayS = 0.004;
    constexpr double kGripKg = 0.1;
    constexpr double kDampingNSPerMm = 0.0003;
    constexpr double kFrictionN = 0.1;
    static_assert(kTellsPerS * static_cast<double>(kTellIntervalNs) == 1e9);
    return {.name = "force-feedback joystick",
            .force_axes = 2,
            .peak_force_n = mapping_.peak_n,
            .continuous_force_n = mapping_.peak_n,
            .max_stiffness_n_per_mm = stiffest_n_per_mm(),
            .position_resolution_mm =
                (mapping_.reach.most_radius_mm - mapping_.reach.least_radius_mm) / kCountsOfTravel,
            .has_own_walls = true,
            .wire_rate_hz = kTellsPerS,
            .wire_delay_s = kBusDelayS,
            .moving_mass_kg = kGripKg,
            .damping_n_s_per_mm = kDampingNSPerMm,
            .coulomb_friction_n = kFrictionN};
}

Result<void> PidDriver::start(const HidDeviceInfo& device, HidPort& port) {
    auto descriptor = ReportDescriptor::parse(device.report_descriptor);
    if (!descriptor) return descriptor.error();
    auto layout = PidLayout::find(std::move(descriptor).value());
    if (!layout) return layout.error();
    layout_ = std::move(layout).value();
    shows_wall_ = can_show_a_wall();
    effects_.clear();
    stick_ = {};
    device_state_ = {};
    habit_ = {};
    was_heard_ = wheel_turns_ = is_started_ = is_stopped_ = false;
    auto begun = begin(port);
    if (!begun) stop(port);
    return begun;
}

Result<void> PidDriver::begin(HidPort& port) {
    // Reset twice, because one is sometimes lost; "stop all" before "enable", because some devices read "stop
    // all" as "actuators off".
    for (const PidUsage control : {PidUsage::kReset, PidUsage::kReset, PidUsage::kStopAll}) {
        // A reset may be refused: the effects are set again in any case.
        if (auto sent = write(port, device_control(*layout_, control));
            !sent && control == PidUsage::kStopAll)
            return sent;
        port.pause_ms(kResetPauseMs);
    }
    if (auto sent = write(port, device_control(*layout_, PidUsage::kEnableActuators)); !sent) return sent;
    // without it the device uses its own gain, which is not higher
    (void)write(port, device_gain(*layout_, 1.0));

    struct Request {
        PidUsage type;
        Axis axis;
        bool is_needed;
    };
    for (const Request& request : {Request{PidUsage::kSpringType, Axis::kX, shows_wall_},
                                   Request{PidUsage::kConstantForceType, Axis::kX, !shows_wall_},
                                   Request{PidUsage::kConstantForceType, Axis::kY, true},
                                   Request{PidUsage::kDamperType, Axis::kX, false},
                                   Request{PidUsage::kFrictionType, Axis::kX, false}}) {
        const bool is_condition = request.type != PidUsage::kConstantForceType;
        const bool is_possible =
            request.type == PidUsage::kSpringType ? shows_wall_
            : !is_condition                       ? request.axis == Axis::kY || !shows_wall_
                            : layout_->has_effect(request.type) && layout_->place(PidUsage::kSetCondition);
        if (!is_possible) continue;
        auto loaded = load(port, request.type, request.axis);
        if (!loaded && request.is_needed) return loaded.error();
        if (!loaded) continue;
        if (*loaded) {
            effects_.push_back(**loaded);
        } else if (request.is_needed) {
            return failed("force feedback: expected room for an effect, found the device's memory full");
        }
    }
    for (Effect& effect : effects_) {
        if (auto told = tell(port, effect, {}); !told) return told;
        if (auto sent = write(port, effect_operation(*layout_, effect.block, PidUsage::kStart, 1)); !sent)
            return sent;
    }
    return {};
}

bool PidDriver::can_show_a_wall() const noexcept {
    const auto has = [&](PidUsage field) {
        return static_cast<bool>(layout_->element(PidUsage::kSetCondition, usage(field)));
    };
    // A one-sided spring needs both coefficients, and a saturation to limit its force.
    return layout_->has_effect(PidUsage::kSpringType) && has(PidUsage::kBlockIndex) &&
           has(PidUsage::kCentre) && has(PidUsage::kParameterBlockOffset) &&
           has(PidUsage::kPositiveCoefficient) && has(PidUsage::kNegativeCoefficient) &&
           has(PidUsage::kPositiveSaturation) && has(PidUsage::kNegativeSaturation);
}

Result<std::optional<PidDriver::Effect>> PidDriver::load(HidPort& port, PidUsage type, Axis axis) {
    if (auto created = port.set_feature(create_effect(*layout_, type).view()); !created)
        return created.error();
    BlockLoad answer;
    for (int attempt = 0; attempt < kLoadTries && answer.status == BlockLoad::Status::kUnknown; ++attempt) {
        if (attempt > 0) port.pause_ms(kLoadPauseMs);
        Report report = block_load_request(*layout_);
        const auto size = port.get_feature(std::span(report.bytes).first(report.size));
        if (!size) return size.error();
        answer = block_load(*layout_, std::span(report.bytes).first(std::min(*size, report.size)))
                     .value_or(BlockLoad{});
    }
    if (answer.status == BlockLoad::Status::kFull) return std::optional<Effect>();
    if (answer.status != BlockLoad::Status::kOk || answer.block == 0)
        return failed(fmt::format("force feedback: expected a block for effect {:#x}, found {}",
                                  static_cast<unsigned>(type),
                                  answer.status == BlockLoad::Status::kUnknown ? "no answer" : "an error"));

    Effect effect{.type = type, .axis = axis, .block = answer.block};
    const bool is_condition = type != PidUsage::kConstantForceType;
    // A condition sets both axes, the unused one to zero: some devices rotate a single condition into the
    // effect's direction.
    const double force_direction = axis == Axis::kX ? kWest : kNorth;
    const PidEffect settings{.block = effect.block,
                             .type = type,
                             .duration_ms = kEffectMs,
                             .acts_on_x = is_condition || axis == Axis::kX,
                             .acts_on_y = is_condition || axis == Axis::kY,
                             .direction_turns = is_condition ? kConditionDirection : force_direction};
    if (auto sent = write(port, set_effect(*layout_, settings)); !sent) return sent.error();
    return std::optional<Effect>(effect);
}

void PidDriver::take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept {
    if (const auto state = pid_device_state(*layout_, report)) device_state_ = *state;
    const std::uint32_t before = stick_.buttons;
    if (!take_stick_report(*layout_, report, stick_)) return;
    if (was_heard_ && (stick_.buttons & ~before & 1U) != 0) wheel_turns_ = !wheel_turns_;
    was_heard_ = true;
    heard_ns_ = now_ns;
    habit_.take(report);
}

DeviceInput PidDriver::input(std::int64_t now_ns) const noexcept {
    DeviceInput input{.motion = DeviceInput::Motion::kPlace};
    const bool must_report = habit_.reports_all_the_time();
    input.is_live = was_heard_ && now_ns - heard_ns_ <= (must_report ? kJoystickSilenceNs : kStillNs);
    input.is_fresh = input.is_live && (!must_report || heard_ns_ == now_ns);
    const ToolReach& reach = mapping_.reach;
    const double right = (stick_.deflection.x + 1.0) / 2.0;
    const double away = (1.0 - stick_.deflection.y) / 2.0;
    input.place_mm = {reach.least_radius_mm + right * (reach.most_radius_mm - reach.least_radius_mm),
                      reach.least_height_mm + away * (reach.most_height_mm - reach.least_height_mm)};
    input.button = wheel_turns_;
    input.buttons = stick_.buttons;
    input.shows_wall = shows_wall_;
    return input;
}

double PidDriver::fraction_of_force(double force_n) const noexcept {
    return std::clamp(force_n, -mapping_.peak_n, mapping_.peak_n) / mapping_.full_scale_n;
}

PidCondition PidDriver::wall_condition(const ForceOrder& order) const noexcept {
    PidCondition condition{.saturation = fraction_of_force(mapping_.peak_n)};
    const ToolReach& reach = mapping_.reach;
    const double middle_mm = (reach.most_radius_mm + reach.least_radius_mm) / 2.0;
    // A coefficient of 1 reaches full scale one unit beyond the centre.
    const double asked = order.work.stiffness_n_per_mm;
    const double stiffness = asked > 0.0 ? std::min(asked, stiffest_n_per_mm()) : stiffest_n_per_mm();
    const auto wall = local_wall(order, stiffness);
    if (!wall) return condition;
    condition.centre = std::clamp((wall->contact_mm - middle_mm) / mm_per_unit(), -1.0, 1.0);
    // A tool outside is pushed outwards before the contact radius; a tool inside is pushed the other way.
    (wall->is_outside ? condition.negative_coefficient : condition.positive_coefficient) =
        stiffness * mm_per_unit() / mapping_.full_scale_n;
    return condition;
}

Result<void> PidDriver::tell(HidPort& port, Effect& effect, const ForceOrder& order) {
    const auto send_once = [&](std::optional<Report>& told, const Report& report) -> Result<void> {
        if (told && *told == report) return {};
        told = report;
        return write(port, report);
    };
    const double limit = fraction_of_force(mapping_.peak_n);
    switch (effect.type) {
        case PidUsage::kConstantForceType: {
            const double fraction = effect.axis == Axis::kX
                                        ? fraction_of_force(order.force_n.x)
                                        : fraction_of_force(-order.force_n.y);  // +Y is down
            return send_once(effect.told_x, set_constant_force(*layout_, effect.block, fraction));
        }
        case PidUsage::kSpringType:
            if (auto told = send_once(effect.told_x,
                                      set_condition(*layout_, effect.block, Axis::kX, wall_condition(order)));
                !told)
                return told;
            return send_once(effect.told_y,
                             set_condition(*layout_, effect.block, Axis::kY, {.saturation = limit}));
        default: {
            // The damper adds to the other effects, against the motion only: it gets a quarter. Friction is
            // part of the ordered force.
            const bool is_damper = effect.type == PidUsage::kDamperType;
            const double friction = in_steps(fraction_of_force(std::abs(order.tangential_n)));
            const double fraction = is_damper ? (touches(order) ? mapping_.damping_fraction : 0.0) : friction;
            const PidCondition condition{.positive_coefficient = fraction,
                                         .negative_coefficient = fraction,
                                         .saturation = is_damper ? limit / 4.0 : friction};
            if (auto told =
                    send_once(effect.told_x, set_condition(*layout_, effect.block, Axis::kX, condition));
                !told)
                return told;
            return send_once(effect.told_y, set_condition(*layout_, effect.block, Axis::kY, condition));
        }
    }
}

Result<void> PidDriver::send(HidPort& port, const ForceOrder& order, std::int64_t now_ns) {
    habit_.round();
    if (is_started_ && now_ns - last_told_ns_ < kTellIntervalNs) return {};
    last_told_ns_ = now_ns;
    if (!is_started_) last_start_ns_ = now_ns;
    is_started_ = true;
    // The loop is dead: stop all effects that the device still runs. If the loop recovers, the effects
    // restart with zero force, after the actuators on some devices.
    if (order.is_starved) {
        if (is_stopped_) return {};
        is_stopped_ = true;
        for (Effect& effect : effects_) {
            if (auto told = tell(port, effect, {.tool_mm = order.tool_mm}); !told) return told;
        }
        return write(port, device_control(*layout_, PidUsage::kStopAll));
    }
    if (is_stopped_) {
        is_stopped_ = false;
        last_start_ns_ = now_ns;
        if (auto sent = write(port, device_control(*layout_, PidUsage::kEnableActuators)); !sent) return sent;
        return start_effects(port);
    }
    // The device's emergency stop is pressed or its actuators are off: zero force until both are released.
    const bool is_held = !device_state_.safety_switch_on || !device_state_.actuators_enabled;
    const ForceOrder allowed = is_held ? ForceOrder{.tool_mm = order.tool_mm} : order;
    for (Effect& effect : effects_) {
        if (auto told = tell(port, effect, allowed); !told) return told;
    }
    if (now_ns - last_start_ns_ < kRestartNs) return {};
    last_start_ns_ = now_ns;
    return start_effects(port);
}

Result<void> PidDriver::start_effects(HidPort& port) {
    for (const Effect& effect : effects_) {
        if (auto sent = write(port, effect_operation(*layout_, effect.block, PidUsage::kStart, 1)); !sent)
            return sent;
    }
    return {};
}

void PidDriver::stop(HidPort& port) noexcept {
    if (!layout_) return;
    // Try every step even if one fails; the effects end by themselves anyway.
    (void)write(port, device_control(*layout_, PidUsage::kStopAll));
    for (const Effect& effect : effects_)
        (void)write(port, block_free(*layout_, effect.block));
    (void)write(port, device_control(*layout_, PidUsage::kDisableActuators));
    effects_.clear();
}

}  // namespace onggi::haptics::hid
