// Contact of a hand with the clay, ring by ring: where, how deep, and how firmly the wall is backed. Haptic
// thread; no allocation. Units: mm.
#pragma once

#include <cmath>
#include <vector>

#include "game/clay/studio/hand.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// A wall's slope is taken over this many rings to either side.
constexpr int kSlopeRings = 6;

// Contact values of every ring in reach of one hand. Entry k is ring range.first + k. Not state.
struct Contact {
    explicit Contact(int capacity);

    Rings::Range range;
    Rings::Range touched;               // the entries that hold every depth above 0
    Rings::Range pushed;                // the entries that hold every push above 0
    std::vector<double> offset_mm;      // y_i - y of the hand
    std::vector<double> half_width_mm;  // rc
    std::vector<double> depth_mm;       // d, depth of the hand in the face: the felt depth
    std::vector<double> push_mm;      // x, mean hand against mean circle, beyond the yield: the flowing depth
    std::vector<double> residual_mm;  // w at the hand; set only if has_rough_rows
    // For the entries of `pushed`; the last two only where another hand is on the opposite face:
    std::vector<double> field;  // the part of x that moves the wall as a whole
    std::vector<double> met;    // fraction of the push that the other hand opposes, 0 to 1
    std::vector<double> held;   // contact of the other hand with the opposite face, 0 to 1
    // For the wall field; entry k of the field's own range: y and R for the slope.
    std::vector<float> place_mm;
    std::vector<float> mean_mm;

    double height_mm = 0.0;       // height of the hand's centre; lifted off the floor for a hand inside
    double deepest_mm = -1e9;     // maximum of depth_mm
    double far_depth_mm = -1e9;   // hand inside: depth in the wall opposite
    double floor_depth_mm = 0.0;  // hand inside: depth below the floor that is kept
    double rim_depth_mm = -1e9;   // hand on top: depth in the rim
    int nearest = 0;              // the ring nearest the hand's height
    bool has_rough_rows = false;

    [[nodiscard]] bool touches() const {
        return deepest_mm > 0.0 || rim_depth_mm > 0.0 || floor_depth_mm > 0.0;
    }
};

// Fills the contact of one hand. Precondition: rings.count > 0.
void find_contact(Contact& contact, const Rings& rings, const Hand& hand,
                  const StudioParameters& parameters) noexcept;

// The residual w of a ring at the hand, interpolated between two sector middles.
double residual_at(const Rings& rings, int i, double turn) noexcept;

// Support of a ring by the other hand.
struct Backing {
    double held = 0.0;      // 1 where its surface touches the opposite face, 0 from 1 mm away
    double depth_mm = 0.0;  // depth of its surface beyond that face
};

// Backing by a hand whose middle is dy_mm below the ring; face_mm is the opposite face of the ring. An assist
// counts as a whole hand: all rings in its reach are held, whatever the slope there. Branch-free per ring.
inline Backing backing_of(const Hand& other, double face_mm, double dy_mm) noexcept {
    const double square = (other.radius_mm - dy_mm) * (other.radius_mm + dy_mm);
    const double reaches = square > 0.0 ? 1.0 : 0.0;
    const double half_width = std::sqrt(square > 0.0 ? square : 0.0);
    const double beyond = other.side == Side::kIn ? other.distance_mm - face_mm : face_mm - other.distance_mm;
    const double depth = beyond + half_width;
    double near = other.is_assist ? 1.0 : 1.0 + depth;
    near = near > 0.0 ? near : 0.0;
    near = near < 1.0 ? near : 1.0;
    return {.held = reaches * near, .depth_mm = reaches * (depth > 0.0 ? depth : 0.0)};
}

// The face of the clay on the hand's side.
inline const std::vector<double>& face_at(const Rings& rings, const Hand& hand) noexcept {
    return hand.side == Side::kIn ? rings.inner_mm : rings.outer_mm;
}

// Distance from the axis of the middle of a ball at height y_mm that just touches the face on that side, kOut
// or kIn. Only hollow rings have an inner face. Negative where the hollow is too narrow. work: scratch
// contact, not yet computed for this tick.
double resting_distance_mm(const Rings& rings, Side side, double y_mm, double radius_mm,
                           Contact& work) noexcept;

// How firmly a wall at that height is tied to the floor: 0 at the floor, 1 from 0.7 t above it.
inline double tie_to_floor(double above_floor_mm, double wall_mm) {
    const double tie = above_floor_mm / (0.7 * wall_mm);
    return tie < 0.0 ? 0.0 : tie > 1.0 ? 1.0 : tie;
}

// The fraction of a push that moves the wall instead of denting it, for a wall without support: 1/(1 +
// (t/t0)^4). Indentation and hinge yield at the same load where t = t0.
inline double wall_part(double wall_mm, double thin_wall_mm) {
    const double q = wall_mm / thin_wall_mm;
    const double q2 = q * q;
    return 1.0 / (1.0 + q2 * q2);
}

}  // namespace onggi::clay::studio
