// Layout, little-endian: "HST1"; c1, c2, c3, K turning, K standing, wheel speed, minimum radius; the wheel's
// cosine and sine; the tool's x, y, z and radius (doubles); its button (32 bits); ticks (64 bits); the clay.
#include "game/haptic/start_state.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "engine/core/little_endian.h"

namespace onggi::haptic {
namespace {

constexpr std::uint32_t kTag = 0x31545348;  // "HST1"
constexpr std::size_t kDoubles = 7 + 2 + 4;
constexpr std::size_t kButtonAt = 4 + kDoubles * 8;
constexpr std::size_t kTicksAt = kButtonAt + 4;
constexpr std::size_t kHeadBytes = kTicksAt + 8;

// The parameters in the order of the file; the rate is not among them.
template <typename Parameters>
auto stored_parameters(Parameters& clay) {
    return std::array{
        &clay.softness_c1_per_mm,         &clay.viscosity_c2_n_s_per_mm,     &clay.friction_c3_n_s_per_mm,
        &clay.stiffness_turning_n_per_mm, &clay.stiffness_standing_n_per_mm, &clay.wheel_speed_rad_s,
        &clay.minimum_radius_mm};
}

Error damaged(std::string_view place, std::string_view expected, std::string_view found) {
    return bad_input(fmt::format("start state, {}: expected {}, found {}", place, expected, found));
}

}  // namespace

std::vector<std::byte> start_state_bytes(const HapticState& state, const HapticParameters& parameters) {
    std::vector<std::byte> bytes;
    little_endian::put(bytes, kTag);
    for (const double* parameter : stored_parameters(parameters.clay))
        little_endian::put(bytes, *parameter);
    little_endian::put(bytes, state.wheel.heading().cosine);
    little_endian::put(bytes, state.wheel.heading().sine);
    for (const double number : {state.tool.position_mm.x, state.tool.position_mm.y, state.tool.position_mm.z,
                                state.tool.radius_mm}) {
        little_endian::put(bytes, number);
    }
    little_endian::put(bytes, std::uint32_t{state.tool.wheel_button ? 1U : 0U});
    little_endian::put(bytes, state.ticks);
    const auto clay = state.clay.start_state();
    bytes.insert(bytes.end(), clay.begin(), clay.end());
    return bytes;
}

Result<Start> start_from_bytes(std::span<const std::byte> bytes, double rate_hz) {
    if (bytes.size() < kHeadBytes) {
        return damaged("size", fmt::format("at least {} bytes", kHeadBytes), fmt::format("{}", bytes.size()));
    }
    if (const auto tag = little_endian::get<std::uint32_t>(bytes.data()); tag != kTag) {
        return damaged("tag", fmt::format("{:08x}", kTag), fmt::format("{:08x}", tag));
    }
    std::size_t at = 4;
    const auto next = [&] { return little_endian::get_double(bytes.data() + std::exchange(at, at + 8)); };

    HapticParameters parameters;
    parameters.clay.rate_hz = rate_hz;
    for (double* parameter : stored_parameters(parameters.clay))
        *parameter = next();
    if (auto valid = clay::check(parameters.clay); !valid) return valid.error();

    const double cosine = next();
    const double sine = next();
    if (const double length2 = cosine * cosine + sine * sine; !(std::fabs(length2 - 1.0) < 1e-9)) {
        return damaged("wheel direction", "a unit vector", fmt::format("squared length {}", length2));
    }
    haptics::ToolState tool;
    tool.position_mm.x = next();
    tool.position_mm.y = next();
    tool.position_mm.z = next();
    tool.radius_mm = next();
    if (haptics::within_limits(tool, {}) != tool) {
        return damaged("tool", "one within its limits",
                       fmt::format("({}, {}, {}) mm, radius {} mm", tool.position_mm.x, tool.position_mm.y,
                                   tool.position_mm.z, tool.radius_mm));
    }
    const auto button = little_endian::get<std::uint32_t>(bytes.data() + kButtonAt);
    if (button > 1) return damaged("button", "0 or 1", fmt::format("{}", button));
    tool.wheel_button = button == 1;

    auto clay = clay::PaperClay::from_start_state(bytes.subspan(kHeadBytes));
    if (!clay) return clay.error();
    Start start{HapticState(std::move(clay).value()), parameters};
    start.state.wheel = clay::WheelAngle({cosine, sine});
    start.state.tool = tool;
    start.state.ticks = little_endian::get<std::uint64_t>(bytes.data() + kTicksAt);
    return start;
}

}  // namespace onggi::haptic
