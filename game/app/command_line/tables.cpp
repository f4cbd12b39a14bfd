#include "game/app/command_line/tables.h"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

#include "engine/core/units.h"

namespace onggi::app {
namespace {

void append(std::string& table, double number) {
    // Adding 0 turns -0 into 0: a force of nothing has no sign to show.
    fmt::format_to(std::back_inserter(table), ",{:.9g}", number + 0.0);
}

std::string_view name_of(clay::studio::Side side) {
    switch (side) {
        case clay::studio::Side::kFree:
            return "free";
        case clay::studio::Side::kOut:
            return "outer";
        case clay::studio::Side::kIn:
            return "inner";
        case clay::studio::Side::kTop:
            return "rim";
    }
    return "free";
}

std::string profile_of(const clay::StudioClay& clay) {
    std::string table = "y_mm,outer_mm,inner_mm\n";
    for (int i = 0; i < clay.ring_count(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        fmt::format_to(std::back_inserter(table), "{:.9g}", clay.centre_height_mm(i));
        append(table, clay.outer_mm()[at]);
        append(table, clay.inner_mm()[at]);
        table += '\n';
    }
    return table;
}

std::string profile_of(const clay::PaperClay& clay) {
    std::string table = "y_mm,outer_mm\n";
    const auto radii_mm = clay.radii_mm();
    for (std::size_t i = 0; i < radii_mm.size(); ++i) {
        const double y_mm = (static_cast<double>(i) + 0.5) * clay.element_height_mm();
        fmt::format_to(std::back_inserter(table), "{:.9g}", y_mm);
        append(table, static_cast<double>(radii_mm[i]));
        table += '\n';
    }
    return table;
}

}  // namespace

std::string profile_table(const haptic::HapticState& state) {
    return std::visit([](const auto& clay) { return profile_of(clay); }, state.clay);
}

std::string forces_header(const haptic::HapticState& state) {
    std::string header = "tick,t_s,contacts,fs_x_N,fs_y_N,fs_z_N,fv_x_N,fv_y_N,fv_z_N,ff_x_N,ff_y_N,ff_z_N";
    if (state.studio() != nullptr) {
        header += ",side,contacts_2,wheel_rev_min,wheel_load_N_mm,load_index";
    }
    return header + '\n';
}

void append_forces_row(std::string& table, std::uint64_t tick, double rate_hz,
                       const haptic::TickResult& result, const haptic::HapticState& state) {
    const clay::ContactForces& forces = result.forces;
    fmt::format_to(std::back_inserter(table), "{},{:.9g},{}", tick, static_cast<double>(tick) / rate_hz,
                   forces.contacts);
    for (const dvec3& force_n : {forces.stiffness_n, forces.viscosity_n, forces.friction_n}) {
        append(table, force_n.x);
        append(table, force_n.y);
        append(table, force_n.z);
    }
    if (const clay::StudioClay* studio = state.studio()) {
        fmt::format_to(std::back_inserter(table), ",{},{}", name_of(result.side),
                       result.second_forces.contacts);
        append(table, units::rev_min_from_rad_s(studio->wheel().speed_rad_s()));
        append(table, result.wheel_load_n_mm);
        append(table, studio->load_index());
    }
    table += '\n';
}

}  // namespace onggi::app
