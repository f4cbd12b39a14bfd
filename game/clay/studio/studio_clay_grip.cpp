// The guided hand's part of the tick: grip_work.h on this clay, and what is felt and heard of it.
#include <algorithm>
#include <cmath>

#include "game/clay/exact_math.h"
#include "game/clay/studio/force.h"
#include "game/clay/studio/roundness.h"
#include "game/clay/studio/strength.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::clay {
namespace {

using studio::Changed;
using studio::Contact;
using studio::Grip;
using studio::Hand;
using studio::Rings;
using studio::Side;

// Fingers touch so much of a wall, above and below their middle.
constexpr double kPrintMm = 12.0;
constexpr double kFingersMm = 12.0;

Side side_of(Grip grip) {
    switch (grip) {
        case Grip::kNone:
        case Grip::kAsking:
            return Side::kFree;
        case Grip::kOpen:
        case Grip::kInside:
            return Side::kIn;
        case Grip::kWall:
            return Side::kOut;
        case Grip::kRim:
            return Side::kTop;
    }
    return Side::kFree;
}

// The hands of a grip as one contact, of the depth that a ball would need to do what they do; print_mm above
// and below its middle.
void find_grip_contact(Contact& contact, const Rings& rings, double y_mm, double depth_mm,
                       double print_mm = kPrintMm) {
    contact.height_mm = std::clamp(y_mm, 0.0, rings.top_mm());
    contact.range = rings.rings_between(contact.height_mm - print_mm, contact.height_mm + print_mm);
    const double per_mm = 1.0 / print_mm;
    contact.nearest = rings.ring_at(contact.height_mm);
    contact.floor_depth_mm = 0.0;
    contact.far_depth_mm = contact.rim_depth_mm = -1e9;
    contact.deepest_mm = depth_mm;
    contact.has_rough_rows = false;
    rings.centres_from(contact.height_mm, contact.range, contact.offset_mm.data());
    for (int k = 0; k < contact.range.size(); ++k) {
        const std::size_t at = Rings::at(k);
        const double s = contact.offset_mm[at] * per_mm;
        contact.half_width_mm[at] = kFingersMm;
        contact.depth_mm[at] = depth_mm * std::max(1.0 - s * s, 0.0);
        contact.residual_mm[at] = 0.0;
        contact.has_rough_rows =
            contact.has_rough_rows || rings.rough_mm[Rings::at(contact.range.first + k)] > 0.0F;
    }
}

}  // namespace

studio::GripClimate StudioClay::climate(const StudioParameters& parameters) const {
    constexpr double kFreshKpa = 13.0;
    constexpr double kKilogram = 1000.0;
    const int middle = std::max(rings_.ring_at(std::clamp(grip_.hand_mm.y, 0.0, rings_.top_mm())), 0);
    const auto su = static_cast<double>(rings_.strength_kpa[Rings::at(middle)]);
    const double pace = studio::flow_time_s(kFreshKpa, parameters.flow_time_s) /
                        studio::flow_time_s(su, parameters.flow_time_s);
    return {.load_index = std::max(sweep_.peak_index, sweep_.growing_peak),
            .softness = std::clamp(pace, 0.4, 1.3),
            .size = exponential(natural_log(lump_.mass_g / kKilogram) / 3.0)};
}

// On a wheel that turns the hands of the grip are at work; on one that stands a finger leaves its print.
Changed StudioClay::guide(const StudioInput& input, const StudioParameters& parameters,
                          StudioForces& result) {
    const dvec2 finger(input.hand.position_mm.x, input.hand.position_mm.y);
    const double dt = parameters.dt_s();
    const bool turning = wheel_.speed_rad_s() > studio::kTurningRadS;
    if (turning && input.hand.tool != StudioTool::kHand) return guide_tool(input, parameters, result);
    if (input.hand.tool == StudioTool::kTrimmer) return {};  // it leaves no print
    Changed changed{};
    if (turning) {
        changed = studio::work_grip(grip_, rings_, grip_space_, finger, climate(parameters), dt);
        result.grip = studio::report_of(grip_, finger);
        result.side = side_of(grip_.grip);
    } else {
        studio::let_go(grip_);
        result.grip.hand_mm = result.grip.finger_mm = finger;
        result.side = Side::kOut;
    }
    if (result.side == Side::kFree || rings_.count < 3) return changed;

    const double side = result.grip.hand_mm.x < 0.0 ? -1.0 : 1.0;
    Hand hand;
    hand.radius_mm = kFingersMm;
    hand.side = result.side;
    hand.direction = {side, 0.0};
    hand.in_clay = studio::into_clay(hand.direction, wheel_.heading());
    hand.distance_mm = std::fabs(result.grip.hand_mm.x) + (turning ? 0.0 : kFingersMm);
    hand.position_mm = {side * hand.distance_mm, result.grip.hand_mm.y, 0.0};
    Contact& contact = contacts_[0];
    if (turning) {
        find_grip_contact(contact, rings_, hand.position_mm.y, grip_.press_mm);
    } else {
        studio::find_contact(contact, rings_, hand, {}, parameters);
    }
    if (!contact.touches() || contact.range.size() <= 0) return changed;
    if (turning) {
        studio::round_sectors(rings_, contact, hand, carried_.stripe, parameters);
    } else {
        studio::dent_sectors(rings_, contact, hand, studio::relaxed_fraction(dt / parameters.denting_time_s),
                             parameters.yield_depth_mm);
    }
    if (carried_.film > 0.0)
        studio::wet_faces(rings_, contact.range.first, contact.range.end, contact.depth_mm.data(),
                          carried_.film);
    feel_guided(contact, hand, turning ? grip_.bears_n_mm : 1e9, parameters, result);
    return changed;
}

bool StudioClay::lay_tool(const StudioInput& input, StudioForces& result, Hand& hand) {
    constexpr double kNearMm = 30.0;  // a finger farther out means something else
    studio::let_go(grip_);
    const dvec2 finger(input.hand.position_mm.x, input.hand.position_mm.y);
    result.grip.hand_mm = result.grip.finger_mm = finger;
    const double top = rings_.top_mm();
    const double side = finger.x < 0.0 ? -1.0 : 1.0;
    const double y = std::clamp(finger.y, 0.0, top);
    if (rings_.count < 3) return false;
    const double face = studio::outer_face_mm(rings_, y);
    if (std::fabs(finger.x) > face + kNearMm || finger.y > top + kNearMm) return false;
    hand.tool = input.hand.tool;
    hand.radius_mm = input.hand.radius_mm;
    hand.side = result.side = Side::kOut;
    hand.direction = {side, 0.0};
    hand.in_clay = studio::into_clay(hand.direction, wheel_.heading());
    hand.distance_mm = face + hand.radius_mm;
    hand.position_mm = {side * hand.distance_mm, y, 0.0};
    result.grip.grip = Grip::kWall;
    result.grip.hand_mm = result.grip.finger_mm = {side * face, y};
    result.grip.low_mm = std::max(y - hand.radius_mm, 0.0);
    result.grip.high_mm = std::min(y + hand.radius_mm, top);
    return true;
}

void StudioClay::find_tool_contact(Contact& contact, double y_mm, double depth_mm, double print_mm) {
    find_grip_contact(contact, rings_, y_mm, depth_mm, print_mm);
}

// A rib or a sponge lies along the outer face at the finger's height, with fingers behind the wall.
Changed StudioClay::guide_tool(const StudioInput& input, const StudioParameters& parameters,
                               StudioForces& result) {
    constexpr double kDepthMm = 0.8;  // chosen: lies on it, and does not push
    constexpr double kDry = 1e-6;
    if (input.hand.tool == StudioTool::kTrimmer) return guide_trimmer(input, parameters, result);
    Hand hand;
    if (!lay_tool(input, result, hand)) return {};
    hand.drinks = hand.tool == StudioTool::kSponge && !(input.water > kDry);
    hand.distance_mm -= kDepthMm;
    hand.position_mm.x = hand.direction.x * hand.distance_mm;
    const double y = hand.position_mm.y;
    Contact& contact = contacts_[0];
    find_tool_contact(contact, y, kDepthMm, hand.radius_mm);
    if (!contact.touches() || contact.range.size() <= 0) return {};
    feel_guided(contact, hand, studio::bearable_twist(rings_, y), parameters, result);
    const Changed changed = act(hands_[0], contact, hand, nullptr, input.water, parameters);
    if (changed.size() > 0) rings_.place(changed.first, rings_.count);
    return changed;
}

// What a guided hand feels, and the wheel of it: no more than the clay bears.
void StudioClay::feel_guided(const Contact& contact, const Hand& hand, double bears_n_mm,
                             const StudioParameters& parameters, StudioForces& result) {
    // The other hand holds against it: a wall does not give way as a whole.
    constexpr double kHeld = 1.0;
    const double wet = std::max(carried_.film, static_cast<double>(rings_.film[Rings::at(contact.nearest)]));
    studio::Feel felt =
        studio::feel(rings_, contact, hand, dvec3(0.0), wheel_.speed_rad_s(), wet, kHeld, parameters);
    if (felt.wheel_load_n_mm > bears_n_mm) {
        const double fraction = bears_n_mm / felt.wheel_load_n_mm;
        felt.forces.stiffness_n *= fraction;
        felt.forces.friction_n *= fraction;
        felt.wheel_load_n_mm = bears_n_mm;
    }
    if (felt.wheel_load_n_mm > 0.0)
        carried_.load_height_mm = std::max(carried_.load_height_mm, contact.height_mm);
    carried_.wheel_load_n_mm += felt.wheel_load_n_mm;
    result.hand = felt.forces;
    result.hand.first_touched = contact.range.first;
    result.hand.touched_count = contact.range.size();
}

}  // namespace onggi::clay
