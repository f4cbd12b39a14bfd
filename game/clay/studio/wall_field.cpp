#include "game/clay/studio/wall_field.h"

#include <algorithm>
#include <cmath>

namespace onggi::clay::studio {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

constexpr int kSlopeRings = 6;
constexpr double kSteepest = 3.0;

}  // namespace

double wall_slope(const Rings& rings, int i) noexcept {
    int low = i;
    int high = i;
    const bool hollow = rings.is_hollow(i);
    const int lowest = std::max(i - kSlopeRings, hollow ? rings.first_hollow : 0);
    const int highest = std::min(i + kSlopeRings, (hollow ? rings.count : rings.first_hollow) - 1);
    if (lowest < i) low = lowest;
    if (highest > i) high = highest;
    if (low == high || rings.is_hollow(low) != hollow || rings.is_hollow(high) != hollow) return 0.0;
    const double rise = rings.centre_mm(high) - rings.centre_mm(low);
    // Solid clay has its slope at the outer face; half of it is the middle between face and axis.
    const double run = 0.5 * ((rings.outer_mm[at(high)] + rings.inner_mm[at(high)]) -
                              (rings.outer_mm[at(low)] + rings.inner_mm[at(low)]));
    return std::clamp(run / rise, -kSteepest, kSteepest);
}

Changed move_wall(Rings& rings, const Contact& contact, const Hand& hand, double share,
                  const StudioParameters& parameters) noexcept {
    const int n = contact.range.size();
    double largest = 0.0;
    double weight_sum = 0.0;
    double moment = 0.0;
    for (int k = 0; k < n; ++k) {
        const double field = contact.field[at(k)];
        if (!(field > 0.0)) continue;
        largest = std::max(largest, field);
        const double weight = field * field * rings.height_mm[at(contact.range.first + k)];
        weight_sum += weight;
        moment += weight * contact.offset_mm[at(k)];
    }
    const double u = share * largest;
    if (!(u > 1e-9)) return {};
    const double middle = contact.height_mm + moment / weight_sum;
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
    const double sign = hand.side == Side::kIn ? 1.0 : -1.0;
    const double strain = parameters.largest_strain_rate * parameters.dt_s();
    for (int i = range.first; i < range.end; ++i) {
        const double ro = rings.outer_mm[at(i)];
        const double ri = rings.inner_mm[at(i)];
        if (!(ri > 0.0)) continue;
        const double y = rings.centre_mm(i);
        const double s = (y - middle) / length;
        const double rest = 1.0 - s * s;
        if (!(rest > 0.0)) continue;
        const double t = ro - ri;
        const double mean = 0.5 * (ro + ri);
        const double phi = tie_to_floor(y - floor, t) * wall_part(t, parameters.thin_wall_mm);
        // A neck that is all but closed has nowhere to go.
        const double room = sign > 0.0 ? 1.0 : std::min(0.5 * ri, 1.0);
        const double weaker = std::min(1.0, phi / phi_star) * room;
        const double d = sign * u * rest * rest * weaker;
        const double slope = wall_slope(rings, i);
        const double turned = sign * u * -4.0 * s * rest / length;
        const double rotation = slope * turned / (1.0 + slope * slope);
        const double hoop = d / mean;
        const double lengthened = -(1.0 - parameters.hoop_share_chi) * hoop - rotation;  // of h, a strain
        const double half = 0.5 * t * (1.0 - hoop - lengthened);
        set_radii(rings, i, mean + d + half, mean + d - half, strain);
    }
    return range;
}

}  // namespace onggi::clay::studio
