#include "game/clay/studio/wall_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/wide_vectors.h"

namespace onggi::clay::studio {
namespace {

constexpr double kSteepest = 3.0;

struct FieldFractions {
    float push;  // u, signed by the direction of the wall's motion
    float above_floor;
    float per_thin_wall;
    float per_phi;
    float per_length;
    float chi;
    float room_inside;  // 1 for a wall that moves outward
    // Values, not literals: see Gate.
    float none = 0.0F;
    float whole = 1.0F;
    float least_rise = 1e-6F;
    float steepest = 3.0F;
};

// Steps of the two faces of each ring. place and mean start kSlopeRings before the first ring.
[[gnu::always_inline]] inline void field_steps_each(
    const double* __restrict__ outer, const double* __restrict__ inner, const float* __restrict__ place,
    const float* __restrict__ mean, double* __restrict__ outer_step, double* __restrict__ inner_step, int n,
    const FieldFractions& with) {
    const auto [push, above_floor, per_thin_wall, per_phi, per_length, chi, room_inside, none, whole,
                least_rise, steepest] = with;
    for (int k = 0; k < n; ++k) {
        const auto ri = static_cast<float>(inner[k]);
        const auto t = static_cast<float>(outer[k] - inner[k]);
        const float y = place[k + kSlopeRings];
        const float s = y * per_length;
        float rest = 1.0F - s * s;
        rest = rest > none ? rest : none;
        // phi = tie/(1 + q^4) with tie = above/(0.7 t), at most 1, with one division.
        const float tied = 0.7F * t;
        float above = above_floor + y;
        above = above < tied ? above : tied;
        above = above > none ? above : none;
        const float q = t * per_thin_wall;
        float phi = above * per_phi / (tied * (1.0F + (q * q) * (q * q)));
        phi = phi < whole ? phi : whole;
        // An almost closed neck has no room to move; solid clay has no wall.
        float room = 0.5F * ri + room_inside;
        room = room < whole ? room : whole;
        const float here = ri > 0.0F ? push * rest : 0.0F;
        const float d = here * rest * phi * room;
        // T/(1 + T^2) with T = run/rise, clamped to +-3, with one division too.
        float rise = place[k + 2 * kSlopeRings] - place[k];
        rise = rise > least_rise ? rise : least_rise;
        const float furthest = steepest * rise;
        float run = mean[k + 2 * kSlopeRings] - mean[k];
        run = run < furthest ? run : furthest;
        run = run > -furthest ? run : -furthest;
        const float turn = run * rise / (rise * rise + run * run);
        const float rotation = turn * (here * -4.0F * s * per_length);
        const float hoop = d / mean[k + kSlopeRings];
        // The wall keeps its volume: t' = t (1 - hoop - ln h'/h), and ln h'/h is -(1 - chi) hoop - rotation.
        const float half = 0.5F * t * (rotation - chi * hoop);
        outer_step[k] = static_cast<double>(d + half);
        inner_step[k] = static_cast<double>(d - half);
    }
}

[[gnu::always_inline]] inline void take_steps_each(double* __restrict__ outer, double* __restrict__ inner,
                                                   double* __restrict__ height,
                                                   const double* __restrict__ volume,
                                                   const double* __restrict__ outer_step,
                                                   const double* __restrict__ inner_step, int n,
                                                   const Gate& gate) {
    const Gate let = gate;
    for (int k = 0; k < n; ++k) {
        const double ro = outer[k];
        const double ri = inner[k];
        const double before = height[k];
        const double new_outer = ro + outer_step[k];
        const double new_inner = ri + inner_step[k];
        const double new_height = ring_height_mm(volume[k], new_outer, new_inner);
        const bool moves = let.lets(ro, ri, before, new_outer, new_inner, new_height);
        outer[k] = moves ? new_outer : ro;
        inner[k] = moves ? new_inner : ri;
        height[k] = moves ? new_height : before;
    }
}

// y - y* and R of the rings of one block; base: the block's own, less y*.
[[gnu::always_inline]] inline void places_each(const double* __restrict__ rise,
                                               const double* __restrict__ height,
                                               const double* __restrict__ outer,
                                               const double* __restrict__ inner, float* __restrict__ place,
                                               float* __restrict__ mean, int n, double base) {
    for (int k = 0; k < n; ++k) {
        place[k] = static_cast<float>(base + (rise[k] + 0.5 * height[k]));
        mean[k] = static_cast<float>(0.5 * (outer[k] + inner[k]));
    }
}

ONGGI_WIDE_VECTORS void find_places(const Rings& rings, const Rings::Range& range, double middle,
                                    float* place, float* mean) {
    for (int i = range.first; i < range.end;) {
        const int block = i / kBlockRings;
        const int n = std::min(range.end, (block + 1) * kBlockRings) - i;
        places_each(rings.rise_mm.data() + i, rings.height_mm.data() + i, rings.outer_mm.data() + i,
                    rings.inner_mm.data() + i, place, mean, n, rings.base_mm[at(block)] - middle);
        place += n;
        mean += n;
        i += n;
    }
}

// In pieces whose steps stay near.
ONGGI_WIDE_VECTORS void move_each(Rings& rings, const Contact& contact, const Rings::Range& range,
                                  const FieldFractions& with, const Gate& gate) {
    constexpr int kPiece = 128;
    std::array<double, kPiece> outer_step;
    std::array<double, kPiece> inner_step;
    for (int from = 0; from < range.size(); from += kPiece) {
        const int n = std::min(kPiece, range.size() - from);
        double* const outer = rings.outer_mm.data() + (range.first + from);
        double* const inner = rings.inner_mm.data() + (range.first + from);
        field_steps_each(outer, inner, contact.place_mm.data() + from, contact.mean_mm.data() + from,
                         outer_step.data(), inner_step.data(), n, with);
        take_steps_each(outer, inner, rings.height_mm.data() + (range.first + from),
                        rings.volume_mm3.data() + (range.first + from), outer_step.data(), inner_step.data(),
                        n, gate);
    }
}

// The part of a push that moves the wall as a whole, over a contact's rings.
struct PushedWall {
    double largest;
    double weight;  // sum of (x phi)^2 h
    double moment;  // of it about the hand's height
};

// Branch-free: a ring that is not pushed adds 0.
[[gnu::always_inline]] inline PushedWall pushed_each(const double* __restrict__ field,
                                                     const double* __restrict__ height,
                                                     const double* __restrict__ offset, int n) {
    PushedWall sums{};
    for (int k = 0; k < n; ++k) {
        const double moved = field[k] > 0.0 ? field[k] : 0.0;
        const double weight = moved * moved * height[k];
        sums.weight += weight;
        sums.moment += weight * offset[k];
        sums.largest = sums.largest < moved ? moved : sums.largest;
    }
    return sums;
}

ONGGI_WIDE_VECTORS PushedWall pushed_in(const Rings& rings, const Contact& contact) {
    const std::ptrdiff_t from = contact.pushed.first;
    return pushed_each(contact.field.data() + from, rings.height_mm.data() + (contact.range.first + from),
                       contact.offset_mm.data() + from, contact.pushed.size());
}

// dR/dy between two rings. radii: the sum of both faces' radii.
[[gnu::always_inline]] inline double slope_between(double low_radii, double high_radii, double rise) {
    const double slope = 0.5 * (high_radii - low_radii) / rise;
    return slope < -kSteepest ? -kSteepest : slope > kSteepest ? kSteepest : slope;
}

[[gnu::always_inline]] inline void slopes_each(const double* __restrict__ outer,
                                               const double* __restrict__ inner,
                                               const double* __restrict__ centre, double* __restrict__ out,
                                               int n) {
    for (int k = 0; k < n; ++k) {
        const int low = k;
        const int high = k + 2 * kSlopeRings;
        const double slope =
            slope_between(outer[low] + inner[low], outer[high] + inner[high], centre[high] - centre[low]);
        const double one_kind = inner[low] < inner[high] ? inner[low] : inner[high];
        out[k] = one_kind > 0.0 ? slope : 0.0;
    }
}

ONGGI_WIDE_VECTORS void slopes_all(const Rings& rings, const Rings::Range& range, const double* centre,
                                   double* out) {
    const int low = range.first - kSlopeRings;
    slopes_each(rings.outer_mm.data() + low, rings.inner_mm.data() + low, centre + low, out, range.size());
}

}  // namespace

void slopes_between(const Rings& rings, Rings::Range range, const double* centre, double* out) noexcept {
    if (range.size() > 0) slopes_all(rings, range, centre, out);
}

double wall_slope(const Rings& rings, int i) noexcept {
    int low = i;
    int high = i;
    const bool hollow = rings.is_hollow(i);
    const int lowest = std::max(i - kSlopeRings, hollow ? rings.first_hollow : 0);
    const int highest = std::min(i + kSlopeRings, (hollow ? rings.count : rings.first_hollow) - 1);
    if (lowest < i) low = lowest;
    if (highest > i) high = highest;
    if (low == high || rings.is_hollow(low) != hollow || rings.is_hollow(high) != hollow) return 0.0;
    // The slope of solid clay is that of its outer face; the middle between face and axis has half that
    // slope.
    return slope_between(rings.outer_mm[at(low)] + rings.inner_mm[at(low)],
                         rings.outer_mm[at(high)] + rings.inner_mm[at(high)],
                         rings.centre_mm(high) - rings.centre_mm(low));
}

Changed move_wall(Rings& rings, Contact& contact, const Hand& hand, double fraction, double dt_s,
                  const StudioParameters& parameters) noexcept {
    const PushedWall pushed = pushed_in(rings, contact);
    const double u = fraction * pushed.largest;
    if (!(u > 1e-9)) return {};
    const double middle = contact.height_mm + pushed.moment / pushed.weight;
    const int star = std::max(rings.ring_at(middle), std::min(rings.first_hollow, rings.count - 1));
    const double wall = rings.wall_mm(star);
    const double length =
        std::max(parameters.field_length_beta *
                     std::sqrt(0.5 * (rings.outer_mm[at(star)] + rings.inner_mm[at(star)]) * wall),
                 hand.radius_mm);
    const double floor = rings.floor_mm();
    const double phi_star =
        std::max(tie_to_floor(middle - floor, wall) * wall_part(wall, parameters.thin_wall_mm), 1e-6);

    Changed range = rings.rings_between(middle - length, middle + length);
    range.first = std::max(range.first, rings.first_hollow);
    if (range.size() <= 0) return {};

    // y - y* and R of the field's rings, extended by the slope's reach at both ends; the end values are
    // repeated where the rings end.
    float* const place = contact.place_mm.data();
    float* const mean = contact.mean_mm.data();
    const Rings::Range seen{std::max(range.first - kSlopeRings, rings.first_hollow),
                            std::min(range.end + kSlopeRings, rings.count)};
    const int before = kSlopeRings - (range.first - seen.first);
    find_places(rings, seen, middle, place + before, mean + before);
    for (int k = 0; k < before; ++k) {
        place[k] = place[before];
        mean[k] = mean[before];
    }
    const int filled = before + seen.size();
    const int needed = range.size() + 2 * kSlopeRings;
    for (int k = filled; k < needed; ++k) {
        place[k] = place[filled - 1];
        mean[k] = mean[filled - 1];
    }

    const bool inside = hand.side == Side::kIn;
    const FieldFractions fractions{.push = static_cast<float>(inside ? u : -u),
                                   .above_floor = static_cast<float>(middle - floor),
                                   .per_thin_wall = static_cast<float>(1.0 / parameters.thin_wall_mm),
                                   .per_phi = static_cast<float>(1.0 / phi_star),
                                   .per_length = static_cast<float>(1.0 / length),
                                   .chi = static_cast<float>(parameters.hoop_fraction_chi),
                                   .room_inside = inside ? 1.0F : 0.0F};
    move_each(rings, contact, range, fractions, Gate(rings, parameters.largest_strain_rate * dt_s));
    return range;
}

}  // namespace onggi::clay::studio
