// Layout, little-endian. The paper's clay: "HST1"; c1, c2, c3, K turning, K standing, wheel speed, minimum
// radius; the wheel's cosine and sine; the tool's x, y, z and radius (doubles); its button (32 bits); ticks
// (64 bits); the clay. The studio's clay: "HST3"; its parameters (doubles, yes and no as 1 and 0); the tool
// (tool_bytes); ticks (64 bits); the clay, with its wheel.
#include "game/haptic/start_state.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "engine/core/little_endian.h"
#include "engine/record/tool_bytes.h"

namespace onggi::haptic {
namespace {

constexpr std::uint32_t kPaperTag = 0x31545348;   // "HST1"
constexpr std::uint32_t kStudioTag = 0x33545348;  // "HST3"
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

template <typename Parameters>
auto stored_studio_numbers(Parameters& clay) {
    return std::array{&clay.flow_time_s,
                      &clay.yield_depth_mm,
                      &clay.wall_fraction_k0,
                      &clay.thin_wall_mm,
                      &clay.hoop_fraction_chi,
                      &clay.field_length_beta,
                      &clay.floor_mm,
                      &clay.largest_strain_rate,
                      &clay.centring_time_s,
                      &clay.rounding_time_s,
                      &clay.denting_time_s,
                      &clay.sponge_length_mm,
                      &clay.rib_length_mm,
                      &clay.trim_time_s,
                      &clay.sponge_water_ml_s,
                      &clay.slip_mm_s,
                      &clay.evaporation_g_mm2_s,
                      &clay.film_time_s,
                      &clay.diffusivity_mm2_s,
                      &clay.bearing_factor_nc,
                      &clay.viscosity_c2_n_s_per_mm,
                      &clay.friction_dry,
                      &clay.friction_wet,
                      &clay.largest_force_n,
                      &clay.wheel.inertia_kg_m2,
                      &clay.wheel.largest_torque_n_mm,
                      &clay.wheel.drag_n_mm_s,
                      &clay.wheel.pull_n_mm_s};
}

template <typename Parameters>
auto stored_studio_switches(Parameters& clay) {
    return std::array{&clay.slumps, &clay.forgiving, &clay.wheel.can_brake};
}

constexpr std::size_t kStudioParameters =
    std::tuple_size_v<decltype(stored_studio_numbers(std::declval<clay::StudioParameters&>()))> +
    std::tuple_size_v<decltype(stored_studio_switches(std::declval<clay::StudioParameters&>()))>;
constexpr std::size_t kStudioToolAt = 4 + kStudioParameters * 8;
constexpr std::size_t kStudioTicksAt = kStudioToolAt + record::kWholeToolBytes;
constexpr std::size_t kStudioHeadBytes = kStudioTicksAt + 8;

Error damaged(std::string_view place, std::string_view expected, std::string_view found) {
    return bad_input(fmt::format("start state, {}: expected {}, found {}", place, expected, found));
}

std::vector<std::byte> paper_bytes(const HapticState& state, const clay::PaperClay& paper,
                                   const HapticParameters& parameters) {
    std::vector<std::byte> bytes;
    little_endian::put(bytes, kPaperTag);
    for (const double* parameter : stored_parameters(parameters.paper))
        little_endian::put(bytes, *parameter);
    little_endian::put(bytes, state.wheel.heading().cosine);
    little_endian::put(bytes, state.wheel.heading().sine);
    for (const double number : {state.tool.position_mm.x, state.tool.position_mm.y, state.tool.position_mm.z,
                                state.tool.radius_mm}) {
        little_endian::put(bytes, number);
    }
    little_endian::put(bytes, std::uint32_t{state.tool.wheel_button ? 1U : 0U});
    little_endian::put(bytes, state.ticks);
    const auto clay = paper.start_state();
    bytes.insert(bytes.end(), clay.begin(), clay.end());
    return bytes;
}

std::vector<std::byte> studio_bytes(const HapticState& state, const clay::StudioClay& studio,
                                    const HapticParameters& parameters) {
    std::vector<std::byte> bytes;
    little_endian::put(bytes, kStudioTag);
    for (const double* parameter : stored_studio_numbers(parameters.studio))
        little_endian::put(bytes, *parameter);
    for (const bool* parameter : stored_studio_switches(parameters.studio))
        little_endian::put(bytes, *parameter ? 1.0 : 0.0);
    record::put_whole_tool(bytes, state.tool);
    little_endian::put(bytes, state.ticks);
    const auto clay = studio.start_state();
    bytes.insert(bytes.end(), clay.begin(), clay.end());
    return bytes;
}

Result<void> check_size(std::span<const std::byte> bytes, std::size_t least) {
    if (bytes.size() >= least) return {};
    return damaged("size", fmt::format("at least {} bytes", least), fmt::format("{}", bytes.size()));
}

Result<Start> paper_start(std::span<const std::byte> bytes, double rate_hz) {
    std::size_t at = 4;
    const auto next = [&] { return little_endian::get_double(bytes.data() + std::exchange(at, at + 8)); };

    HapticParameters parameters;
    parameters.set_rate_hz(rate_hz);
    for (double* parameter : stored_parameters(parameters.paper))
        *parameter = next();
    if (auto valid = clay::check(parameters.paper); !valid) return valid.error();

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

Result<Start> studio_start(std::span<const std::byte> bytes, double rate_hz) {
    std::size_t at = 4;
    const auto next = [&] { return little_endian::get_double(bytes.data() + std::exchange(at, at + 8)); };

    HapticParameters parameters;
    parameters.set_rate_hz(rate_hz);
    for (double* parameter : stored_studio_numbers(parameters.studio))
        *parameter = next();
    for (bool* parameter : stored_studio_switches(parameters.studio)) {
        const double word = next();
        if (word != 0.0 && word != 1.0) return damaged("switch", "0 or 1", fmt::format("{}", word));
        *parameter = word == 1.0;
    }
    if (auto valid = clay::check(parameters.studio); !valid) return valid.error();
    if (const auto wrong = record::fault_of_whole_tool(bytes.data() + kStudioToolAt)) {
        return damaged("tool", wrong->expected, wrong->found);
    }
    auto clay = clay::StudioClay::from_start_state(bytes.subspan(kStudioHeadBytes));
    if (!clay) return clay.error();
    Start start{HapticState(std::move(clay).value()), parameters};
    start.state.tool = record::get_whole_tool(bytes.data() + kStudioToolAt);
    start.state.ticks = little_endian::get<std::uint64_t>(bytes.data() + kStudioTicksAt);
    return start;
}

}  // namespace

std::vector<std::byte> start_state_bytes(const HapticState& state, const HapticParameters& parameters) {
    if (const clay::StudioClay* studio = state.studio()) return studio_bytes(state, *studio, parameters);
    return paper_bytes(state, *state.paper(), parameters);
}

record::SessionHeader session_header(const Start& start) {
    const bool studio = start.state.studio() != nullptr;
    return {.rate_hz = start.parameters.rate_hz(),
            .element_count = static_cast<std::uint32_t>(start.state.element_count()),
            .sector_count = static_cast<std::uint32_t>(start.state.sector_count()),
            .tool_detail = studio ? record::ToolDetail::kWhole : record::ToolDetail::kPlain,
            .start_state_hash = start.state.hash()};
}

Result<Start> start_from_bytes(std::span<const std::byte> bytes, double rate_hz) {
    if (auto whole = check_size(bytes, kHeadBytes); !whole) return whole.error();
    const auto tag = little_endian::get<std::uint32_t>(bytes.data());
    if (tag == kPaperTag) return paper_start(bytes, rate_hz);
    if (tag != kStudioTag) {
        return damaged("tag", fmt::format("{:08x} or {:08x}", kPaperTag, kStudioTag),
                       fmt::format("{:08x}", tag));
    }
    if (auto whole = check_size(bytes, kStudioHeadBytes); !whole) return whole.error();
    return studio_start(bytes, rate_hz);
}

}  // namespace onggi::haptic
