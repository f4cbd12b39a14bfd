#include "game/clay/studio/assist.h"

#include <algorithm>

namespace onggi::clay::studio {
namespace {

// The most that an assist squeezes a wall at a time: a fraction of it, and no more than so much.
constexpr double kSqueezedFraction = 0.25;
constexpr double kSqueezedMm = 3.0;

}  // namespace

bool has_assist(const StudioInput& input, const Rings& rings, const Hand& hand) noexcept {
    if (input.has_second || !(input.assist_gap_mm > 0.0) || rings.first_hollow >= rings.count) return false;
    return hand.side == Side::kIn || (hand.side == Side::kOut && hand.position_mm.y > rings.floor_mm());
}

Hand assist_of(const Hand& hand, const HandState& state, const Contact& contact, Contact& work,
               const Rings& rings, double least_gap_mm, const StudioParameters& parameters) noexcept {
    Hand second = hand;
    second.is_assist = true;
    second.tool = StudioTool::kHand;
    const bool outside = hand.side == Side::kIn;  // the assist
    const double r1 = hand.radius_mm;
    second.side = outside ? Side::kOut : Side::kIn;
    second.position_mm.y = contact.height_mm;
    if (!outside)
        second.position_mm.y =
            std::max(contact.height_mm, std::max(parameters.floor_mm, rings.floor_mm()) + r1);
    const double lifted = second.position_mm.y - contact.height_mm;
    const double yield = parameters.yield_depth_mm;
    const double pressed = contact.deepest_mm >= yield ? 1.0 : std::max(contact.deepest_mm, 0.0) / yield;
    const double touch = pressed * std::max(1.0 - lifted / r1, 0.0);
    const double wall = rings.wall_mm(contact.nearest);
    const double squeeze =
        climb_fraction(state, hand.position_mm.y) * std::min(kSqueezedFraction * wall, kSqueezedMm);
    const double apart = 2.0 * r1 + std::max(least_gap_mm, wall - squeeze);
    const double resting = resting_distance_mm(rings, second.side, second.position_mm.y, r1, work);
    const double steady =
        hand.distance_mm - (state.wobble_mm.x * hand.in_clay.x + state.wobble_mm.y * hand.in_clay.y);
    const double least = touch * yield;
    const double most = std::max(touch * squeeze, least);
    second.distance_mm = outside ? std::clamp(steady + apart, resting - most, resting - least)
                                 : std::clamp(steady - apart, resting + least, resting + most);
    second.position_mm.x = second.direction.x * second.distance_mm;
    second.position_mm.z = second.direction.y * second.distance_mm;
    return second;
}

}  // namespace onggi::clay::studio
