#include "engine/haptics/hid/space_mouse.h"

#include <algorithm>
#include <cmath>

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

double shaped_axis(std::int16_t value, const SpaceMouseMapping& mapping) noexcept {
    const double size = std::min(std::abs(static_cast<double>(value)), mapping.full_scale);
    if (size <= mapping.dead_band) return 0.0;
    const double beyond = (size - mapping.dead_band) / (mapping.full_scale - mapping.dead_band);
    const double shaped = beyond * beyond * beyond;
    return value < 0 ? -shaped : shaped;
}

dvec2 space_mouse_rate_mm_s(const SpaceMouseState& state, const SpaceMouseMapping& mapping) noexcept {
    return mapping.fastest_mm_s *
           dvec2(shaped_axis(state.translation[0], mapping), -shaped_axis(state.translation[2], mapping));
}

}  // namespace onggi::haptics::hid
