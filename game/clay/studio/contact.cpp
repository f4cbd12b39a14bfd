#include "game/clay/studio/contact.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/math/double4.h"
#include "engine/math/wide_vectors.h"

namespace onggi::clay::studio {
namespace {

double dot(const dvec2& a, const dvec2& b) {
    return a.x * b.x + a.y * b.y;
}

// The largest of n values and `least`. In lanes, because each comparison waits for the one before.
[[gnu::always_inline]] inline double largest_each(const double* values, int n, double least) {
    constexpr int kLanes = 8;
    Double4 low = Double4{} + least;
    Double4 high = low;
    int k = 0;
    for (; k + kLanes <= n; k += kLanes) {
        const Double4 a = load4(values + k);
        const Double4 b = load4(values + k + kLanes / 2);
        low = a > low ? a : low;
        high = b > high ? b : high;
    }
    low = high > low ? high : low;
    double largest = least;
    for (int lane = 0; lane < kLanes / 2; ++lane)
        largest = low[lane] > largest ? low[lane] : largest;
    for (; k < n; ++k)
        largest = values[k] > largest ? values[k] : largest;
    return largest;
}

constexpr int kPiece = 16;  // entries that are looked at together

[[gnu::always_inline]] inline bool has_positive(const double* piece) {
    Long4 above{};
    for (int k = 0; k < kPiece; k += 4)
        above |= load4(piece + k) > 0.0;
    return any(above);
}

// The entries [first, end) that hold all values above 0. Whole pieces without any are passed over first.
[[gnu::always_inline]] inline Rings::Range positive_part(const double* values, int n) {
    Rings::Range part{0, n};
    while (part.end >= kPiece && !has_positive(values + (part.end - kPiece)))
        part.end -= kPiece;
    while (part.end > 0 && !(values[part.end - 1] > 0.0))
        --part.end;
    while (part.first + kPiece <= part.end && !has_positive(values + part.first))
        part.first += kPiece;
    while (part.first < part.end && !(values[part.first] > 0.0))
        ++part.first;
    return part;
}

[[gnu::always_inline]] inline void surfaces_each(const double* __restrict__ face,
                                                 const double* __restrict__ offset,
                                                 double* __restrict__ surface, int n, double sign,
                                                 double radius) {
    for (int k = 0; k < n; ++k) {
        const double square = (radius - offset[k]) * (radius + offset[k]);
        surface[k] = sign * face[k] + std::sqrt(square > 0.0 ? square : 0.0);
    }
}

// Returns the largest of the surfaces and `least`.
ONGGI_WIDE_VECTORS double find_surfaces(const double* face, const double* offset, double* surface, int n,
                                        double sign, double radius, double least) {
    surfaces_each(face, offset, surface, n, sign, radius);
    return largest_each(surface, n, least);
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
      mean_mm(Rings::at(capacity + 2 * kSlopeRings), 0.0F) {}

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
    const double reach = sign * face[Rings::at(rings.ring_at(y))];
    if (range.size() <= 0) return sign * reach;
    double* const offset = work.offset_mm.data();
    double* const surface = work.depth_mm.data();
    rings.centres_from(y, range, offset);
    return sign * find_surfaces(face.data() + range.first, offset, surface, range.size(), sign, r1, reach);
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
    const float* const rough_mm = rings.rough_mm.data() + first;
    const double turn = turn_of(hand.in_clay);
    for (int k = 0; k < n; ++k) {
        const double w = rough_mm[k] > 0.0F ? residual_at(rings, first + k, turn) : 0.0;
        contact.residual_mm[Rings::at(k)] = w;
        contact.depth_mm[Rings::at(k)] += sign * w;
    }
}

// A hand as the contact of each ring depends on it.
struct Reach {
    double radius;
    double shaft;
    double sign;    // 1 outside, -1 inside
    double hand;    // r3, with that sign
    double steady;  // r3 - B.e of the mean hand, with that sign
    double ex;      // e, with that sign
    double ez;
    double yield;
};

[[gnu::always_inline]] inline void contact_each(const double* __restrict__ offset,
                                                const double* __restrict__ face, const float* __restrict__ cx,
                                                const float* __restrict__ cz, double* __restrict__ half,
                                                double* __restrict__ depth, double* __restrict__ push, int n,
                                                const Reach& with) {
    const auto [radius, shaft, sign, hand, steady, ex, ez, yield] = with;
    for (int k = 0; k < n; ++k) {
        const double square = (radius - offset[k]) * (radius + offset[k]);
        double rc = std::sqrt(square > 0.0 ? square : 0.0);
        const double stem = offset[k] > 0.0 ? shaft : 0.0;
        rc = rc > stem ? rc : stem;
        half[k] = rc;
        const double surface = sign * face[k] + rc;
        depth[k] = (surface - hand) + (static_cast<double>(cx[k]) * ex + static_cast<double>(cz[k]) * ez);
        double x = surface - steady;
        x = (x < kDeepestMm ? x : kDeepestMm) - yield;
        push[k] = x > 0.0 ? x : 0.0;
    }
}

[[gnu::always_inline]] inline bool is_any_rough(const float* rough, int n) {
    std::int32_t any = 0;
    for (int k = 0; k < n; ++k)
        any |= rough[k] > 0.0F ? 1 : 0;
    return any != 0;
}

ONGGI_WIDE_VECTORS void contact_all(Contact& contact, const Rings& rings, const double* face,
                                    const Reach& with) {
    const int first = contact.range.first;
    contact_each(contact.offset_mm.data(), face + first, rings.centre_x_mm.data() + first,
                 rings.centre_z_mm.data() + first, contact.half_width_mm.data(), contact.depth_mm.data(),
                 contact.push_mm.data(), contact.range.size(), with);
    contact.has_rough_rows = is_any_rough(rings.rough_mm.data() + first, contact.range.size());
}

// What the depths and the pushes of a contact hold.
ONGGI_WIDE_VECTORS void find_parts(Contact& contact) {
    const int n = contact.range.size();
    contact.deepest_mm = largest_each(contact.depth_mm.data(), n, -1e9);
    contact.touched = positive_part(contact.depth_mm.data(), n);
    contact.pushed = positive_part(contact.push_mm.data(), n);
}

}  // namespace

void find_contact(Contact& contact, const Rings& rings, const Hand& hand,
                  const StudioParameters& parameters) noexcept {
    contact.range = contact.touched = contact.pushed = {};
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

    rings.centres_from(y, contact.range, contact.offset_mm.data());

    // Outside, the clay reaches out to ro + c.e + w and the hand in to r3 - rc; inside, both signs turn.
    const double sign = inside ? -1.0 : 1.0;
    const double reach = sign * hand.distance_mm;
    contact_all(contact, rings, face_at(rings, hand).data(),
                {.radius = r1,
                 .shaft = shaft,
                 .sign = sign,
                 .hand = reach,
                 .steady = reach - sign * dot(hand.wobble_mm, hand.in_clay),
                 .ex = sign * hand.in_clay.x,
                 .ez = sign * hand.in_clay.y,
                 .yield = parameters.yield_depth_mm});

    if (contact.has_rough_rows) add_residuals(contact, rings, hand, sign);
    find_parts(contact);
    if (inside) {
        const int k = std::clamp(contact.nearest - first, 0, n - 1);
        contact.far_depth_mm =
            contact.half_width_mm[Rings::at(k)] - hand.distance_mm - rings.inner_mm[Rings::at(first + k)];
    }
}

}  // namespace onggi::clay::studio
