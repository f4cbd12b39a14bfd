#include "game/app/tables.h"

#include <fmt/format.h>

#include <iterator>

namespace onggi::app {
namespace {

void append(std::string& table, double number) {
    // Adding 0 turns -0 into 0: a force of nothing has no sign to show.
    fmt::format_to(std::back_inserter(table), ",{:.9g}", number + 0.0);
}

}  // namespace

std::string profile_table(const clay::PaperClay& clay) {
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

void append_forces_row(std::string& table, std::uint64_t tick, double rate_hz,
                       const clay::ContactForces& forces) {
    fmt::format_to(std::back_inserter(table), "{},{:.9g},{}", tick, static_cast<double>(tick) / rate_hz,
                   forces.contacts);
    for (const dvec3& force_n : {forces.stiffness_n, forces.viscosity_n, forces.friction_n}) {
        append(table, force_n.x);
        append(table, force_n.y);
        append(table, force_n.z);
    }
    table += '\n';
}

}  // namespace onggi::app
