#include "game/clay/studio/hand.h"

#include <algorithm>
#include <cmath>

#include "game/clay/exact_math.h"
#include "game/clay/studio/strength.h"

namespace onggi::clay::studio {
namespace {

constexpr double kOnAxisMm = 1e-9;
constexpr double kRememberedTurns = 1.5;

// A hand this near the axis opens solid clay.
constexpr double kOpensWithinTop = 1.0 / 3.0;
constexpr double kOpensWithinHand = 0.75;

// A hand at a steady speed is ahead of its filtered height by its way in kClimbTimeS; below kTremorMm this
// counts as no climb.
constexpr double kClimbTimeS = 0.15;
constexpr double kTremorMm = 0.3;
constexpr double kClimbMm = 1.0;

}  // namespace

double opening_radius_mm(const Rings& rings, double r1) noexcept {
    const std::size_t last = Rings::at(rings.count - 1);
    const double outer = rings.outer_mm[last];
    const double inner = rings.inner_mm[last];
    const double middle = 0.5 * (outer + inner);
    return std::min(std::max({inner, kOpensWithinHand * r1, kOpensWithinTop * outer}), middle);
}

Side next_side(Side side, const Rings& rings, double y, double distance, double r1) noexcept {
    const double top = rings.top_mm();
    if (y - r1 >= top) return Side::kFree;
    const int last = rings.count - 1;
    const double outer = rings.outer_mm[Rings::at(last)];
    const double inner = rings.inner_mm[Rings::at(last)];
    switch (side) {
        case Side::kFree:
            if (y > top) {
                if (distance > outer) return Side::kOut;
                if (distance < opening_radius_mm(rings, r1)) return Side::kIn;
                return Side::kTop;
            } else {
                const int i = rings.ring_at(y);
                const double middle = 0.5 * (rings.outer_mm[Rings::at(i)] + rings.inner_mm[Rings::at(i)]);
                return distance > middle ? Side::kOut : Side::kIn;
            }
        case Side::kTop:
            if (distance > outer + 0.2 * r1) return Side::kOut;
            if (distance < inner - 0.2 * r1) return Side::kIn;
            return Side::kTop;
        case Side::kOut:
        case Side::kIn:
            if (y > top + 0.3 * r1 && distance > opening_radius_mm(rings, r1) && distance < outer)
                return Side::kTop;
            return side;
    }
    return side;
}

namespace {

Side requested_side(WantedSide request, Side side, const Rings& rings, double y, double distance) {
    const std::size_t at = Rings::at(rings.ring_at(y));
    const double outer = rings.outer_mm[at];
    const double inner = rings.inner_mm[at];
    switch (request) {
        case WantedSide::kNone:
            break;
        case WantedSide::kOut:
            if (distance > inner) return Side::kOut;
            break;
        case WantedSide::kIn:
            if (distance < (inner > 0.0 ? outer : 0.5 * outer)) return Side::kIn;
            break;
        case WantedSide::kTop:
            if (y > rings.top_mm() && distance < outer) return Side::kTop;
            break;
    }
    return side;
}

}  // namespace

dvec2 into_clay(const dvec2& e, const Rotation& heading) noexcept {
    return {heading.cosine * e.x - heading.sine * e.y, heading.sine * e.x + heading.cosine * e.y};
}

double turn_of(const dvec2& in_clay) noexcept {
    constexpr double kTurnsPerRad = 0.5 / kPi;
    const double turn = angle_of(in_clay.x, -in_clay.y) * kTurnsPerRad;
    return turn < 1.0 ? turn : 0.0;
}

Hand follow_hand(HandState& state, const Rings& rings, const StudioHand& given, const Rotation& heading,
                 double dt_s) noexcept {
    Hand hand;
    hand.position_mm = given.position_mm;
    hand.radius_mm = std::clamp(given.radius_mm, 2.0, 40.0);
    hand.shaft_mm = std::isfinite(given.shaft_mm) ? given.shaft_mm : 0.0;
    hand.tool = given.tool;
    const double x = given.position_mm.x;
    const double z = given.position_mm.z;
    const double distance = std::sqrt(x * x + z * z);
    const bool was_outside = state.side == Side::kOut;
    const bool was_free = state.side == Side::kFree;
    state.side = next_side(state.side, rings, given.position_mm.y, distance, hand.radius_mm);
    if (was_free && state.side != Side::kFree)
        state.side = requested_side(given.side, state.side, rings, given.position_mm.y, distance);
    hand.side = state.side;
    hand.distance_mm = distance;
    if (was_outside && state.side == Side::kOut && x * state.direction.x + z * state.direction.y < 0.0) {
        // The hand was pushed across the axis from outside: it keeps its direction, and its distance turns
        // negative.
        hand.distance_mm = x * state.direction.x + z * state.direction.y;
    } else if (distance > kOnAxisMm) {
        state.direction = {x / distance, z / distance};
    }
    hand.direction = state.direction;
    hand.in_clay = into_clay(state.direction, heading);
    if (!state.has_slow_height) state.slow_height_mm = given.position_mm.y;
    state.has_slow_height = true;
    state.slow_height_mm +=
        relaxed_fraction(dt_s / kClimbTimeS) * (given.position_mm.y - state.slow_height_mm);
    return hand;
}

double climb_fraction(const HandState& state, double y) noexcept {
    return std::clamp((y - state.slow_height_mm - kTremorMm) / (kClimbMm - kTremorMm), 0.0, 1.0);
}

void follow_wobble(HandState& state, const Hand& hand, double turned_rad) noexcept {
    if (!state.has_mean) {
        state.has_mean = true;
        state.mean_distance_mm = hand.distance_mm;
        state.wobble_mm = {0.0, 0.0};
        return;
    }
    const double fraction = relaxed_fraction(turned_rad / (kTurn * kRememberedTurns));
    state.mean_distance_mm += fraction * (hand.distance_mm - state.mean_distance_mm);
    const double off = 2.0 * (hand.distance_mm - state.mean_distance_mm);
    state.wobble_mm += (hand.in_clay * off - state.wobble_mm) * fraction;
    const double size2 = state.wobble_mm.x * state.wobble_mm.x + state.wobble_mm.y * state.wobble_mm.y;
    if (size2 > kLargestWobbleMm * kLargestWobbleMm) state.wobble_mm *= kLargestWobbleMm / std::sqrt(size2);
}

void forget_wobble(HandState& state) noexcept {
    state.has_mean = false;
    state.wobble_mm = {0.0, 0.0};
}

}  // namespace onggi::clay::studio
