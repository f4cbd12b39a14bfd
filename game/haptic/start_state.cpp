// Layout, little-endian. The paper's clay: "HST1"; c1, c2, c3, K turning, K standing, wheel speed, minimum
// radius; the wheel's cosine and sine; the tool's x, y, z and radius (doubles); its button (32 bits); ticks
// (64 bits); the clay. The studio's clay: "HST4"; its parameters (doubles; flags as 1 and 0); the manner of
// the hands (double); the tool (tool_bytes); ticks (64 bits); the clay, with its wheel. "HST3" is the same
// without the manner, for the narrow one.
#include "game/haptic/start_state.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "engine/core/little_endian.h"
#include "game/clay/state_numbers.h"
#include "game/tool/tool_bytes.h"

namespace onggi::haptic {
namespace {

constexpr std::uint32_t kPaperTag = 0x31545348;   // "HST1"
constexpr std::uint32_t kNarrowTag = 0x33545348;  // "HST3"
constexpr std::uint32_t kStudioTag = 0x34545348;  // "HST4"
using clay::studio::Manner;

constexpr std::size_t kHeadBytes = 4 + (7 + 2 + 4) * 8 + 4 + 8;

// Visits the fields before the paper's clay, in the order of the file; the rate is not among them.
template <typename Visitor, typename Parameters, typename Heading, typename Tool, typename Ticks>
void visit_head(Visitor& visitor, Parameters& paper, Heading& heading, Tool& tool, Ticks& ticks) {
    clay::visit(visitor, paper.softness_c1_per_mm, paper.viscosity_c2_n_s_per_mm,
                paper.friction_c3_n_s_per_mm, paper.stiffness_turning_n_per_mm,
                paper.stiffness_standing_n_per_mm, paper.wheel_speed_rad_s, paper.minimum_radius_mm,
                heading.cosine, heading.sine, tool.position_mm, tool.radius_mm, tool.wheel_button, ticks);
}

// Visits the parameters of the studio's clay. Returns the first flag that is neither 0 nor 1.
template <typename Visitor, typename Parameters>
std::optional<double> visit_head(Visitor& visitor, Parameters& clay) {
    auto& wheel = clay.wheel;
    clay::visit(visitor, clay.flow_time_s, clay.yield_depth_mm, clay.wall_fraction_k0, clay.thin_wall_mm,
                clay.hoop_fraction_chi, clay.field_length_beta, clay.floor_mm, clay.largest_strain_rate,
                clay.centring_time_s, clay.rounding_time_s, clay.denting_time_s, clay.sponge_length_mm,
                clay.rib_length_mm, clay.trim_time_s, clay.sponge_water_ml_s, clay.slip_mm_s,
                clay.evaporation_g_mm2_s, clay.film_time_s, clay.diffusivity_mm2_s, clay.bearing_factor_nc,
                clay.viscosity_c2_n_s_per_mm, clay.friction_dry, clay.friction_wet, clay.largest_force_n,
                wheel.inertia_kg_m2, wheel.largest_torque_n_mm, wheel.drag_n_mm_s, wheel.pull_n_mm_s);
    std::optional<double> strange;
    for (auto* chosen : {&clay.slumps, &clay.forgiving, &wheel.can_brake}) {
        double word = *chosen ? 1.0 : 0.0;
        clay::visit(visitor, word);
        if constexpr (!std::is_const_v<Parameters>) *chosen = word == 1.0;
        if (word != 0.0 && word != 1.0 && !strange) strange = word;
    }
    return strange;
}
constexpr std::size_t kStudioTailBytes = tool::kWholeToolBytes + 8;  // between the parameters and the clay

Error damaged(std::string_view place, std::string_view expected, std::string_view found) {
    return bad_input(fmt::format("start state, {}: expected {}, found {}", place, expected, found));
}

std::vector<std::byte> paper_bytes(const HapticState& state, const clay::PaperClay& paper,
                                   const HapticParameters& parameters) {
    clay::StateWriter out;
    out.number(kPaperTag);
    visit_head(out, parameters.paper, state.wheel.heading(), state.tool, state.ticks);
    std::vector<std::byte> bytes = out.take();
    const auto clay = paper.start_state();
    bytes.insert(bytes.end(), clay.begin(), clay.end());
    return bytes;
}

std::vector<std::byte> studio_bytes(const HapticState& state, const clay::StudioClay& studio,
                                    const HapticParameters& parameters) {
    clay::StateWriter out;
    const bool is_narrow = parameters.studio.manner == Manner::kNarrow;
    out.number(is_narrow ? kNarrowTag : kStudioTag);
    visit_head(out, parameters.studio);
    if (!is_narrow) out.number(static_cast<double>(parameters.studio.manner));
    std::vector<std::byte> bytes = out.take();
    tool::put_whole_tool(bytes, state.tool);
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
    HapticParameters parameters;
    parameters.set_rate_hz(rate_hz);
    clay::StateReader in(bytes.subspan(4));
    clay::Rotation heading;
    tool::ToolState tool;
    std::uint64_t ticks = 0;
    visit_head(in, parameters.paper, heading, tool, ticks);
    if (auto valid = clay::check(parameters.paper); !valid) return valid.error();
    const double length2 = heading.cosine * heading.cosine + heading.sine * heading.sine;
    if (!(std::fabs(length2 - 1.0) < 1e-9))
        return damaged("wheel direction", "a unit vector", fmt::format("squared length {}", length2));
    if (tool::within_limits(tool, {}) != tool) {
        return damaged("tool", "one within its limits",
                       fmt::format("({}, {}, {}) mm, radius {} mm", tool.position_mm.x, tool.position_mm.y,
                                   tool.position_mm.z, tool.radius_mm));
    }
    if (const auto button = in.strange()) return damaged("button", "0 or 1", fmt::format("{}", *button));

    auto clay = clay::PaperClay::from_start_state(bytes.subspan(kHeadBytes));
    if (!clay) return clay.error();
    Start start{HapticState(std::move(clay).value()), parameters};
    start.state.wheel = clay::WheelAngle(heading);
    start.state.tool = tool;
    start.state.ticks = ticks;
    return start;
}

Result<Start> studio_start(std::span<const std::byte> bytes, double rate_hz, bool is_narrow) {
    HapticParameters parameters;
    parameters.set_rate_hz(rate_hz);
    clay::StateReader in(bytes.subspan(4));
    const auto strange = visit_head(in, parameters.studio);
    double manner = static_cast<double>(Manner::kWide);
    if (!is_narrow) clay::visit(in, manner);
    const std::size_t tool_at = 4 + in.asked();
    if (auto whole = check_size(bytes, tool_at + kStudioTailBytes); !whole) return whole.error();
    if (manner != static_cast<double>(Manner::kWide))
        return damaged("manner of the hands", fmt::format("{}", static_cast<int>(Manner::kWide)),
                       fmt::format("{}", manner));
    parameters.studio.manner = is_narrow ? Manner::kNarrow : Manner::kWide;
    if (strange) return damaged("switch", "0 or 1", fmt::format("{}", *strange));
    if (auto valid = clay::check(parameters.studio); !valid) return valid.error();
    const std::byte* const tool = bytes.data() + tool_at;
    if (const auto wrong = tool::fault_of_whole_tool(tool))
        return damaged("tool", wrong->expected, wrong->found);
    auto clay = clay::StudioClay::from_start_state(bytes.subspan(tool_at + kStudioTailBytes));
    if (!clay) return clay.error();
    Start start{HapticState(std::move(clay).value()), parameters};
    start.state.tool = tool::get_whole_tool(tool);
    start.state.ticks = little_endian::get<std::uint64_t>(tool + tool::kWholeToolBytes);
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
    if (tag != kStudioTag && tag != kNarrowTag) {
        return damaged("tag", fmt::format("{:08x}, {:08x} or {:08x}", kPaperTag, kNarrowTag, kStudioTag),
                       fmt::format("{:08x}", tag));
    }
    return studio_start(bytes, rate_hz, tag == kNarrowTag);
}

}  // namespace onggi::haptic
