#include "game/clay/studio/moves.h"

#include <algorithm>
#include <cmath>

#include "game/clay/studio/volume_grid.h"

namespace onggi::clay::studio {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// The least that is left of the hollow of a ring.
constexpr double kNarrowestHollowMm = 0.05;

}  // namespace

Changed together(const Changed& a, const Changed& b) {
    if (a.size() <= 0) return b;
    if (b.size() <= 0) return a;
    return {std::min(a.first, b.first), std::max(a.end, b.end)};
}

bool set_radii(Rings& rings, int i, double outer, double inner, double largest_strain) noexcept {
    const double height = ring_height_mm(rings.volume_mm3[at(i)], outer, inner);
    const double before = rings.height_mm[at(i)];
    const double thinnest = std::min(kThinnestWallMm, rings.wall_mm(i));
    const double change = height - before;
    // Comparisons that a number which is none fails.
    const bool fits = outer >= std::min(kNarrowestMm, rings.outer_mm[at(i)]) && outer <= kWidestMm &&
                      inner >= 0.0 && outer - inner >= thinnest && change <= 1.1 * largest_strain * before &&
                      change >= -1.1 * largest_strain * before &&
                      (change <= 0.0 || rings.top_mm() <= kTallestMm);
    if (!fits) return false;
    rings.outer_mm[at(i)] = outer;
    rings.inner_mm[at(i)] = inner;
    rings.height_mm[at(i)] = height;
    return true;
}

Changed push_rings(Rings& rings, Contact& contact, const Hand& hand, const Hand* other, double share,
                   const StudioParameters& parameters) noexcept {
    const bool inside = hand.side == Side::kIn;
    const int first = contact.range.first;
    const int n = contact.range.size();
    const double floor = rings.floor_mm();
    const double strain = parameters.largest_strain_rate * parameters.dt_s();
    Changed changed{first + n, first};
    for (int k = 0; k < n; ++k) {
        contact.field[at(k)] = 0.0;
        const double x = contact.push_mm[at(k)];
        if (!(x > 0.0)) continue;
        const int i = first + k;
        const double ro = rings.outer_mm[at(i)];
        const double ri = rings.inner_mm[at(i)];
        const double wall = ro - ri;
        const bool hollow = ri > 0.0;
        const double y = contact.height_mm + contact.offset_mm[at(k)];
        const double lone = other != nullptr ? 1.0 - support_at(rings, i, y, *other) : 1.0;
        const double tie = tie_to_floor(y - floor, wall);
        const double wall_share = hollow ? lone * tie * wall_part(wall, parameters.thin_wall_mm) : 0.0;
        contact.field[at(k)] = x * wall_share;

        // Clay solid to the axis has no other face: from outside all of it rises.
        // Nor is there room inside a neck that is all but closed.
        const double room = inside ? 1.0 : std::min(0.5 * ri, 1.0);
        const double kappa = parameters.wall_share_k0 * lone * (hollow ? tie : 1.0) * room;
        const double area = wall * (ro + ri);
        const double face = inside ? std::max(ri, 1.0) : ro;
        double delta = share * x * (1.0 - wall_share);
        // As fast as the clay can rise, and no thinner or narrower than it may become.
        delta = std::min(delta, strain * area / (2.0 * face * (1.0 - kappa)));
        delta = std::min(delta, wall - std::min(wall, kThinnestWallMm));
        double outer = ro;
        double inner = ri;
        if (inside) {
            inner = ri + delta;
            outer = std::sqrt(ro * ro + kappa * delta * (inner + ri));
        } else {
            delta = std::min(delta, std::max(ro - kNarrowestMm, 0.0));
            outer = ro - delta;
            if (hollow) {
                const double square = ri * ri - kappa * delta * (outer + ro);
                inner = std::sqrt(std::max(square, kNarrowestHollowMm * kNarrowestHollowMm));
            }
        }
        if (!(delta > 0.0) || !set_radii(rings, i, outer, inner, strain)) continue;
        if (inside && !hollow) rings.first_hollow = std::min(rings.first_hollow, i);
        changed.first = std::min(changed.first, i);
        changed.end = i + 1;
    }
    return changed.first < changed.end ? changed : Changed{};
}

Changed press_rim(Rings& rings, const Contact& contact, double share,
                  const StudioParameters& parameters) noexcept {
    const double depth = std::min(contact.rim_depth_mm, kDeepestMm) - parameters.yield_depth_mm;
    if (!(depth > 0.0)) return {};
    const int last = rings.count - 1;
    const double top = rings.top_mm();
    const double length = std::max(6.0, 2.0 * rings.wall_mm(last));
    const double strain = parameters.largest_strain_rate * parameters.dt_s();
    const bool hollow = rings.is_hollow(last);

    // Clay directly below the rim gives way first: weight (1 - s)^2 over the zone, of the same kind as the
    // rim.
    const auto weight_of = [&](int i) {
        const double s = (top - rings.centre_mm(i)) / length;
        return s < 1.0 ? (1.0 - s) * (1.0 - s) : 0.0;
    };
    int first = rings.count;
    double weighed_mm = 0.0;
    while (first > 0 && rings.is_hollow(first - 1) == hollow && weight_of(first - 1) > 0.0) {
        --first;
        weighed_mm += weight_of(first) * rings.height_mm[at(first)];
    }
    if (!(weighed_mm > 0.0)) return {};
    const double shortening = std::min(share * depth / weighed_mm, strain);
    for (int i = first; i <= last; ++i) {
        const double ro = rings.outer_mm[at(i)];
        const double ri = rings.inner_mm[at(i)];
        const double ratio = 1.0 / (1.0 - shortening * weight_of(i));  // of the area after to before
        const double gained = (ratio - 1.0) * (ro - ri) * (ro + ri);
        const double inner_square = ri * ri - 0.5 * gained;
        if (hollow && inner_square > kNarrowestHollowMm * kNarrowestHollowMm) {
            set_radii(rings, i, std::sqrt(ro * ro + 0.5 * gained), std::sqrt(inner_square), 2.0 * strain);
        } else {
            set_radii(rings, i, std::sqrt(ro * ro + gained), ri, 2.0 * strain);
        }
    }
    return {first, rings.count};
}

Changed smooth_face(Rings& rings, const Contact& contact, const Hand& hand, double share, double length,
                    std::vector<double>& average) noexcept {
    if (!(contact.deepest_mm > 0.0)) return {};
    const bool inside = hand.side == Side::kIn;
    std::vector<double>& face = inside ? rings.inner_mm : rings.outer_mm;
    const double reach = 1.5 * hand.radius_mm;
    // The average looks a few lengths beyond the window, so that its edge has no say.
    Rings::Range range = rings.rings_between(contact.height_mm - reach - 6.0 * length,
                                             contact.height_mm + reach + 6.0 * length);
    // Only clay of one kind, and of the kind at the hand.
    const bool hollow = rings.is_hollow(contact.nearest);
    if (inside && !hollow) return {};
    if (hollow) range.first = std::max(range.first, rings.first_hollow);
    if (!hollow) range.end = std::min(range.end, rings.first_hollow);
    if (range.size() < 3) return {};

    // The two-sided exponential average as two recursions, up and down: f <- (f + q face)/(1 + q), q =
    // h/length.
    const int n = range.size();
    double running = face[at(range.first)];
    for (int k = 0; k < n; ++k) {
        const double q = rings.height_mm[at(range.first + k)] / length;
        running = (running + q * face[at(range.first + k)]) / (1.0 + q);
        average[at(k)] = running;
    }
    for (int k = n - 1; k >= 0; --k) {
        const double q = rings.height_mm[at(range.first + k)] / length;
        running = (running + q * average[at(k)]) / (1.0 + q);
        average[at(k)] = running;
    }
    for (int k = 0; k < n; ++k) {
        const int i = range.first + k;
        const double s = (rings.centre_mm(i) - contact.height_mm) / reach;
        if (!(s * s < 1.0)) continue;
        const double window = (1.0 - s * s) * (1.0 - s * s);
        const double moved = face[at(i)] + share * window * (average[at(k)] - face[at(i)]);
        set_radii(rings, i, inside ? rings.outer_mm[at(i)] : moved, inside ? moved : rings.inner_mm[at(i)],
                  1.0);
    }
    return range;
}

Changed cut_face(Rings& rings, const Contact& contact, const Hand& hand, const std::vector<double>& depth,
                 double share, double& off) noexcept {
    const bool inside = hand.side == Side::kIn;
    const int first = contact.range.first;
    for (int k = 0; k < contact.range.size(); ++k) {
        const int i = first + k;
        const double ro = rings.outer_mm[at(i)];
        const double ri = rings.inner_mm[at(i)];
        if (inside && !(ri > 0.0)) continue;
        const double spare = ro - ri - std::min(ro - ri, kThinnestWallMm);
        double cut = std::min(share * depth[at(k)], spare);
        if (!inside) cut = std::min(cut, std::max(ro - kNarrowestMm, 0.0));
        if (!(cut > 0.0)) continue;
        const double outer = inside ? ro : ro - cut;
        const double inner = inside ? ri + cut : ri;
        // The ring keeps its height, to a grain.
        const double kept =
            on_grid(rings.volume_mm3[at(i)] * ((outer - inner) * (outer + inner)) / ((ro - ri) * (ro + ri)));
        if (!(kept > 0.0)) continue;
        off += rings.volume_mm3[at(i)] - kept;
        rings.volume_mm3[at(i)] = kept;
        rings.outer_mm[at(i)] = outer;
        rings.inner_mm[at(i)] = inner;
        rings.height_mm[at(i)] = ring_height_mm(kept, outer, inner);
    }
    return contact.range;
}

namespace {

// Cuts ring i so that `part` of it, from below, counts as one side. Returns the grains of the upper part.
double upper_grains(const Rings& rings, int i, double y) {
    const double part = (y - rings.bottom_mm(i)) / rings.height_mm[at(i)];
    const double volume = rings.volume_mm3[at(i)];
    return volume - on_grid(volume * std::clamp(part, 0.0, 1.0));
}

}  // namespace

void cut_above(Rings& rings, Ledger& ledger, double y) noexcept {
    if (rings.count == 0 || !(y < rings.top_mm())) return;
    const int i = rings.ring_at(std::max(y, 0.0));
    const double above = upper_grains(rings, i, y);
    double off = above;
    for (int above_i = i + 1; above_i < rings.count; ++above_i)
        off += rings.volume_mm3[at(above_i)];
    rings.volume_mm3[at(i)] -= above;
    const bool keeps_ring = rings.volume_mm3[at(i)] > 0.0;
    rings.remove(keeps_ring ? i + 1 : i, rings.count);
    ledger.trimmings_mm3 += off;
    rings.settle(keeps_ring ? i : std::max(i - 1, 0), rings.count);
    rings.find_floor();
}

void cut_below(Rings& rings, Ledger& ledger, double y) noexcept {
    if (rings.count == 0 || !(y > 0.0)) return;
    const int i = rings.ring_at(std::min(y, rings.top_mm()));
    const double above = upper_grains(rings, i, y);
    double off = rings.volume_mm3[at(i)] - above;
    for (int below = 0; below < i; ++below)
        off += rings.volume_mm3[at(below)];
    rings.volume_mm3[at(i)] = above;
    rings.remove(0, above > 0.0 ? i : i + 1);
    ledger.trimmings_mm3 += off;
    rings.settle(0, rings.count);
    rings.find_floor();
}

}  // namespace onggi::clay::studio
