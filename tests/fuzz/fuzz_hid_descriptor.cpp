// Any bytes are refused or are a report descriptor that keeps every promise of report_descriptor.h; output to
// a joystick found in it stays within its reports.
#include <cstddef>
#include <cstdint>

#include "engine/haptics/hid/hid_kind.h"
#include "engine/haptics/hid/pid_reports.h"
#include "tests/fuzz/fuzz_expect.h"

namespace {

using namespace onggi;                // NOLINT: one program
using namespace onggi::haptics::hid;  // NOLINT

void check_fields(const ReportDescriptor& descriptor) {
    std::array<std::uint8_t, kMaxReportBits / 8> data{};
    for (const Field& field : descriptor.fields()) {
        fuzz::expect(field.bit_size >= 1 && field.bit_size <= 32 && field.count >= 1);
        fuzz::expect(field.logical_min <= field.logical_max);
        fuzz::expect(field.collection < static_cast<int>(descriptor.collections().size()));
        const std::size_t bytes = descriptor.report_bytes(field.kind, field.report_id);
        fuzz::expect(bytes >= 1 && bytes <= kMaxReportBits / 8 + 1);
        const std::size_t last_bit = field.bit_offset + std::size_t{field.bit_size} * field.count;
        fuzz::expect(last_bit <= 8 * (bytes - (descriptor.numbers_reports() ? 1 : 0)));
        for (const std::uint32_t index : {0U, field.count / 2, field.count - 1}) {
            for (const std::int64_t value : {field.logical_min, field.logical_max}) {
                write_element(data, {&field, index}, value);
                fuzz::expect(read_element(data, {&field, index}).has_value());
            }
        }
        fuzz::expect(!read_element(data, {&field, field.count}));
    }
    for (std::size_t at = 0; at < descriptor.collections().size(); ++at)
        fuzz::expect(descriptor.collections()[at].parent < static_cast<int>(at));
}

void expect_fits(const PidLayout& layout, PidUsage kind, const Report& report) {
    fuzz::expect(report.size <= kMaxReportBytes);
    if (report.size == 0) return;
    fuzz::expect(report.size == layout.place(kind).bytes && report.bytes[0] == layout.place(kind).id);
}

void check_joystick(const PidLayout& layout) {
    for (const PidUsage type :
         {PidUsage::kConstantForceType, PidUsage::kSpringType, PidUsage::kFrictionType}) {
        expect_fits(layout, PidUsage::kCreateEffect, create_effect(layout, type));
        expect_fits(
            layout, PidUsage::kSetEffect,
            set_effect(layout,
                       {.block = 255, .type = type, .duration_ms = 1 << 20, .direction_turns = -7.3}));
    }
    for (const Axis axis : kBothAxes)
        expect_fits(layout, PidUsage::kSetCondition,
                    set_condition(layout, 255, axis, {.centre = -9.0, .positive_coefficient = 9.0}));
    expect_fits(layout, PidUsage::kSetConstantForce, set_constant_force(layout, 1, -2.0));
    expect_fits(layout, PidUsage::kEffectOperation,
                effect_operation(layout, 1, PidUsage::kStart, kLoopForever));
    expect_fits(layout, PidUsage::kBlockFree, block_free(layout, 1));
    expect_fits(layout, PidUsage::kDeviceControlReport, device_control(layout, PidUsage::kStopAll));
    expect_fits(layout, PidUsage::kDeviceGainReport, device_gain(layout, 1.0));
    std::array<std::uint8_t, kMaxReportBytes> report{};
    for (const PidUsage kind : {PidUsage::kBlockLoad, PidUsage::kState}) {
        report[0] = layout.place(kind).id;
        for (const std::size_t size : {std::size_t{1}, std::size_t{3}, report.size()}) {
            (void)block_load(layout, std::span(report).first(size));
            (void)pid_device_state(layout, std::span(report).first(size));
        }
    }
    StickState stick;
    report[0] = layout.axis(Axis::kX).field->report_id;
    (void)take_stick_report(layout, report, stick);
    for (const double deflection : {stick.deflection.x, stick.deflection.y})
        fuzz::expect(deflection >= -1.0 && deflection <= 1.0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span bytes(data, size);
    haptics::HidDeviceInfo device{.vendor_id = 0x1234, .may_open = true};
    device.report_descriptor.assign(bytes.begin(), bytes.end());
    recognise(device);
    fuzz::expect(device.refusal.find('\n') == std::string::npos);

    auto descriptor = ReportDescriptor::parse(bytes);
    if (!descriptor) {
        fuzz::expect(descriptor.error().kind == ErrorKind::kBadInput && !device.refusal.empty());
        return 0;
    }
    check_fields(*descriptor);
    const auto layout = PidLayout::find(std::move(descriptor).value());
    if (layout) check_joystick(*layout);
    return 0;
}
