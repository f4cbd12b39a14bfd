#include "engine/haptics/hid/pid_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/haptics/hid/hid_port.h"

namespace onggi::haptics::hid {
namespace {

constexpr std::uint16_t kButtonPage = 0x09;
constexpr std::uint32_t kMostButtons = 32;

struct Need {
    PidUsage report;
    Usage field;
    std::string_view name;
};
// Without these no force can be created, set or stopped. All others may be missing, even reset and enabling,
// which a device that is always on omits. Linux's hid-pidff needs more: gain, pool and block free, trigger
// and direction.
constexpr std::array<Need, 12> kNeeds{{
    {PidUsage::kCreateEffect, usage(PidUsage::kConstantForceType), "the effect type of Create New Effect"},
    {PidUsage::kBlockLoad, usage(PidUsage::kBlockIndex), "the block index of Block Load"},
    {PidUsage::kBlockLoad, usage(PidUsage::kLoadOk), "the status of Block Load"},
    {PidUsage::kSetEffect, usage(PidUsage::kBlockIndex), "the block index of Set Effect"},
    {PidUsage::kSetEffect, usage(PidUsage::kConstantForceType), "the effect type of Set Effect"},
    {PidUsage::kSetEffect, usage(PidUsage::kDuration), "the duration of Set Effect"},
    {PidUsage::kSetConstantForce, usage(PidUsage::kBlockIndex), "the block index of Set Constant Force"},
    {PidUsage::kSetConstantForce, usage(PidUsage::kMagnitude), "the magnitude of Set Constant Force"},
    {PidUsage::kEffectOperation, usage(PidUsage::kBlockIndex), "the block index of Effect Operation"},
    {PidUsage::kEffectOperation, usage(PidUsage::kStart), "the start of Effect Operation"},
    {PidUsage::kEffectOperation, usage(PidUsage::kStop), "the stop of Effect Operation"},
    {PidUsage::kDeviceControlReport, usage(PidUsage::kStopAll), "the stop-all of Device Control"},
}};

constexpr std::array<PidUsage, 10> kReports{
    PidUsage::kCreateEffect,    PidUsage::kBlockLoad,        PidUsage::kBlockFree,
    PidUsage::kSetEffect,       PidUsage::kSetCondition,     PidUsage::kSetConstantForce,
    PidUsage::kEffectOperation, PidUsage::kDeviceGainReport, PidUsage::kDeviceControlReport,
    PidUsage::kState,
};

}  // namespace

ReportKind PidLayout::kind_of(PidUsage report) noexcept {
    switch (report) {
        case PidUsage::kCreateEffect:
        case PidUsage::kBlockLoad:
            return ReportKind::kFeature;
        case PidUsage::kState:
            return ReportKind::kInput;
        default:
            return ReportKind::kOutput;
    }
}

Usage PidLayout::collection_of(PidUsage report) const noexcept {
    return usage(report == PidUsage::kDeviceControlReport ? device_control_ : report);
}

Element PidLayout::element(PidUsage report, Usage wanted) const noexcept {
    return descriptor_.find(kind_of(report), collection_of(report), wanted);
}

ReportPlace PidLayout::place(PidUsage report) const noexcept {
    for (const Field& field : descriptor_.fields()) {
        if (field.kind != kind_of(report) || !descriptor_.is_inside(field.collection, collection_of(report)))
            continue;
        return {field.report_id, descriptor_.report_bytes(field.kind, field.report_id)};
    }
    return {};
}

bool PidLayout::has_effect(PidUsage type) const noexcept {
    return static_cast<bool>(element(PidUsage::kCreateEffect, usage(type))) &&
           static_cast<bool>(element(PidUsage::kSetEffect, usage(type)));
}

Element PidLayout::axis(Axis axis) const noexcept {
    return descriptor_.find(ReportKind::kInput, 0, axis == Axis::kX ? kUsageX : kUsageY);
}

Result<PidLayout> PidLayout::find(ReportDescriptor descriptor) {
    PidLayout layout(std::move(descriptor));
    const auto lacks = [](std::string_view what) {
        return bad_input(fmt::format("force feedback (USB PID 1.0): expected {}, found none", what));
    };
    if (!layout.descriptor_.numbers_reports()) return lacks("numbered reports");
    if (!layout.place(PidUsage::kDeviceControlReport)) layout.device_control_ = PidUsage::kDeviceControlList;
    for (const Need& need : kNeeds) {
        const Element element = layout.element(need.report, need.field);
        if (!element || element.field->report_id != layout.place(need.report).id) return lacks(need.name);
    }
    if (!layout.element(PidUsage::kBlockLoad, usage(PidUsage::kLoadOk)).field->is_array)
        return lacks("a status of Block Load that is one of a list");
    for (const Axis axis : kBothAxes) {
        const Element element = layout.axis(axis);
        if (!element) return lacks(axis == Axis::kX ? "a stick axis X" : "a stick axis Y");
        if (element.field->is_array || element.field->is_relative ||
            element.field->logical_max == element.field->logical_min)
            return lacks("stick axes that tell a place");
    }
    if (layout.axis(Axis::kX).field->report_id != layout.axis(Axis::kY).field->report_id)
        return lacks("both stick axes in one report");
    for (const PidUsage report : kReports) {
        const ReportPlace place = layout.place(report);
        if (place.bytes > kUsbReportBytes)
            return bad_input(
                fmt::format("force feedback (USB PID 1.0): report {}: expected at most {} bytes, found {}",
                            place.id, kUsbReportBytes, place.bytes));
    }
    return layout;
}

bool take_stick_report(const PidLayout& layout, std::span<const std::uint8_t> report,
                       StickState& state) noexcept {
    const Element x = layout.axis(Axis::kX);
    const Element y = layout.axis(Axis::kY);
    if (report.empty() || report[0] != x.field->report_id) return false;
    const std::span<const std::uint8_t> data = report.subspan(1);
    const auto deflection = [&](Element axis) -> std::optional<double> {
        const auto value = read_element(data, axis);
        if (!value) return std::nullopt;
        const auto least = static_cast<double>(axis.field->logical_min);
        const auto most = static_cast<double>(axis.field->logical_max);
        return std::clamp((2.0 * static_cast<double>(*value) - least - most) / (most - least), -1.0, 1.0);
    };
    const auto right = deflection(x);
    const auto towards = deflection(y);
    if (!right || !towards) return false;
    state.deflection = {*right, *towards};
    state.buttons = 0;
    for (std::uint16_t button = 0; button < kMostButtons; ++button) {
        const Element element = layout.descriptor().find(
            ReportKind::kInput, 0, usage(kButtonPage, static_cast<std::uint16_t>(button + 1)));
        if (!element || element.field->is_array || element.field->report_id != report[0]) break;
        if (read_element(data, element).value_or(0) != 0) state.buttons |= 1U << button;
    }
    return true;
}

std::optional<PidDeviceState> pid_device_state(const PidLayout& layout,
                                               std::span<const std::uint8_t> report) noexcept {
    const ReportPlace place = layout.place(PidUsage::kState);
    if (!place || report.size() < 2 || report[0] != place.id) return std::nullopt;
    PidDeviceState state;
    const auto flag = [&](PidUsage wanted, bool otherwise) {
        const Element element = layout.element(PidUsage::kState, usage(wanted));
        if (!element || element.field->is_array) return otherwise;
        const auto value = read_element(report.subspan(1), element);
        return value ? *value != 0 : otherwise;
    };
    state.actuators_enabled = flag(PidUsage::kActuatorsEnabled, true);
    state.safety_switch_on = flag(PidUsage::kSafetySwitch, true);
    return state;
}

}  // namespace onggi::haptics::hid
