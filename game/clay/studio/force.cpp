#include "game/clay/studio/force.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/math/wide_vectors.h"
#include "game/clay/studio/load.h"

namespace onggi::clay::studio {
namespace {

// Friction grows with the sliding speed up to this, then saturates.
constexpr double kStickSpeedMmS = 5.0;

double softened_strength_n_mm2(const Rings& rings, int i) {
    const auto su = static_cast<double>(rings.strength_kpa[Rings::at(i)]);
    const double beyond = std::clamp(
        (static_cast<double>(rings.load_index[Rings::at(i)]) - kSoftensAtLoad) / (1.0 - kSoftensAtLoad), 0.0,
        1.0);
    return su * (1.0 - 0.5 * beyond) / kKpaPerNMm2;
}

double top_of(const Rings& rings, int i) {
    return rings.bottom_mm(i) + rings.height_mm[Rings::at(i)];
}

double length_of(const dvec3& v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// What a hand's touched rings add up to: their normals weighted by depth, outward and up, and their number.
struct Touched {
    double outward;
    double up;
    std::int64_t count;
};

// Branch-free: a ring that is not touched adds 0.
[[gnu::always_inline]] inline Touched touched_each(const double* __restrict__ depth,
                                                   const double* __restrict__ half_width,
                                                   const double* __restrict__ offset, int n) {
    Touched sums{};
    for (int k = 0; k < n; ++k) {
        const double d = depth[k] > 0.0 ? depth[k] : 0.0;
        sums.outward += d * half_width[k];
        sums.up -= d * offset[k];
    }
    for (int k = 0; k < n; ++k)
        sums.count += depth[k] > 0.0 ? 1 : 0;
    return sums;
}

ONGGI_WIDE_VECTORS Touched touched_in(const Contact& contact) {
    const std::ptrdiff_t from = contact.touched.first;
    return touched_each(contact.depth_mm.data() + from, contact.half_width_mm.data() + from,
                        contact.offset_mm.data() + from, contact.touched.size());
}

// Mean direction of the touched normals in (outward, up).
dvec2 pushed_direction(const Touched& touched, const Contact& contact, const Hand& hand) {
    const double size = std::sqrt(touched.outward * touched.outward + touched.up * touched.up);
    if (!(size > 0.0)) return {0.0, 0.0};
    const double outward = touched.outward / size;
    const double up = touched.up / size;
    if (hand.side == Side::kIn) {
        // Near the axis, clay on both sides pushes the hand in opposite directions.
        const double opposite = std::clamp(contact.far_depth_mm / contact.deepest_mm, 0.0, 1.0);
        return {-outward * (1.0 - opposite), up};
    }
    return {outward, up};
}

}  // namespace

Feel feel(const Rings& rings, const Contact& contact, const Hand& hand, const dvec3& velocity,
          double wheel_speed, double film, double supported, const StudioParameters& parameters) noexcept {
    Feel felt;
    if (!contact.touches()) return felt;
    const int i = contact.nearest;
    const std::size_t at = Rings::at(i);
    const double su = softened_strength_n_mm2(rings, i);
    const double r1 = hand.radius_mm;
    const double bearing = parameters.bearing_factor_nc * su * kPi * 2.0;
    const dvec2 e = hand.direction;
    felt.forces.contact_low_mm = rings.bottom_mm(i);
    felt.forces.contact_high_mm = top_of(rings, i);

    dvec3 normal{0.0};
    double lever_mm = 0.0;
    if (contact.deepest_mm > 0.0) {
        const double depth = std::min(contact.deepest_mm, kDeepestMm);
        const double radius = 1.0 / (1.0 / r1 + 1.0 / rings.outer_mm[at]);  // R*
        double size = bearing * radius * depth;
        felt.forces.local_stiffness_n_per_mm = bearing * radius;
        if (rings.is_hollow(i)) {
            const double wall = rings.wall_mm(i);
            const double alone = (1.0 - supported) * tie_to_floor(contact.height_mm - rings.floor_mm(), wall);
            const double hinge = kTurn * su * wall * wall;
            size = size * hinge / (hinge + alone * size);
        }
        const Touched touched = touched_in(contact);
        const dvec2 direction = pushed_direction(touched, contact, hand);
        normal += dvec3(e.x * direction.x, direction.y, e.y * direction.x) * size;
        lever_mm = hand.side == Side::kIn ? std::max(rings.inner_mm[at], 1.0) : rings.outer_mm[at];
        felt.forces.contacts = static_cast<int>(touched.count);
        // The outermost rings of a grip's print may have no depth.
        int first = contact.touched.first;
        int last = contact.touched.end - 1;
        while (first < last && !(contact.depth_mm[Rings::at(first)] > 0.0))
            ++first;
        while (first < last && !(contact.depth_mm[Rings::at(last)] > 0.0))
            --last;
        felt.forces.contact_low_mm = rings.bottom_mm(contact.range.first + first);
        felt.forces.contact_high_mm = top_of(rings, contact.range.first + last);
    }
    if (contact.floor_depth_mm > 0.0) {
        normal.y += bearing * r1 * contact.floor_depth_mm;
        felt.forces.local_stiffness_n_per_mm = std::max(felt.forces.local_stiffness_n_per_mm, bearing * r1);
        lever_mm = std::max(lever_mm, std::fabs(hand.distance_mm));
        felt.forces.contacts = std::max(felt.forces.contacts, 1);
    }
    if (contact.rim_depth_mm > 0.0) {
        const double depth = std::min(contact.rim_depth_mm, kDeepestMm);
        const double chord = 2.0 * std::sqrt(2.0 * r1 * depth);
        // A rim narrower than the tool's print bears on its own width only.
        const double area = std::min(kPi * 2.0 * r1 * depth, rings.wall_mm(i) * chord);
        normal.y += parameters.bearing_factor_nc * su * area;
        felt.forces.local_stiffness_n_per_mm = std::max(felt.forces.local_stiffness_n_per_mm, bearing * r1);
        lever_mm = std::max(std::fabs(hand.distance_mm), 1.0);
        felt.forces.contacts = 1;
    }

    double size = length_of(normal);
    if (size > parameters.largest_force_n) {
        normal *= parameters.largest_force_n / size;
        size = parameters.largest_force_n;
    }
    felt.forces.stiffness_n = normal;
    felt.forces.viscosity_n = dvec3(0.0) - velocity * parameters.viscosity_c2_n_s_per_mm;  // Eq. (6)

    // The surface moves along (e.z, 0, -e.x). Friction depends on its speed relative to the hand.
    const dvec3 along{e.y, 0.0, -e.x};
    const dvec3 past = along * (wheel_speed * lever_mm - (velocity.x * along.x + velocity.z * along.z)) -
                       dvec3(0.0, velocity.y, 0.0);
    const double speed = length_of(past);
    const double mu = parameters.friction_dry + film * (parameters.friction_wet - parameters.friction_dry);
    felt.forces.friction_n = past * (mu * size / (speed + kStickSpeedMmS));
    felt.wheel_load_n_mm =
        std::max(0.0, (felt.forces.friction_n.x * along.x + felt.forces.friction_n.z * along.z) * lever_mm);
    return felt;
}

}  // namespace onggi::clay::studio
