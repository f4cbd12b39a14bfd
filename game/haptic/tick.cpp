#include "game/haptic/tick.h"

#include <algorithm>
#include <cassert>

#include "engine/core/hash.h"

namespace onggi::haptic {
namespace {

void tick_paper(clay::PaperClay& clay, HapticState& state, const tool::ToolState& tool,
                const HapticParameters& parameters, TickResult& result) noexcept {
    // The paper's clay has neither sides nor tools, so they are not recorded.
    state.tool = tool::plain_tool(tool::within_limits(tool, state.tool));
    if (state.tool.wheel_button) state.wheel.turn(parameters.paper.wheel_speed_rad_s * parameters.dt_s());
    result.forces = clay.tick({.position_mm = state.tool.position_mm,
                               .radius_mm = state.tool.radius_mm,
                               .wheel_turning = state.tool.wheel_button},
                              parameters.paper);
}

// Lifts both hands over the rim, where they are on neither side of a wall.
void lift_over(tool::ToolState& tool, double height_mm) noexcept {
    constexpr double kClearMm = 1.0;
    const auto over_mm = [&](double radius_mm) { return height_mm + radius_mm + kClearMm; };
    tool.position_mm.y = std::max(tool.position_mm.y, over_mm(tool.radius_mm));
    tool.second.position_mm.y = std::max(tool.second.position_mm.y, over_mm(tool.second.radius_mm));
}

void tick_studio(clay::StudioClay& clay, HapticState& state, const tool::ToolState& tool,
                 const HapticParameters& parameters, bool comes_anew, TickResult& result) noexcept {
    state.tool = tool::within_limits(tool, state.tool);
    if (comes_anew) lift_over(state.tool, clay.height_mm());
    const clay::StudioForces forces = clay.tick(state.tool, parameters.studio);
    result.forces = forces.hand;
    result.second_forces = forces.second;
    result.second_position_mm = forces.second_position_mm;
    result.has_second = forces.has_second;
    result.side = forces.side;
    result.second_side = forces.second_side;
    result.wheel_load_n_mm = forces.wheel_load_n_mm;
    result.grip = forces.grip;
}

// The force for the device. The safety chain uses the device's own position, not the position that the clay
// got.
dvec3 limited_force(HapticState& state, const tool::ToolState& tool, const HapticParameters& parameters,
                    const DeviceTick& device, const clay::ContactForces& forces) noexcept {
    const double dt_s = device.dt_s > 0.0 ? device.dt_s : parameters.dt_s();
    const bool is_studio = state.studio() != nullptr;
    const dvec3 velocity_mm_s = state.velocity.update(tool.position_mm, dt_s);
    const double viscosity =
        is_studio ? parameters.studio.viscosity_c2_n_s_per_mm : parameters.paper.viscosity_c2_n_s_per_mm;
    const DeviceForce force =
        device_force(forces, velocity_mm_s, viscosity, is_studio, parameters.feel, device.signs.shows_wall);
    return haptics::apply_safety_chain(force.wanted_n + device.test_force_n,
                                       {.position_mm = tool.position_mm,
                                        .dt_s = dt_s,
                                        .velocity_mm_s = velocity_mm_s,
                                        .driven_force_n = force.driven_n + device.test_force_n,
                                        .applied_fraction = device.signs.force_fraction,
                                        .late = device.late,
                                        .position_is_new = device.signs.position_is_new,
                                        .hand_is_there = device.signs.hand_is_there,
                                        .stop = device.stop},
                                       parameters.safety, state.safety);
}

}  // namespace

double HapticState::height_mm() const {
    return std::visit([](const auto& there) { return there.height_mm(); }, clay);
}

double HapticState::volume_mm3() const {
    return std::visit([](const auto& there) { return there.volume_mm3(); }, clay);
}

int HapticState::element_count() const {
    return studio() != nullptr ? studio()->lump().rings : paper()->element_count();
}

int HapticState::sector_count() const {
    return studio() != nullptr ? studio()->sector_count() : 1;
}

const clay::Rotation& HapticState::heading() const {
    return studio() != nullptr ? studio()->wheel().heading() : wheel.heading();
}

std::uint64_t HapticState::hash() const {
    StateHash hash;
    hash.add_word(std::visit([](const auto& there) { return there.state_hash(); }, clay));
    hash.add(wheel.heading().cosine);
    hash.add(wheel.heading().sine);
    hash.add_word(ticks);
    return hash.value();
}

void HapticState::restart_from(const HapticState& fresh) noexcept {
    assert(clay.index() == fresh.clay.index() && element_count() == fresh.element_count());
    if (clay::StudioClay* there = studio()) {
        there->restart_from(*fresh.studio());
    } else {
        clay = fresh.clay;
    }
    wheel = fresh.wheel;
    tool = fresh.tool;
    ticks = fresh.ticks;
}

void HapticState::take_memory() noexcept {
    if (clay::StudioClay* there = studio()) there->take_memory();
}

TickResult tick(HapticState& state, const tool::ToolState& tool, const HapticParameters& parameters,
                const DeviceTick& device) noexcept {
    TickResult result;
    if (clay::PaperClay* paper = state.paper()) {
        tick_paper(*paper, state, tool, parameters, result);
    } else {
        tick_studio(*state.studio(), state, tool, parameters, device.comes_anew, result);
    }
    result.limited_force_n = limited_force(state, tool, parameters, device, result.forces);

    ++state.ticks;
    return result;
}

}  // namespace onggi::haptic
