#include "game/clay/studio/joining.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "game/clay/studio/studio_parameters.h"

namespace onggi::clay {
namespace {

using studio::Rings;

double mean_radius_mm(const Rings& rings, int i) {
    return 0.5 * (rings.outer_mm[Rings::at(i)] + rings.inner_mm[Rings::at(i)]);
}

Result<void> check_has_rim(const Rings& rings, std::string_view which) {
    const bool open = rings.count > 0 && rings.is_hollow(rings.count - 1);
    for (int i = rings.first_hollow; open && i < rings.count; ++i) {
        if (!rings.is_hollow(i))
            return bad_input(
                fmt::format("joining: the {} pot: expected an open inside, found it closed at "
                            "{:.1f} mm",
                            which, rings.bottom_mm(i)));
    }
    if (!open) return bad_input(fmt::format("joining: the {} pot: expected an open rim, found none", which));
    return {};
}

// Finds the first ring of the upper pot, from its floor, that stays: the new mouth.
Result<int> first_kept(const Rings& upper, double bore_mm) {
    int kept = upper.first_hollow;
    while (kept < upper.count && 2.0 * upper.inner_mm[Rings::at(kept)] < bore_mm)
        ++kept;
    if (kept + 1 < upper.count) return kept;
    return bad_input(
        fmt::format("joining: expected a mouth narrower than the upper pot inside, found {} mm", bore_mm));
}

// 1 at the seam, 0 and flat from `reach` away.
double near_seam(double away_mm, double reach_mm) {
    const double s = away_mm / reach_mm;
    return s < 1.0 ? (1.0 - s * s) * (1.0 - s * s) : 0.0;
}

// Copies a ring's values except its place. The sectors of a ring turned upside down run the other way.
void copy_ring(Rings& to, int i, const Rings& from, int j, bool turned) {
    const std::size_t a = Rings::at(i);
    const std::size_t b = Rings::at(j);
    to.volume_mm3[a] = from.volume_mm3[b];
    to.outer_mm[a] = from.outer_mm[b];
    to.inner_mm[a] = from.inner_mm[b];
    to.centre_x_mm[a] = from.centre_x_mm[b];
    to.centre_z_mm[a] = turned ? -from.centre_z_mm[b] : from.centre_z_mm[b];
    to.rough_mm[a] = from.rough_mm[b];
    to.liquidity[a] = from.liquidity[b];
    to.film[a] = from.film[b];
    to.strength_kpa[a] = from.strength_kpa[b];
    to.load_index[a] = from.load_index[b];
    to.shear[a] = from.shear[b];
    if (!(from.rough_mm[b] > 0.0F)) return;
    const float* source = from.row_of(j);
    float* target = to.row_of(i);
    for (int s = 0; s < from.sectors; ++s)
        target[s] = source[turned ? from.sectors - 1 - s : s];
}

// Blends rings [first, end) towards one wall at the seam and adds the ridge. Uses the places from before, so
// that the order of the rings does not matter.
void ease_to_seam(Rings& rings, int first, int end, double seam_mm, double radius_mm, double wall_mm, int rim,
                  const Joining& joining) {
    const double out = radius_mm - mean_radius_mm(rings, rim);
    const double thicker = wall_mm - rings.wall_mm(rim);
    for (int i = first; i < end; ++i) {
        if (!rings.is_hollow(i)) continue;
        const double away = std::fabs(rings.centre_mm(i) - seam_mm);
        const double eased = near_seam(away, joining.eased_mm);
        const double ridge = joining.ridge_mm * near_seam(away, joining.ridge_reach_mm);
        const double mean = mean_radius_mm(rings, i) + out * eased;
        const double half = 0.5 * (rings.wall_mm(i) + thicker * eased) + ridge;
        const double inner = mean - half;
        const double outer = mean + half;
        // Leave a wall as it is if the blend does not fit.
        if (!(inner > 0.0 && outer <= studio::kWidestMm && 2.0 * half > 0.0)) continue;
        rings.outer_mm[Rings::at(i)] = outer;
        rings.inner_mm[Rings::at(i)] = inner;
    }
}

// Moves rings [first, end) aside: by the full shift far above the seam, by half the shift at the seam, by 0
// far below.
void shift_at_seam(Rings& rings, int first, int end, double seam_mm, const Joining& joining) {
    for (int i = first; i < end; ++i) {
        const double above = rings.centre_mm(i) - seam_mm;
        const double eased = 0.5 * near_seam(std::fabs(above), joining.eased_mm);
        const dvec2 by_mm = joining.shift_mm * (above > 0.0 ? 1.0 - eased : eased);
        rings.centre_x_mm[Rings::at(i)] += static_cast<float>(by_mm.x);
        rings.centre_z_mm[Rings::at(i)] += static_cast<float>(by_mm.y);
    }
}

}  // namespace

void StudioClay::put_back() {
    carried_.cut_off = carried_.wire_was_used = false;
    wheel_.set_speed(0.0);
    carried_.wheel_load_n_mm = carried_.load_height_mm = 0.0;
    hands_ = {};
}

double rim_step_mm(const StudioClay& lower, const StudioClay& upper) {
    return mean_radius_mm(lower.rings(), lower.ring_count() - 1) -
           mean_radius_mm(upper.rings(), upper.ring_count() - 1);
}

double bore_at_width_mm(const StudioClay& pot, double outside_mm) {
    const auto wide = std::find_if(pot.outer_mm().begin(), pot.outer_mm().end(),
                                   [&](double outer) { return 2.0 * outer >= outside_mm; });
    if (wide == pot.outer_mm().end()) return 0.0;
    return 2.0 * pot.inner_mm()[static_cast<std::size_t>(wide - pot.outer_mm().begin())];
}

Result<StudioClay> join_pots(const StudioClay& lower, const StudioClay& upper, const Joining& joining) {
    const Rings& below = lower.rings_;
    const Rings& above = upper.rings_;
    if (auto rim = check_has_rim(below, "lower"); !rim) return rim.error();
    if (auto rim = check_has_rim(above, "upper"); !rim) return rim.error();
    if (below.sectors != above.sectors || lower.lump_.body != upper.lump_.body)
        return bad_input("joining: expected two pots of one clay body and as many sectors");
    const auto kept = first_kept(above, joining.bore_mm);
    if (!kept) return kept.error();
    const int lower_rim = below.count - 1;
    const double step = rim_step_mm(lower, upper);
    if (!(std::fabs(step) <= joining.largest_step_mm)) {
        return bad_input(fmt::format(
            "joining: expected rims that meet, found {:.1f} mm across below and "
            "{:.1f} mm above",
            2.0 * mean_radius_mm(below, lower_rim), 2.0 * mean_radius_mm(above, above.count - 1)));
    }
    StudioLump lump = lower.lump_;
    lump.mass_g += upper.lump_.mass_g;
    if (auto sound = check(lump); !sound)
        return bad_input(fmt::format("joining: both pots together: {}", sound.error().message));
    const int count = below.count + above.count - *kept;
    const double height = below.top_mm() + above.top_mm() - above.bottom_mm(*kept);
    if (count > studio::ring_capacity(lump) || !(height <= studio::kTallestMm)) {
        return bad_input(
            fmt::format("joining: expected both pots within {} mm and {} rings, found {:.0f} "
                        "mm and {} rings",
                        studio::kTallestMm, studio::ring_capacity(lump), height, count));
    }

    StudioClay pot(lump);
    Rings& rings = pot.rings_;
    rings.reset(count);
    for (int i = 0; i < below.count; ++i)
        copy_ring(rings, i, below, i, false);
    for (int i = below.count; i < count; ++i)
        copy_ring(rings, i, above, above.count - 1 - (i - below.count), true);
    rings.find_floor();
    rings.settle(0, count);

    const double seam = rings.bottom_mm(below.count);
    const double radius = 0.5 * (mean_radius_mm(rings, lower_rim) + mean_radius_mm(rings, below.count));
    const double wall = 0.5 * (rings.wall_mm(lower_rim) + rings.wall_mm(below.count));
    ease_to_seam(rings, 0, below.count, seam, radius, wall, lower_rim, joining);
    ease_to_seam(rings, below.count, count, seam, radius, wall, below.count, joining);
    if (joining.shift_mm != dvec2(0.0)) shift_at_seam(rings, 0, count, seam, joining);
    rings.settle(0, count);

    double cut = 0.0;  // whole grains: exact in any order
    for (int i = 0; i < *kept; ++i)
        cut += above.volume_mm3[Rings::at(i)];
    const studio::Ledger& a = lower.ledger_;
    const studio::Ledger& b = upper.ledger_;
    pot.ledger_ = {.lump_mm3 = a.lump_mm3 + b.lump_mm3,
                   .trimmings_mm3 = a.trimmings_mm3 + b.trimmings_mm3 + cut,
                   .slip_mm3 = a.slip_mm3 + b.slip_mm3};
    pot.wheel_ = studio::PoweredWheel(lower.wheel_.heading(), 0.0);
    pot.carried_.film = std::max(lower.carried_.film, upper.carried_.film);
    pot.carried_.splits = lower.carried_.splits + upper.carried_.splits;
    pot.carried_.joins = lower.carried_.joins + upper.carried_.joins;
    // Joining does not undo an earlier failure.
    const bool fell = lower.sweep_.failure.cause != studio::Cause::kNone;
    pot.sweep_ = {};
    studio::restart(pot.sweep_, rings);
    pot.sweep_.failure = fell ? lower.sweep_.failure : upper.sweep_.failure;
    return pot;
}

}  // namespace onggi::clay
