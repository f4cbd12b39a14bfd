#include "game/clay/studio/moves.h"

#include <algorithm>
#include <cmath>

#include "engine/math/wide_vectors.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {
namespace {

// The smallest inner radius that a move leaves to a hollow ring.
constexpr double kNarrowestHollowMm = 0.05;

// Smaller pushes count as 0.
constexpr double kLeastPushMm = 1e-9;

}  // namespace

Changed together(const Changed& a, const Changed& b) {
    if (a.size() <= 0) return b;
    if (b.size() <= 0) return a;
    return {std::min(a.first, b.first), std::max(a.end, b.end)};
}

bool set_radii(Rings& rings, int i, double outer, double inner, double largest_strain) noexcept {
    const double height = ring_height_mm(rings.volume_mm3[at(i)], outer, inner);
    if (!Gate(rings, largest_strain)
             .lets(rings.outer_mm[at(i)], rings.inner_mm[at(i)], rings.height_mm[at(i)], outer, inner,
                   height)) {
        return false;
    }
    rings.outer_mm[at(i)] = outer;
    rings.inner_mm[at(i)] = inner;
    rings.height_mm[at(i)] = height;
    return true;
}

namespace {

struct PushFractions {
    double fraction;
    double above_floor;  // height of the hand
    double strain;       // bound for one tick
    double k0;
    double per_thin_wall;
    double per_carried_wall;
    double none = 0.0;  // a value, not a literal: see Gate
};

// Branch-free, so that the loop vectorises over rings.
template <bool kInside, bool kBacked>
[[gnu::always_inline]] inline void push_each(double* __restrict__ outer, double* __restrict__ inner,
                                             double* __restrict__ height, double* __restrict__ field,
                                             const double* __restrict__ volume,
                                             const double* __restrict__ offset,
                                             const double* __restrict__ push, const double* __restrict__ met,
                                             const double* __restrict__ held, int n,
                                             const PushFractions& with, const Gate& gate) {
    const auto [fraction, above_floor, strain, k0, per_thin_wall, per_carried_wall, none] = with;
    const Gate let = gate;
    for (int k = 0; k < n; ++k) {
        const double ro = outer[k];
        const double ri = inner[k];
        const double before = height[k];
        const double wall = ro - ri;
        // A hand that nothing backs meets nothing: met and held are 0.
        const double lone = kBacked ? 1.0 - met[k] : 1.0;
        // tie = above/(0.7 t), clamped to 0 to 1, and phi = tie/(1 + q^4), with one division.
        const double q = wall * per_thin_wall;
        const double stiff = 1.0 + (q * q) * (q * q);
        const double tied = 0.7 * wall;
        double above = above_floor + offset[k];
        above = above < tied ? above : tied;
        above = above > none ? above : none;
        const double phi = above / (tied * stiff);
        const double tie = phi * stiff;
        const double wall_fraction = ri > 0.0 ? lone * phi : 0.0;
        field[k] = push[k] * wall_fraction;

        // Solid clay has no inner face: when pressed from outside, all displaced clay rises. An almost closed
        // neck has no room inside either.
        double room = 1.0;
        if constexpr (!kInside) room = 0.5 * ri < 1.0 ? 0.5 * ri : 1.0;
        // A wall held by both hands moves whole; a wall much thicker than the hands are wide moves as if held
        // by one.
        const double c = wall * per_carried_wall;
        const double crosses = kBacked ? k0 + (1.0 - k0) * held[k] / (1.0 + (c * c) * (c * c)) : k0;
        const double kappa = crosses * lone * (ri > 0.0 ? tie : 1.0) * room;
        const double face = kInside ? (ri > 1.0 ? ri : 1.0) : ro;
        // Bounded by how fast the clay can rise, and by the thinnest wall and narrowest ring.
        const double fastest = strain * wall * (ro + ri) / (2.0 * face * (1.0 - kappa));
        const double spare = wall - let.thinnest_mm;
        const double thick = spare > none ? spare : none;
        double delta = fraction * push[k] * (1.0 - wall_fraction);
        delta = delta < fastest ? delta : fastest;
        delta = delta < thick ? delta : thick;
        if constexpr (!kInside) {
            const double beyond = ro - let.narrowest_mm;
            const double narrow = beyond > none ? beyond : none;
            delta = delta < narrow ? delta : narrow;
        }

        // The touched face, and the square of the other one: kappa of the area crosses over.
        constexpr double kLeast = kNarrowestHollowMm * kNarrowestHollowMm;
        const double touched = kInside ? ri + delta : ro - delta;
        const double crossed = kappa * delta * (kInside ? touched + ri : touched + ro);
        const double square = kInside ? ro * ro + crossed : ri * ri - crossed;
        const double far = std::sqrt(square > kLeast ? square : kLeast);
        const double new_outer = kInside ? far : touched;
        const double new_inner = kInside ? touched : (ri > 0.0 ? far : 0.0);
        const double new_height = ring_height_mm(volume[k], new_outer, new_inner);
        // Without a push the ring keeps its bits.
        const bool moves = (delta > 0.0) & let.lets(ro, ri, before, new_outer, new_inner, new_height);
        outer[k] = moves ? new_outer : ro;
        inner[k] = moves ? new_inner : ri;
        height[k] = moves ? new_height : before;
    }
}

template <bool kInside, bool kBacked>
[[gnu::always_inline]] inline void push_as(Rings& rings, Contact& contact, const PushFractions& with,
                                           const Gate& gate) {
    const std::ptrdiff_t from = contact.pushed.first;
    const std::ptrdiff_t first = contact.range.first + from;
    push_each<kInside, kBacked>(rings.outer_mm.data() + first, rings.inner_mm.data() + first,
                                rings.height_mm.data() + first, contact.field.data() + from,
                                rings.volume_mm3.data() + first, contact.offset_mm.data() + from,
                                contact.push_mm.data() + from, contact.met.data() + from,
                                contact.held.data() + from, contact.pushed.size(), with, gate);
}

ONGGI_WIDE_VECTORS void push_all(Rings& rings, Contact& contact, bool inside, bool backed,
                                 const PushFractions& with, const Gate& gate) {
    if (inside && backed) return push_as<true, true>(rings, contact, with, gate);
    if (inside) return push_as<true, false>(rings, contact, with, gate);
    if (backed) return push_as<false, true>(rings, contact, with, gate);
    push_as<false, false>(rings, contact, with, gate);
}

[[gnu::always_inline]] inline void back_each(const double* __restrict__ far,
                                             const double* __restrict__ offset,
                                             const double* __restrict__ push, double* __restrict__ met,
                                             double* __restrict__ held, int n, const Hand& other,
                                             double apart, double yield) {
    const Hand backs = other;
    for (int k = 0; k < n; ++k) {
        const Backing backing = backing_of(backs, far[k], offset[k] + apart);
        double back = backing.depth_mm - yield;
        back = back > 0.0 ? back : 0.0;
        back = back < push[k] ? back : push[k];
        held[k] = backing.held;
        met[k] = back / (push[k] > kLeastPushMm ? push[k] : kLeastPushMm);
    }
}

// far: the opposite face of the contact's rings. apart: by how much the other hand's middle lies lower.
ONGGI_WIDE_VECTORS void back_all(Contact& contact, const Hand& other, const double* far, double apart,
                                 double yield) {
    const std::ptrdiff_t from = contact.pushed.first;
    back_each(far + from, contact.offset_mm.data() + from, contact.push_mm.data() + from,
              contact.met.data() + from, contact.held.data() + from, contact.pushed.size(), other, apart,
              yield);
}

}  // namespace

Changed push_rings(Rings& rings, Contact& contact, const Hand& hand, const Hand* other, double fraction,
                   const StudioParameters& parameters) noexcept {
    const bool inside = hand.side == Side::kIn;
    const int first = contact.range.first;
    const int n = contact.range.size();
    const Rings::Range pushed = contact.pushed;
    if (other != nullptr) {
        // The common part of both pushes squeezes the wall; the excess of one moves it.
        const double* const far = face_at(rings, *other).data() + first;
        back_all(contact, *other, far, contact.height_mm - other->position_mm.y, parameters.yield_depth_mm);
    }

    const PushFractions fractions{fraction,
                                  contact.height_mm - rings.floor_mm(),
                                  parameters.largest_strain_rate * parameters.dt_s(),
                                  parameters.wall_fraction_k0,
                                  1.0 / parameters.thin_wall_mm,
                                  0.5 / hand.radius_mm};
    push_all(rings, contact, inside, other != nullptr, fractions, Gate(rings, fractions.strain));
    if (inside) {
        for (int i = first; i < std::min(first + n, rings.first_hollow); ++i) {
            if (rings.is_hollow(i)) rings.first_hollow = i;
        }
    }
    return {first + pushed.first, first + pushed.end};
}

namespace {

// Depth of a press on a wall's rim, in wall thicknesses. Solid clay is pressed as a whole.
constexpr double kPressedWalls = 4.0;
constexpr double kLeastPressedMm = 12.0;

// Stress rises where the area is smaller than the rim's; bounded by this factor.
constexpr double kMostStress = 4.0;

// Flat clay resists: it yields fully up to the first bound and not at all from the second on. Flatness of
// solid clay: the ratio of radius to height of a cylinder of its volume.
constexpr double kSolidYields = 1.5;
constexpr double kSolidHolds = 2.4;
// Flatness of a wall: the ratio of its thickness to the height of the pressed part.
constexpr double kWallYields = 0.8;
constexpr double kWallHolds = 1.8;

double yielding(double flatness, double yields, double holds) {
    return std::clamp((holds - flatness) / (holds - yields), 0.0, 1.0);
}

}  // namespace

Changed press_rim(Rings& rings, const Contact& contact, double fraction,
                  const StudioParameters& parameters) noexcept {
    const double depth = std::min(contact.rim_depth_mm, kDeepestMm) - parameters.yield_depth_mm;
    if (!(depth > 0.0)) return {};
    const int last = rings.count - 1;
    const double top = rings.top_mm();
    const double length = std::max(kLeastPressedMm, kPressedWalls * rings.wall_mm(last));
    const double strain = parameters.largest_strain_rate * parameters.dt_s();
    const bool hollow = rings.is_hollow(last);
    const auto area_of = [&](int i) {
        return rings.wall_mm(i) * (rings.outer_mm[at(i)] + rings.inner_mm[at(i)]);
    };

    // A wall yields over a zone with a fading weight, solid clay as a whole. Clay that bears on a smaller
    // area yields faster, so that no rim grows wider than the clay below it.
    const double rim_area = area_of(last);
    const auto weight_of = [&](int i) {
        const double s = hollow ? (top - rings.centre_mm(i)) / length : 0.0;
        const double fading = std::max(1.0 - s * s, 0.0);
        const double stress = std::min(rim_area / area_of(i), kMostStress);
        return fading * fading * stress * stress;
    };
    int first = rings.count;
    double weighed_mm = 0.0;
    double pressed_mm3 = 0.0;
    while (first > 0 && rings.is_hollow(first - 1) == hollow) {
        const double weight = weight_of(first - 1);
        if (!(weight > 0.0)) break;
        --first;
        weighed_mm += weight * rings.height_mm[at(first)];
        pressed_mm3 += rings.volume_mm3[at(first)];
    }
    if (!(weighed_mm > 0.0)) return {};
    const double pressed_mm = top - rings.bottom_mm(first);
    const double area = pressed_mm3 / (kPi * pressed_mm);
    const double yields =
        hollow ? yielding(area / (rings.outer_mm[at(last)] + rings.inner_mm[at(last)]) / pressed_mm,
                          kWallYields, kWallHolds)
               : yielding(std::sqrt(area) / pressed_mm, kSolidYields, kSolidHolds);
    const double shortening = std::min(fraction * yields * depth / weighed_mm, strain);
    for (int i = first; i <= last; ++i) {
        const double ro = rings.outer_mm[at(i)];
        const double ri = rings.inner_mm[at(i)];
        const double shortened = std::min(shortening * weight_of(i), strain);
        const double gained = shortened / (1.0 - shortened) * area_of(i);
        const double thicker = 0.5 * gained / (ro + ri);  // to both sides, if there is an inner one
        if (hollow && ri - thicker > kNarrowestHollowMm)
            set_radii(rings, i, ro + thicker, ri - thicker, 2.0 * strain);
        else
            set_radii(rings, i, std::sqrt(ro * ro + gained), ri, 2.0 * strain);
    }
    return {first, rings.count};
}

Changed smooth_face(Rings& rings, const Contact& contact, const Hand& hand, double fraction, double length,
                    std::vector<double>& average) noexcept {
    if (!(contact.deepest_mm > 0.0)) return {};
    const bool inside = hand.side == Side::kIn;
    std::vector<double>& face = inside ? rings.inner_mm : rings.outer_mm;
    const double reach = 1.5 * hand.radius_mm;
    // The average extends a few lengths beyond the window, so that its ends have no effect.
    Rings::Range range = rings.rings_between(contact.height_mm - reach - 6.0 * length,
                                             contact.height_mm + reach + 6.0 * length);
    // Average only rings of the kind at the hand (solid or hollow).
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
        const double moved = face[at(i)] + fraction * window * (average[at(k)] - face[at(i)]);
        set_radii(rings, i, inside ? rings.outer_mm[at(i)] : moved, inside ? moved : rings.inner_mm[at(i)],
                  1.0);
    }
    return range;
}

Changed cut_face(Rings& rings, const Contact& contact, const Hand& hand, const std::vector<double>& depth,
                 double fraction, double& off) noexcept {
    const bool inside = hand.side == Side::kIn;
    const int first = contact.range.first;
    for (int k = 0; k < contact.range.size(); ++k) {
        const int i = first + k;
        const double ro = rings.outer_mm[at(i)];
        const double ri = rings.inner_mm[at(i)];
        if (inside && !(ri > 0.0)) continue;
        const double spare = ro - ri - std::min(ro - ri, kThinnestWallMm);
        double cut = std::min(fraction * depth[at(k)], spare);
        if (!inside) cut = std::min(cut, std::max(ro - kNarrowestMm, 0.0));
        if (!(cut > 0.0)) continue;
        const double outer = inside ? ro : ro - cut;
        const double inner = inside ? ri + cut : ri;
        // The ring keeps its height to within a grain.
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

// Splits ring i at height y. Returns the volume of its upper part, in whole grains.
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
