#include "game/clay/studio/contact.h"

#include <algorithm>
#include <cmath>

namespace onggi::clay::studio {
namespace {

double dot(const dvec2& a, const dvec2& b) {
    return a.x * b.x + a.y * b.y;
}

}  // namespace

Contact::Contact(int capacity)
    : offset_mm(Rings::at(capacity), 0.0),
      half_width_mm(Rings::at(capacity), 0.0),
      depth_mm(Rings::at(capacity), 0.0),
      push_mm(Rings::at(capacity), 0.0),
      residual_mm(Rings::at(capacity), 0.0),
      field(Rings::at(capacity), 0.0),
      met(Rings::at(capacity), 0.0),
      held(Rings::at(capacity), 0.0),
      place_mm(Rings::at(capacity + 2 * kSlopeRings), 0.0F),
      mean_mm(Rings::at(capacity + 2 * kSlopeRings), 0.0F),
      outer_step_mm(Rings::at(capacity), 0.0F),
      inner_step_mm(Rings::at(capacity), 0.0F) {}

double residual_at(const Rings& rings, int i, double turn) noexcept {
    const float* row = rings.row_of(i);
    const double place = turn * rings.sectors - 0.5;
    const int below = static_cast<int>(place + 1.0) - 1;
    const double part = place - below;
    const int mask = rings.sectors - 1;
    return (1.0 - part) * static_cast<double>(row[below & mask]) +
           part * static_cast<double>(row[(below + 1) & mask]);
}

double resting_distance_mm(const Rings& rings, Side side, double y, double r1, Contact& work) noexcept {
    const bool inside = side == Side::kIn;
    Rings::Range range = rings.rings_between(y - r1, y + r1);
    if (inside) range.first = std::max(range.first, rings.first_hollow);
    const double sign = inside ? -1.0 : 1.0;
    const std::vector<double>& face = inside ? rings.inner_mm : rings.outer_mm;
    double reach = sign * face[Rings::at(rings.ring_at(y))];
    if (range.size() <= 0) return sign * reach;
    double* const offset = work.offset_mm.data();
    rings.centres_from(y, range, offset);
    const double* const at = face.data() + range.first;
    for (int k = 0; k < range.size(); ++k) {
        const double square = (r1 - offset[k]) * (r1 + offset[k]);
        const double surface = sign * at[k] + std::sqrt(square > 0.0 ? square : 0.0);
        reach = surface > reach ? surface : reach;
    }
    return sign * reach;
}

namespace {

void find_rim_contact(Contact& contact, const Rings& rings, const Hand& hand) noexcept {
    const std::size_t last = Rings::at(rings.count - 1);
    const double aside =
        std::max({rings.inner_mm[last] - hand.distance_mm, hand.distance_mm - rings.outer_mm[last], 0.0});
    contact.nearest = rings.count - 1;
    contact.height_mm = hand.position_mm.y;
    if (aside >= hand.radius_mm) return;
    const double drop = std::sqrt((hand.radius_mm - aside) * (hand.radius_mm + aside));
    contact.rim_depth_mm = rings.top_mm() - (hand.position_mm.y - drop);
}

// Deepens rows of rings that are not round by their residuals under the hand. sign: 1 outside, -1 inside.
void add_residuals(Contact& contact, const Rings& rings, const Hand& hand, double sign) noexcept {
    const int first = contact.range.first;
    const int n = contact.range.size();
    bool rough = false;
    for (int k = 0; k < n; ++k)
        rough = rough || rings.rough_mm[Rings::at(first + k)] > 0.0F;
    contact.has_rough_rows = rough;
    if (!rough) return;
    const double turn = turn_of(hand.in_clay);
    for (int k = 0; k < n; ++k) {
        const bool is_rough = rings.rough_mm[Rings::at(first + k)] > 0.0F;
        const double w = is_rough ? residual_at(rings, first + k, turn) : 0.0;
        contact.residual_mm[Rings::at(k)] = w;
        contact.depth_mm[Rings::at(k)] += sign * w;
    }
}

}  // namespace

void find_contact(Contact& contact, const Rings& rings, const Hand& hand,
                  const StudioParameters& parameters) noexcept {
    contact.range = {};
    contact.deepest_mm = contact.far_depth_mm = contact.rim_depth_mm = -1e9;
    contact.floor_depth_mm = 0.0;
    contact.has_rough_rows = false;
    contact.height_mm = hand.position_mm.y;
    if (hand.side == Side::kFree) return;
    if (hand.side == Side::kTop) return find_rim_contact(contact, rings, hand);

    const bool inside = hand.side == Side::kIn;
    const double r1 = hand.radius_mm;
    double shaft = 0.0;
    double lowest = -1.0;
    if (inside) {
        lowest = std::min(parameters.floor_mm, rings.top_mm());
        contact.height_mm = std::max(hand.position_mm.y, lowest + r1);
        contact.floor_depth_mm = std::min(contact.height_mm - hand.position_mm.y, kDeepestMm);
        shaft = std::clamp(hand.shaft_mm, 0.0, r1);
    }
    const double y = contact.height_mm;
    contact.range = rings.rings_between(std::max(y - r1, lowest), shaft > 0.0 ? rings.top_mm() : y + r1);
    contact.nearest = rings.ring_at(y);
    const int first = contact.range.first;
    const int n = contact.range.size();
    if (n == 0) return;

    double* const offset = contact.offset_mm.data();
    double* const half = contact.half_width_mm.data();
    double* const depth = contact.depth_mm.data();
    double* const push = contact.push_mm.data();
    const double* const outer = rings.outer_mm.data() + first;
    const double* const inner = rings.inner_mm.data() + first;
    const float* const cx = rings.centre_x_mm.data() + first;
    const float* const cz = rings.centre_z_mm.data() + first;
    rings.centres_from(y, contact.range, offset);

    // Outside, the clay reaches out to ro + c.e + w and the hand in to r3 - rc; inside, both signs turn.
    const double sign = inside ? -1.0 : 1.0;
    const double reach = sign * hand.distance_mm;
    const double steady = reach - sign * dot(hand.wobble_mm, hand.in_clay);  // r3 - B.e, the mean hand
    const double ex = sign * hand.in_clay.x;
    const double ez = sign * hand.in_clay.y;
    const double dy = parameters.yield_depth_mm;
    const double* const face = inside ? inner : outer;
    for (int k = 0; k < n; ++k) {
        const double square = (r1 - offset[k]) * (r1 + offset[k]);
        double rc = std::sqrt(square > 0.0 ? square : 0.0);
        const double stem = offset[k] > 0.0 ? shaft : 0.0;
        rc = rc > stem ? rc : stem;
        half[k] = rc;
        const double surface = sign * face[k] + rc;
        depth[k] = (surface - reach) + (static_cast<double>(cx[k]) * ex + static_cast<double>(cz[k]) * ez);
        double x = surface - steady;
        x = (x < kDeepestMm ? x : kDeepestMm) - dy;
        push[k] = x > 0.0 ? x : 0.0;
    }

    add_residuals(contact, rings, hand, sign);

    double deepest = -1e9;
    for (int k = 0; k < n; ++k)
        deepest = depth[k] > deepest ? depth[k] : deepest;
    contact.deepest_mm = deepest;
    if (inside) {
        const int k = std::clamp(contact.nearest - first, 0, n - 1);
        contact.far_depth_mm = half[k] - hand.distance_mm - inner[k];
    }
}

}  // namespace onggi::clay::studio
