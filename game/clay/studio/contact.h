// Where a hand touches the clay and how deep, ring by ring; and how much of the wall stands behind it.
// Haptic thread; no allocation. Units: mm.
#pragma once

#include <cmath>
#include <vector>

#include "game/clay/studio/hand.h"
#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {

// The slope of a wall is taken over so many rings to either side.
constexpr int kSlopeRings = 6;

// What is worked out of every ring in reach of one hand. Entry k is of ring range.first + k. Not a state.
struct Contact {
    explicit Contact(int capacity);

    Rings::Range range;
    std::vector<double> offset_mm;      // y_i - y of the hand
    std::vector<double> half_width_mm;  // rc
    std::vector<double> depth_mm;       // d, of the face under the hand: what is felt
    std::vector<double> push_mm;  // x, of the mean circle against the mean hand, beyond the yield: what flows
    std::vector<double> residual_mm;  // w where the hand is; told only where has_rough_rows
    std::vector<double> field;        // the part of x that moves the wall as a whole
    std::vector<double> met;          // how much of a push the other hand pushes back, 0 to 1
    std::vector<double> held;         // whether it is there at all, 0 to 1
    // Of the wall field, entry k of its own range: y and R for the slope, how the two faces move.
    std::vector<float> place_mm;
    std::vector<float> mean_mm;
    std::vector<float> outer_step_mm;
    std::vector<float> inner_step_mm;

    double height_mm = 0.0;       // of the hand's centre, lifted off the floor for a hand inside
    double deepest_mm = -1e9;     // of depth_mm
    double far_depth_mm = -1e9;   // a hand inside: into the wall opposite
    double floor_depth_mm = 0.0;  // a hand inside: how far it pushes below the floor that is kept
    double rim_depth_mm = -1e9;   // a hand on top
    int nearest = 0;              // the ring nearest the hand's height
    bool has_rough_rows = false;

    [[nodiscard]] bool touches() const {
        return deepest_mm > 0.0 || rim_depth_mm > 0.0 || floor_depth_mm > 0.0;
    }
};

// Fills the contact of one hand. Precondition: rings.count > 0.
void find_contact(Contact& contact, const Rings& rings, const Hand& hand, const HandState& state,
                  const StudioParameters& parameters) noexcept;

// The residual w of a ring where the hand is, between the two sectors' middles.
double residual_at(const Rings& rings, int i, double turn) noexcept;

// The other hand, across a ring.
struct Backing {
    double held = 0.0;      // 1 where its surface touches the opposite face, 0 from 1 mm away
    double depth_mm = 0.0;  // how far its surface is beyond that face
};

// Of the hand whose middle is dy_mm below the ring, which has its opposite face there. An assist is a whole
// hand: what is within its reach is held, however its ball lies against a slope. No branch on a ring.
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

// The face of the clay that the hand is at.
inline const std::vector<double>& face_at(const Rings& rings, const Hand& hand) noexcept {
    return hand.side == Side::kIn ? rings.inner_mm : rings.outer_mm;
}

// How far from the axis the middle of a ball is that just touches the face on that side, kOut or kIn, with
// its middle at that height. Only hollow rings have an inner face. Less than 0 where the hollow is too
// narrow. work: a contact that is yet to be found.
double resting_distance_mm(const Rings& rings, Side side, double y_mm, double radius_mm,
                           Contact& work) noexcept;

// How firmly a wall stands on the floor at that height: 0 at the floor, 1 from 0.7 t above it.
inline double tie_to_floor(double above_floor_mm, double wall_mm) {
    const double tie = above_floor_mm / (0.7 * wall_mm);
    return tie < 0.0 ? 0.0 : tie > 1.0 ? 1.0 : tie;
}

// The part of a push that moves the wall rather than dents it, for a wall with nothing behind it:
// 1/(1 + (t/t0)^4). Indentation and hinge give way at the same load where t = t0.
inline double wall_part(double wall_mm, double thin_wall_mm) {
    const double q = wall_mm / thin_wall_mm;
    const double q2 = q * q;
    return 1.0 / (1.0 + q2 * q2);
}

}  // namespace onggi::clay::studio
