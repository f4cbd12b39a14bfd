#include "engine/haptics/hid/pid_reports.h"

#include <algorithm>
#include <cmath>

namespace onggi::haptics::hid {
namespace {

constexpr Usage kFirstOrdinal = usage(0x0a, 1);  // ordinals: the first and second of several like fields
constexpr Usage kSecondOrdinal = usage(0x0a, 2);

// One report being filled.
class Filler {
  public:
    Filler(const PidLayout& layout, PidUsage kind) noexcept : layout_(layout), kind_(kind) {
        const ReportPlace place = layout.place(kind);
        if (!place || place.bytes > kUsbReportBytes) return;
        report_.bytes[0] = place.id;
        report_.size = place.bytes;
    }

    [[nodiscard]] Element element(Usage wanted) const noexcept { return layout_.element(kind_, wanted); }

    // Skips an element that the device lacks.
    void put(Element element, std::int64_t value) noexcept {
        // The usage may belong to another report of the same collection; only this report is filled.
        if (!element || report_.size < 2 || element.field->report_id != report_.bytes[0]) return;
        write_element(std::span(report_.bytes).subspan(1, report_.size - 1), element, value);
    }
    void put(PidUsage wanted, std::int64_t value) noexcept { put(element(usage(wanted)), value); }

    // An array gets the usage's index in its list; a separate field gets 1.
    void choose(PidUsage chosen) noexcept {
        const Element field = element(usage(chosen));
        if (!field) return;
        put(field, field.field->is_array ? array_value_for(*field.field, usage(chosen)).value_or(0) : 1);
    }

    // A fraction of the field's range: 1 is its maximum, -1 the same on the other side of zero.
    void put_fraction(Element element, double fraction) noexcept {
        if (!element) return;
        const double full = static_cast<double>(element.field->logical_max);
        put(element, std::llround(std::clamp(fraction, -1.0, 1.0) * full));
    }
    void put_fraction(PidUsage wanted, double fraction) noexcept {
        put_fraction(element(usage(wanted)), fraction);
    }

    // A direction: the field's maximum stands for a whole turn.
    void put_turns(Element element, double turns) noexcept {
        if (!element) return;
        const double full = static_cast<double>(element.field->logical_max);
        put(element, std::llround((turns - std::floor(turns)) * full));
    }

    [[nodiscard]] const Report& report() const noexcept { return report_; }

  private:
    const PidLayout& layout_;
    PidUsage kind_;
    Report report_;
};

// Axes enable and direction are collections with a field for each axis, named X and Y or by ordinals.
Element member(const PidLayout& layout, PidUsage report, PidUsage collection, Axis axis) noexcept {
    const bool is_x = axis == Axis::kX;
    for (const Field& field : layout.descriptor().fields()) {
        if (field.kind != ReportKind::kOutput ||
            !layout.descriptor().is_inside(field.collection, usage(report)) ||
            !layout.descriptor().is_inside(field.collection, usage(collection)))
            continue;
        std::uint32_t index = 0;
        for (const UsageRange& range : field.usages) {
            for (const Usage wanted : {is_x ? kFirstOrdinal : kSecondOrdinal, is_x ? kUsageX : kUsageY}) {
                if (wanted < range.first || wanted > range.last) continue;
                const std::uint32_t at = index + (wanted - range.first);
                if (at < field.count) return {&field, at};
            }
            index += range.last - range.first + 1;
        }
    }
    return {};
}

}  // namespace

Report create_effect(const PidLayout& layout, PidUsage type) noexcept {
    Filler filler(layout, PidUsage::kCreateEffect);
    filler.choose(type);
    return filler.report();
}

Report block_load_request(const PidLayout& layout) noexcept {
    return Filler(layout, PidUsage::kBlockLoad).report();
}

Report set_effect(const PidLayout& layout, const PidEffect& effect) noexcept {
    Filler filler(layout, PidUsage::kSetEffect);
    filler.put(PidUsage::kBlockIndex, effect.block);
    filler.choose(effect.type);
    filler.put(PidUsage::kDuration, effect.duration_ms);
    filler.put_fraction(PidUsage::kGain, effect.gain);
    // Trigger button, trigger repeat, sample period, start delay and the type-specific offsets stay 0: no
    // button starts it, nothing is delayed, and the device has its own defaults for the rest.
    // A direction makes the axes' bits void, and like Linux's hid-pidff and Windows this leaves them 0:
    // ArduinoJoystickWithFFBLibrary, for one, keeps the condition of each axis only if no other bit is set.
    // With another bit it turns conditions by the direction too, and a spring pushes away from its centre.
    const bool has_direction = static_cast<bool>(filler.element(usage(PidUsage::kDirectionEnable)));
    const auto enable = [&](Axis axis, bool acts) {
        filler.put(member(layout, PidUsage::kSetEffect, PidUsage::kAxesEnable, axis), !has_direction && acts);
    };
    enable(Axis::kX, effect.acts_on_x);
    enable(Axis::kY, effect.acts_on_y);
    filler.put(PidUsage::kDirectionEnable, 1);
    filler.put_turns(member(layout, PidUsage::kSetEffect, PidUsage::kDirection, Axis::kX),
                     effect.direction_turns);
    return filler.report();
}

Report set_condition(const PidLayout& layout, std::uint8_t block, Axis axis,
                     const PidCondition& condition) noexcept {
    Filler filler(layout, PidUsage::kSetCondition);
    // Without an offset field, Y's condition would overwrite X's.
    if (axis == Axis::kY && !filler.element(usage(PidUsage::kParameterBlockOffset))) return {};
    filler.put(PidUsage::kBlockIndex, block);
    filler.put(PidUsage::kParameterBlockOffset, axis == Axis::kX ? 0 : 1);
    filler.put_fraction(PidUsage::kCentre, condition.centre);
    filler.put_fraction(PidUsage::kPositiveCoefficient, condition.positive_coefficient);
    filler.put_fraction(PidUsage::kNegativeCoefficient, condition.negative_coefficient);
    filler.put_fraction(PidUsage::kPositiveSaturation, condition.saturation);
    filler.put_fraction(PidUsage::kNegativeSaturation, condition.saturation);
    filler.put(PidUsage::kDeadBand, 0);
    return filler.report();
}

Report set_constant_force(const PidLayout& layout, std::uint8_t block, double magnitude) noexcept {
    Filler filler(layout, PidUsage::kSetConstantForce);
    filler.put(PidUsage::kBlockIndex, block);
    filler.put_fraction(PidUsage::kMagnitude, magnitude);
    return filler.report();
}

Report effect_operation(const PidLayout& layout, std::uint8_t block, PidUsage operation,
                        std::int64_t loops) noexcept {
    Filler filler(layout, PidUsage::kEffectOperation);
    filler.put(PidUsage::kBlockIndex, block);
    filler.choose(operation);
    filler.put(PidUsage::kLoopCount, loops);
    return filler.report();
}

Report block_free(const PidLayout& layout, std::uint8_t block) noexcept {
    Filler filler(layout, PidUsage::kBlockFree);
    filler.put(PidUsage::kBlockIndex, block);
    return filler.report();
}

Report device_control(const PidLayout& layout, PidUsage control) noexcept {
    Filler filler(layout, PidUsage::kDeviceControlReport);
    if (!filler.element(usage(control))) return {};
    filler.choose(control);
    return filler.report();
}

Report device_gain(const PidLayout& layout, double fraction) noexcept {
    Filler filler(layout, PidUsage::kDeviceGainReport);
    filler.put_fraction(PidUsage::kDeviceGain, fraction);
    return filler.report();
}

std::optional<BlockLoad> block_load(const PidLayout& layout, std::span<const std::uint8_t> report) noexcept {
    const ReportPlace place = layout.place(PidUsage::kBlockLoad);
    if (report.size() < 2 || report[0] != place.id) return std::nullopt;
    const Element block = layout.element(PidUsage::kBlockLoad, usage(PidUsage::kBlockIndex));
    const Element status = layout.element(PidUsage::kBlockLoad, usage(PidUsage::kLoadOk));
    const auto block_value = read_element(report.subspan(1), block);
    const auto status_value = read_element(report.subspan(1), status);
    if (!block_value || !status_value) return std::nullopt;
    BlockLoad load{.block = static_cast<std::uint8_t>(std::clamp<std::int64_t>(*block_value, 0, 255))};
    const Usage told = usage_for_array_value(*status.field, *status_value);
    if (told == usage(PidUsage::kLoadOk)) load.status = BlockLoad::Status::kOk;
    if (told == usage(PidUsage::kLoadFull)) load.status = BlockLoad::Status::kFull;
    if (told == usage(PidUsage::kLoadError)) load.status = BlockLoad::Status::kError;
    return load;
}

}  // namespace onggi::haptics::hid
