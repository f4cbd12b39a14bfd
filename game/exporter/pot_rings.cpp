// See pot_rings.h. Any thread but the haptic one.
#include "game/exporter/pot_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace onggi::exporter {
namespace {

// The radius whose circle has the mean area of two heights.
double mean_radius_mm(double low_mm, double high_mm, double low_fraction) {
    return std::sqrt(low_fraction * low_mm * low_mm + (1.0 - low_fraction) * high_mm * high_mm);
}

}  // namespace

PotRings rings_of(const clay::studio::Rings& rings) {
    PotRings pot{.sectors = rings.sectors, .volume_mm3 = rings.on_wheel_mm3()};
    const auto count = PotRings::at(rings.count);
    const auto end = static_cast<std::ptrdiff_t>(count);
    pot.outer_mm.assign(rings.outer_mm.begin(), rings.outer_mm.begin() + end);
    pot.inner_mm.assign(rings.inner_mm.begin(), rings.inner_mm.begin() + end);
    pot.edge_mm.reserve(count + 1);
    pot.centre_mm.reserve(count);
    for (int i = 0; i < rings.count; ++i) {
        const std::size_t at = PotRings::at(i);
        pot.edge_mm.push_back(rings.bottom_mm(i));
        pot.centre_mm.emplace_back(static_cast<double>(rings.centre_x_mm[at]),
                                   static_cast<double>(rings.centre_z_mm[at]));
    }
    pot.edge_mm.push_back(rings.top_mm());
    const auto is_dented = [](float rough_mm) { return rough_mm > 0.0F; };
    if (!std::any_of(rings.rough_mm.begin(), rings.rough_mm.begin() + end, is_dented)) return pot;
    const auto sectors = PotRings::at(rings.sectors);
    pot.dents_mm.resize(count * sectors, 0.0F);
    for (int i = 0; i < rings.count; ++i) {
        const std::size_t at = PotRings::at(i);
        if (is_dented(rings.rough_mm[at]))
            std::copy_n(rings.row_of(i), sectors,
                        pot.dents_mm.begin() + static_cast<std::ptrdiff_t>(at * sectors));
    }
    return pot;
}

PotRings rings_of(double height_mm, std::span<const float> radii_mm) {
    PotRings pot{.outer_mm = {radii_mm.begin(), radii_mm.end()}};
    const auto count = static_cast<double>(radii_mm.size());
    double sum_of_squares = 0.0;
    for (const double radius_mm : pot.outer_mm) {
        pot.edge_mm.push_back(static_cast<double>(pot.edge_mm.size()) * height_mm / count);
        sum_of_squares += radius_mm * radius_mm;
    }
    pot.edge_mm.push_back(height_mm);
    if (!radii_mm.empty()) pot.volume_mm3 = kPi * sum_of_squares * height_mm / count;
    return pot;
}

Result<void> check_rings(const PotRings& rings) {
    if (rings.count() == 0 || PotRings::at(rings.count()) > kMaxRings)
        return bad_input(
            fmt::format("pot: expected 1 to {} rings of clay, found {}", kMaxRings, rings.count()));
    if (!(rings.height_mm() >= kMinHeightMm && rings.height_mm() <= kMaxHeightMm))
        return bad_input(fmt::format("pot: expected a height of {} to {} mm, found {}", kMinHeightMm,
                                     kMaxHeightMm, rings.height_mm()));
    for (int i = 0; i < rings.count(); ++i) {
        const double outer_mm = rings.outer_mm[PotRings::at(i)];
        if (!(outer_mm >= kMinRadiusMm && outer_mm <= kMaxRadiusMm))
            return bad_input(fmt::format("pot: ring {}: expected an outer radius of {} to {} mm, found {}", i,
                                         kMinRadiusMm, kMaxRadiusMm, outer_mm));
        if (!(rings.inner(i) >= 0.0 && rings.inner(i) < outer_mm))
            return bad_input(fmt::format("pot: ring {}: expected an inner radius below {} mm, found {}", i,
                                         outer_mm, rings.inner(i)));
        if (!(rings.ring_mm(i) > 0.0))
            return bad_input(
                fmt::format("pot: ring {}: expected a height above 0 mm, found {}", i, rings.ring_mm(i)));
        if (rings.centre_mm.empty()) continue;
        const dvec2& centre_mm = rings.centre_mm[PotRings::at(i)];
        if (!(std::fabs(centre_mm.x) <= kMaxRadiusMm && std::fabs(centre_mm.y) <= kMaxRadiusMm))
            return bad_input(
                fmt::format("pot: ring {}: expected a centre within {} mm of the axis, found {}, {}", i,
                            kMaxRadiusMm, centre_mm.x, centre_mm.y));
    }
    return {};
}

PotRings halved(const PotRings& rings, Halving how) {
    PotRings out{.sectors = rings.sectors, .volume_mm3 = rings.volume_mm3};
    for (int low = 0, next = 0; low < rings.count(); low = next) {
        const bool has_pair = low + 1 < rings.count() && rings.is_hollow(low) == rings.is_hollow(low + 1);
        const int high = has_pair ? low + 1 : low;
        next = high + 1;
        const std::size_t a = PotRings::at(low);
        const std::size_t b = PotRings::at(high);
        const bool is_mean = has_pair && how == Halving::kMerged;
        const double fraction =
            is_mean ? rings.ring_mm(low) / (rings.edge_mm[b + 1] - rings.edge_mm[a]) : 1.0;
        out.edge_mm.push_back(rings.bottom_mm(low));
        out.outer_mm.push_back(mean_radius_mm(rings.outer_mm[a], rings.outer_mm[b], fraction));
        if (!rings.inner_mm.empty())
            out.inner_mm.push_back(mean_radius_mm(rings.inner_mm[a], rings.inner_mm[b], fraction));
        if (!rings.centre_mm.empty())
            out.centre_mm.push_back(fraction * rings.centre_mm[a] + (1.0 - fraction) * rings.centre_mm[b]);
        const auto low_dents = rings.dents_of(low);
        const auto high_dents = rings.dents_of(high);
        const auto part = static_cast<float>(fraction);
        for (std::size_t s = 0; s < low_dents.size(); ++s)
            out.dents_mm.push_back(part * low_dents[s] + (1.0F - part) * high_dents[s]);
    }
    out.edge_mm.push_back(rings.height_mm());
    return out;
}

}  // namespace onggi::exporter
