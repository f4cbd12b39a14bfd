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

Side requested_side(Side request, Side side, const Rings& rings, double y, double distance) {
    const std::size_t at = Rings::at(rings.ring_at(y));
    const double outer = rings.outer_mm[at];
    const double inner = rings.inner_mm[at];
    switch (request) {
        case Side::kFree:
            break;
        case Side::kOut:
            if (distance > inner) return Side::kOut;
            break;
        case Side::kIn:
            if (distance < (inner > 0.0 ? outer : 0.5 * outer)) return Side::kIn;
            break;
        case Side::kTop:
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

namespace {

// Precondition: position, radius, shaft and tool are those of this tick.
void settle_hand(Hand& hand, const Rings& rings, Side wanted, const Rotation& heading, double dt_s) {
    hand.radius_mm = std::clamp(hand.radius_mm, tool::kMinToolRadiusMm, tool::kMaxToolRadiusMm);
    hand.is_assist = hand.drinks = false;
    const double x = hand.position_mm.x;
    const double y = hand.position_mm.y;
    const double z = hand.position_mm.z;
    const double distance = std::sqrt(x * x + z * z);
    const bool was_outside = hand.side == Side::kOut;
    const bool was_free = hand.side == Side::kFree;
    hand.side = next_side(hand.side, rings, y, distance, hand.radius_mm);
    if (was_free && hand.side != Side::kFree)
        hand.side = requested_side(wanted, hand.side, rings, y, distance);
    hand.distance_mm = distance;
    if (was_outside && hand.side == Side::kOut && x * hand.direction.x + z * hand.direction.y < 0.0) {
        // The hand was pushed across the axis from outside: it keeps its direction, and its distance turns
        // negative.
        hand.distance_mm = x * hand.direction.x + z * hand.direction.y;
    } else if (distance > kOnAxisMm) {
        hand.direction = {x / distance, z / distance};
    }
    hand.in_clay = into_clay(hand.direction, heading);
    if (!hand.has_slow_height) hand.slow_height_mm = y;
    hand.has_slow_height = true;
    hand.slow_height_mm += relaxed_fraction(dt_s / kClimbTimeS) * (y - hand.slow_height_mm);
}

}  // namespace

void follow_hand(Hand& hand, const Rings& rings, const tool::ToolState& tool, const Rotation& heading,
                 double dt_s) noexcept {
    hand.position_mm = tool.position_mm;
    hand.radius_mm = tool.radius_mm;
    hand.shaft_mm = std::isfinite(tool.shaft_mm) ? tool.shaft_mm : 0.0;
    hand.tool = tool.tool;
    settle_hand(hand, rings, tool.side, heading, dt_s);
}

void follow_hand(Hand& hand, const Rings& rings, const tool::SecondHand& second, const Rotation& heading,
                 double dt_s) noexcept {
    hand.position_mm = second.position_mm;
    hand.radius_mm = second.radius_mm;
    hand.shaft_mm = 0.0;
    hand.tool = second.tool;
    settle_hand(hand, rings, Side::kFree, heading, dt_s);
}

double climb_fraction(const Hand& hand) noexcept {
    return std::clamp((hand.position_mm.y - hand.slow_height_mm - kTremorMm) / (kClimbMm - kTremorMm), 0.0,
                      1.0);
}

void follow_wobble(Hand& hand, double turned_rad) noexcept {
    if (!hand.has_mean) {
        hand.has_mean = true;
        hand.mean_distance_mm = hand.distance_mm;
        hand.wobble_mm = {0.0, 0.0};
        return;
    }
    const double fraction = relaxed_fraction(turned_rad / (kTurn * kRememberedTurns));
    hand.mean_distance_mm += fraction * (hand.distance_mm - hand.mean_distance_mm);
    const double off = 2.0 * (hand.distance_mm - hand.mean_distance_mm);
    hand.wobble_mm += (hand.in_clay * off - hand.wobble_mm) * fraction;
    const double size2 = hand.wobble_mm.x * hand.wobble_mm.x + hand.wobble_mm.y * hand.wobble_mm.y;
    if (size2 > kLargestWobbleMm * kLargestWobbleMm) hand.wobble_mm *= kLargestWobbleMm / std::sqrt(size2);
}

void forget_wobble(Hand& hand) noexcept {
    hand.has_mean = false;
    hand.wobble_mm = {0.0, 0.0};
}

}  // namespace onggi::clay::studio
