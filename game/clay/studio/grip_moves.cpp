#include "game/clay/studio/grip_moves.h"

#include <algorithm>
#include <cmath>

#include "game/clay/studio/spare_clay.h"

namespace onggi::clay::studio {
namespace {

constexpr double kWidestSkirt = 0.1;  // same zone, opposite sign: wider below
constexpr double kFootZoneMm = 6.0;
constexpr double kFairestFootMm = 0.25;  // largest step there, of a foot that follows the wall above it
constexpr double kFairestStepMm = 0.1;   // largest step of a slope correction while the hands do not move
constexpr int kSlopeReachRings = 24;     // to either side, for a slope

double middle_mm(const Rings& rings, int i) {
    return 0.5 * (rings.outer_mm[at(i)] + rings.inner_mm[at(i)]);
}

// dR/dy of the outer face.
double slope_at(const Rings& rings, int i) {
    const int low = std::max(i - kSlopeReachRings, 0);
    const int high = std::min(i + kSlopeReachRings, rings.count - 1);
    const double rise = rings.centre_mm(high) - rings.centre_mm(low);
    return rise > 1e-6 ? (rings.outer_mm[at(high)] - rings.outer_mm[at(low)]) / rise : 0.0;
}

// Sets new outer faces wanted_mm for rings [low, high). The inner faces follow at the same heights.
Changed take_outer(Rings& rings, GripSpace& space, int low, int high, double y) {
    const int first = rings.first_hollow;
    if (first >= rings.count) {
        // Solid clay is coned and spreads: rings keep their volume and change height.
        for (int i = low; i < high; ++i) {
            rings.outer_mm[at(i)] = space.wanted_mm[at(i)];
            rings.height_mm[at(i)] = ring_height_mm(rings.volume_mm3[at(i)], rings.outer_mm[at(i)], 0.0);
        }
        return {low, high};
    }
    double free = 0.0;
    for (int i = low; i < high; ++i) {
        const double outer = space.wanted_mm[at(i)];
        const double old_outer = rings.outer_mm[at(i)];
        if (outer == old_outer) continue;
        if (i < first) {
            free += reshape(rings, i, outer, 0.0);
            continue;
        }
        const double old_inner = rings.inner_mm[at(i)];
        const double square = old_inner * old_inner + (outer - old_outer) * (outer + old_outer);
        const double slope = slope_at(rings, i);
        const double lean = std::sqrt(1.0 + std::min(slope * slope, 2.5));
        const double thinnest = std::min(old_outer - old_inner, 4.0 * lean);
        const double narrowest = std::min(old_inner, narrowest_bore(old_outer - old_inner));
        double inner = square > narrowest * narrowest ? std::sqrt(square) : narrowest;
        inner = std::min(inner, outer - thinnest);
        if (!(inner > 0.05)) continue;
        free += reshape(rings, i, outer, inner);
    }
    return together({low, high}, share_out(rings, space.weight, y, free));
}

}  // namespace

GripSpace::GripSpace(int capacity)
    : wanted_mm(at(capacity), 0.0),
      second_mm(at(capacity), 0.0),
      weight(at(capacity), 0.0) {}

double outer_face_mm(const Rings& rings, double y) noexcept {
    return rings.outer_mm[Rings::at(rings.ring_at(std::clamp(y, 0.0, rings.top_mm())))];
}

Changed carry_wall(Rings& rings, GripSpace& space, const Carry& carry) noexcept {
    if (carry.step_mm == 0.0 || rings.count < 3) return {};
    const double y = std::clamp(carry.height_mm, 0.0, rings.top_mm());
    const int here = rings.ring_at(y);
    const Rings::Range window = rings.rings_between(y - carry.down_mm, y + carry.up_mm);
    int low = std::min(window.size() > 0 ? window.first : here, here);
    int high = std::max(window.size() > 0 ? window.end : here + 1, here + 1);
    double* const wanted = space.wanted_mm.data();
    const double* const outer = rings.outer_mm.data();
    const auto bounded = [&](int i, double radius, double centre) {
        double least = kNarrowestBoreMm + 4.0;
        double most = kWidestGripMm;
        if (centre < kFootZoneMm) {
            least = carry.foot_least_mm;
            most = carry.foot_most_mm;
        }
        return std::clamp(radius, std::min(least, outer[i]), std::max(most, outer[i]));
    };
    for (int i = low; i < high; ++i) {
        const double centre = rings.centre_mm(i);
        const double off = centre - y;
        const double s = off / (off > 0.0 ? carry.up_mm : carry.down_mm);
        const double rest = std::max(1.0 - s * s, 0.0);
        wanted[i] = bounded(i, outer[i] + carry.step_mm * rest * rest, centre);
    }
    // Limit the wall's slope: from the hand up and down, then from the foot up.
    const double foot_zone = std::min(rings.floor_mm(), kFloorMm) + kFootZoneMm;
    const double most = std::max(std::fabs(carry.step_mm), kFairestStepMm);
    const auto follow = [&](int i, int neighbour) {
        const double centre = rings.centre_mm(i);
        const double rise = std::fabs(centre - rings.centre_mm(neighbour));
        const bool at_foot = centre < foot_zone;
        // A foot may lean out more than it may spread below.
        double leans = (at_foot ? carry.steepest_at_foot : carry.steepest) * rise;
        if (carry.keeps_slopes) leans = std::max(leans, std::fabs(outer[i] - outer[neighbour]));
        const double spreads = (at_foot ? kWidestSkirt : carry.steepest) * rise;
        const bool is_above = i > neighbour;
        const double kept = std::clamp(wanted[i], wanted[neighbour] - (is_above ? spreads : leans),
                                       wanted[neighbour] + (is_above ? leans : spreads));
        const double fastest = at_foot ? std::max(most, kFairestFootMm) : most;
        return bounded(i, std::clamp(kept, outer[i] - fastest, outer[i] + fastest), centre);
    };
    for (int i = here + 1; i < rings.count; ++i) {
        const bool is_beyond = i >= high;
        if (is_beyond) wanted[i] = outer[i];
        const double kept = follow(i, i - 1);
        if (is_beyond && kept == wanted[i]) break;
        wanted[i] = kept;
        high = std::max(high, i + 1);
    }
    for (int i = here - 1; i >= 0; --i) {
        const bool is_beyond = i < low;
        if (is_beyond) wanted[i] = outer[i];
        const double kept = follow(i, i + 1);
        if (is_beyond && kept == wanted[i]) break;
        wanted[i] = kept;
        low = std::min(low, i);
    }
    if (low > 0) wanted[low - 1] = outer[low - 1];
    for (int i = std::max(low, 1); i < high; ++i)
        wanted[i] = std::min(wanted[i], std::max(follow(i, i - 1), outer[i] - most));
    return take_outer(rings, space, low, high, y);
}

Changed open_bore(Rings& rings, const Bore& bore) noexcept {
    constexpr double kCornerMm = 17.0;
    constexpr double kThinnestMm = 7.0;
    const int last = rings.count - 1;
    if (last < 0 || !(bore.bottom_mm < rings.top_mm())) return {};
    const double corner = std::min(bore.radius_mm, kCornerMm);
    int first = rings.count;
    // Opening makes the rings rise. All places are those at the start of the step.
    for (int i = last; i >= 0; --i) {
        const double above = rings.centre_mm(i) - bore.bottom_mm;
        if (!(above > 0.0)) break;
        const double off = corner - above;
        const double inset = off > 0.0 ? corner - std::sqrt(std::max(corner * corner - off * off, 0.0)) : 0.0;
        const double ro = rings.outer_mm[at(i)];
        const double ri = rings.inner_mm[at(i)];
        double wanted = std::min(bore.radius_mm - inset, ro - kThinnestMm);
        wanted = std::max(wanted, ri > 0.0 ? ri : 0.1);
        if (wanted <= ri) {
            first = i;
            continue;
        }
        // As fast as the clay can rise: the area loses the part that does not go outward.
        const double area = (ro - ri) * (ro + ri);
        const double most = bore.largest_strain * area / (1.0 - bore.outward);
        const double square = std::min(wanted * wanted, ri * ri + most);
        const double new_inner = std::sqrt(square);
        const double new_outer =
            std::min(std::sqrt(ro * ro + bore.outward * (square - ri * ri)), std::max(kWidestGripMm, ro));
        rings.inner_mm[at(i)] = new_inner;
        rings.outer_mm[at(i)] = new_outer;
        first = i;
    }
    if (first > last) return {};
    for (int i = first; i <= last; ++i) {
        rings.height_mm[at(i)] =
            ring_height_mm(rings.volume_mm3[at(i)], rings.outer_mm[at(i)], rings.inner_mm[at(i)]);
    }
    rings.first_hollow = std::min(rings.first_hollow, first);
    return {first, rings.count};
}

double pull_up(Rings& rings, GripSpace& space, double rise, double largest_strain,
               const Held& held) noexcept {
    constexpr double kSmoothMm = 4.0;
    const int first = rings.first_hollow;
    const int n = rings.count;
    if (first >= n || !(rise > 0.0)) return 0.0;
    double* const weight = space.weight.data();
    for (int i = first; i < n; ++i) {
        const double t = rings.wall_mm(i);
        const double spare = (t - thinnest_mm(rings, rings.centre_mm(i))) / t;
        const double slope = slope_at(rings, i);
        const double s = (rings.centre_mm(i) - held.height_mm) / held.reach_mm;
        const double window = std::max(1.0 - s * s, 0.0);
        weight[i] = spare > 0.0 ? window * window * spare * std::sqrt(1.0 + slope * slope) : 0.0;
    }
    // The two-sided exponential average as two recursions.
    double running = weight[first];
    for (int i = first; i < n; ++i) {
        const double q = rings.height_mm[at(i)] / kSmoothMm;
        weight[i] = running = (running + q * weight[i]) / (1.0 + q);
    }
    double whole = 0.0;
    for (int i = n - 1; i >= first; --i) {
        const double q = rings.height_mm[at(i)] / kSmoothMm;
        running = (running + q * weight[i]) / (1.0 + q);
        weight[i] = rings.wall_mm(i) > thinnest_mm(rings, rings.centre_mm(i)) ? running : 0.0;
        whole += weight[i] * rings.height_mm[at(i)];
    }
    if (!(whole > 1e-3 * (rings.top_mm() - rings.floor_mm()))) return 0.0;
    const double per_weight = rise / whole;
    double risen = 0.0;
    for (int i = first; i < n; ++i) {
        const double height = rings.height_mm[at(i)];
        const double strain = std::min(per_weight * weight[i], largest_strain);
        if (!(strain > 0.0)) continue;
        const double outer = rings.outer_mm[at(i)];
        const double area = rings.volume_mm3[at(i)] / (kPi * height * (1.0 + strain));
        const double inner = std::sqrt(std::max(outer * outer - area, 0.0));
        if (!(inner > rings.inner_mm[at(i)]) || outer - inner < kThinnestWallMm) continue;
        rings.inner_mm[at(i)] = inner;
        rings.height_mm[at(i)] = ring_height_mm(rings.volume_mm3[at(i)], outer, inner);
        risen += rings.height_mm[at(i)] - height;
    }
    rings.place(first, n);
    return risen;
}

Changed press_down(Rings& rings, double sink) noexcept {
    constexpr double kZone = 0.8;  // fraction of the depth
    const int first = rings.first_hollow;
    if (first >= rings.count || !(sink > 0.0)) return {};
    const double top = rings.top_mm();
    const double length = kZone * (top - rings.floor_mm());
    if (!(length > 1.0)) return {};
    const auto weight_of = [&](int i) {
        const double s = (top - rings.centre_mm(i)) / length;
        const double rest = std::max(1.0 - s * s, 0.0);
        return rest * rest;
    };
    double whole = 0.0;
    int low = rings.count;
    for (int i = rings.count - 1; i >= first && weight_of(i) > 0.0; --i) {
        whole += weight_of(i) * rings.height_mm[at(i)];
        low = i;
    }
    if (!(whole > 0.0)) return {};
    const double per_weight = std::min(sink / whole, 0.03);
    for (int i = low; i < rings.count; ++i) {
        const double strain = per_weight * weight_of(i);
        const double ro = rings.outer_mm[at(i)];
        const double ri = rings.inner_mm[at(i)];
        const double gained = (ro - ri) * (ro + ri) * (strain / (1.0 - strain));
        const double square = ri * ri - 0.5 * gained;
        const double kept = std::min(ri, kNarrowestBoreMm);
        const double inner = square > kept * kept ? std::sqrt(square) : kept;
        const double rest = gained - (ri - inner) * (ri + inner);
        const double outer = std::sqrt(ro * ro + rest);
        if (outer > kWidestGripMm) continue;
        rings.outer_mm[at(i)] = outer;
        rings.inner_mm[at(i)] = inner;
        rings.height_mm[at(i)] = ring_height_mm(rings.volume_mm3[at(i)], outer, inner);
    }
    return {low, rings.count};
}

Changed fair_wall(Rings& rings, GripSpace& space, double y, double middle_fraction,
                  double thickness_fraction) noexcept {
    constexpr double kReachMm = 22.0;
    constexpr double kMiddleMm = 4.0;
    constexpr double kThicknessMm = 6.0;
    constexpr double kRimFadeMm = 10.0;
    constexpr double kFloorFadeMm = 8.0;
    Rings::Range range =
        rings.rings_between(y - kReachMm - 2.0 * kThicknessMm, y + kReachMm + 2.0 * kThicknessMm);
    range.first = std::max(range.first, rings.first_hollow);
    if (range.size() < 3) return {};
    const double floor = rings.floor_mm();
    const double top = rings.top_mm();
    double* const middle = space.wanted_mm.data();
    double* const thickness = space.second_mm.data();
    double m = middle_mm(rings, range.first);
    double t = rings.wall_mm(range.first);
    for (int i = range.first; i < range.end; ++i) {
        const double qm = rings.height_mm[at(i)] / kMiddleMm;
        const double qt = rings.height_mm[at(i)] / kThicknessMm;
        middle[i] = m = (m + qm * middle_mm(rings, i)) / (1.0 + qm);
        thickness[i] = t = (t + qt * rings.wall_mm(i)) / (1.0 + qt);
    }
    for (int i = range.end - 1; i >= range.first; --i) {
        const double qm = rings.height_mm[at(i)] / kMiddleMm;
        const double qt = rings.height_mm[at(i)] / kThicknessMm;
        middle[i] = m = (m + qm * middle[i]) / (1.0 + qm);
        thickness[i] = t = (t + qt * thickness[i]) / (1.0 + qt);
    }
    double free = 0.0;
    for (int i = range.first; i < range.end; ++i) {
        const double centre = rings.centre_mm(i);
        const double s = (centre - y) * (1.0 / kReachMm);
        if (!(s * s < 1.0)) continue;
        const double at_rim = std::min((top - centre) * (1.0 / kRimFadeMm), 1.0);
        const double at_floor = std::min((centre - floor) * (1.0 / kFloorFadeMm), 1.0);
        const double fraction =
            (1.0 - s * s) * (1.0 - s * s) * std::max(at_rim, 0.0) * std::max(at_floor, 0.0);
        const double now_m = middle_mm(rings, i);
        const double now_t = rings.wall_mm(i);
        const double new_m = now_m + fraction * middle_fraction * (middle[i] - now_m);
        const double new_t = now_t + fraction * thickness_fraction * (thickness[i] - now_t);
        if (!(new_m - 0.5 * new_t > 1.0) || !(new_t > kThinnestWallMm)) continue;
        free += reshape(rings, i, new_m + 0.5 * new_t, new_m - 0.5 * new_t);
    }
    return together(range, share_out(rings, space.weight, y, free));
}

Changed carry_up(Rings& rings, GripSpace& space, double y, double fraction) noexcept {
    constexpr double kReachMm = 14.0;
    constexpr double kAheadMm = 24.0;
    double walls = 0.0;
    double thinnest = 0.0;
    for (int i = rings.first_hollow; i < rings.count; ++i) {
        walls += rings.height_mm[at(i)] * rings.wall_mm(i);
        thinnest += rings.height_mm[at(i)] * thinnest_mm(rings, rings.centre_mm(i));
    }
    if (!(walls > thinnest)) return {};
    Rings::Range range = rings.rings_between(y - kReachMm, y + kReachMm);
    range.first = std::max(range.first, rings.first_hollow);
    if (range.size() < 1) return {};
    double free = 0.0;
    for (int i = range.first; i < range.end; ++i) {
        const double centre = rings.centre_mm(i);
        const double s = (centre - y) * (1.0 / kReachMm);
        const double now = rings.wall_mm(i);
        const double even = thinnest_mm(rings, centre) * walls / thinnest;
        if (!(s * s < 1.0) || !(now > even)) continue;
        const double weight = fraction * (1.0 - s * s) * (1.0 - s * s);
        const double outer = rings.outer_mm[at(i)];
        free += reshape(rings, i, outer, outer - now + weight * (now - even));
    }
    return together(range, share_out(rings, space.weight, y + kAheadMm, free));
}

Changed soften_lip(Rings& rings, GripSpace& space, double fraction) noexcept {
    constexpr double kEdgeMm = 2.8;  // keeps a lip from getting sharp
    constexpr double kBelowMm = 4.0;
    const int last = rings.count - 1;
    if (last < 0 || !rings.is_hollow(last)) return {};
    const double top = rings.top_mm();
    // The wall just below the edge sets the radius of the round.
    const int below = std::max(rings.ring_at(top - kBelowMm), rings.first_hollow);
    const double half = 0.5 * std::min(rings.wall_mm(below), 9.0);
    const double whole = rings.wall_mm(below);
    int first = rings.count;
    double free = 0.0;
    for (int i = last; i > rings.first_hollow; --i) {
        const double over = rings.centre_mm(i) - (top - half);
        if (!(over > 0.0)) break;
        const double round = half - std::sqrt(std::max(half * half - over * over, 0.0));
        const double wanted = std::max(whole - 2.0 * round, std::min(kEdgeMm, rings.wall_mm(i)));
        const double now = rings.wall_mm(i);
        const double m = middle_mm(rings, i);
        const double t = now + fraction * (std::min(wanted, now) - now);
        if (t < now && t > kThinnestWallMm && m - 0.5 * t > 1.0)
            free += reshape(rings, i, m + 0.5 * t, m - 0.5 * t);
        first = i;
    }
    return together({first, rings.count}, share_out(rings, space.weight, top - kBelowMm, free));
}

}  // namespace onggi::clay::studio
