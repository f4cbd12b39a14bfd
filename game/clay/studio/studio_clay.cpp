#include "game/clay/studio/studio_clay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "engine/core/units.h"
#include "game/clay/bounds.h"
#include "game/clay/exact_math.h"
#include "game/clay/studio/force.h"
#include "game/clay/studio/moves.h"
#include "game/clay/studio/pot.h"
#include "game/clay/studio/rings.h"
#include "game/clay/studio/roundness.h"
#include "game/clay/studio/strength.h"
#include "game/clay/studio/wall_field.h"

namespace onggi::clay {
namespace studio {
namespace {

// The assist: a virtual second hand, held opposite the first across the wall.

// Bounds of the assist's squeeze: a fraction of the wall, and an absolute depth.
constexpr double kSqueezedFraction = 0.25;
constexpr double kSqueezedMm = 3.0;

// Whether the assist applies. Solid clay has no opposite face to hold.
bool has_assist(const tool::ToolState& tool, const Rings& rings, const Hand& hand) noexcept {
    if (tool.second.present || !(tool.assist_gap_mm > 0.0) || rings.first_hollow >= rings.count) return false;
    return hand.side == Side::kIn || (hand.side == Side::kOut && hand.position_mm.y > rings.floor_mm());
}

// Places the assist across the wall from the first hand, given that hand's contact.
//
// The assist rests on the wall without pressing it, and moves with it: a wall held by both moves whole
// (moves.h). It squeezes only while the first hand climbs, by a bounded fraction of the wall at a time, until
// the hands' surfaces are least_gap_mm apart; thick walls take several pulls. It presses only while the first
// hand touches, and less where the floor keeps it from being opposite. work: the assist's own contact, not
// yet computed. Precondition: has_assist(); least_gap_mm > 0.
Hand assist_of(const Hand& hand, const Contact& contact, Contact& work, const Rings& rings,
               double least_gap_mm, const StudioParameters& parameters) noexcept {
    Hand second = hand;
    forget_wobble(second);  // the assist rests on the mean circle
    second.is_assist = true;
    second.tool = Tool::kHand;
    const bool outside = hand.side == Side::kIn;  // the assist is outside
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
    const double squeeze = climb_fraction(hand) * std::min(kSqueezedFraction * wall, kSqueezedMm);
    const double apart = 2.0 * r1 + std::max(least_gap_mm, wall - squeeze);
    const double resting = resting_distance_mm(rings, second.side, second.position_mm.y, r1, work);
    const double steady =
        hand.distance_mm - (hand.wobble_mm.x * hand.in_clay.x + hand.wobble_mm.y * hand.in_clay.y);
    const double least = touch * yield;
    const double most = std::max(touch * squeeze, least);
    second.distance_mm = outside ? std::clamp(steady + apart, resting - most, resting - least)
                                 : std::clamp(steady - apart, resting + least, resting + most);
    second.position_mm.x = second.direction.x * second.distance_mm;
    second.position_mm.z = second.direction.y * second.distance_mm;
    return second;
}

}  // namespace

double foot_wall_mm(const Rings& rings) {
    constexpr double kAboveFloorMm = 4.0;
    if (rings.first_hollow >= rings.count) return 0.0;
    const double y_mm = rings.floor_mm() + kAboveFloorMm;
    return y_mm < rings.top_mm() ? wall_thickness_mm(rings, y_mm) : 0.0;
}

double least_outer_mm(const Rings& rings, int i) noexcept {
    constexpr int kBeside = 6;  // rings, for the slope
    const int first = rings.first_hollow;
    if (first >= rings.count) return kTrimmedFootMm;
    const double corner_mm = rings.inner_mm[Rings::at(first)];
    if (!rings.is_hollow(i)) {
        const double below_mm = rings.floor_mm() - rings.centre_mm(i);
        return below_mm < kTrimmedWallMm ? std::max(corner_mm + kTrimmedWallMm, kTrimmedFootMm)
                                         : std::max(0.5 * corner_mm, kTrimmedFootMm);
    }
    const int low = std::max(i - kBeside, first);
    const int high = std::min(i + kBeside, rings.count - 1);
    const double rise_mm = rings.centre_mm(high) - rings.centre_mm(low);
    const double lean =
        rise_mm > 0.0 ? (rings.inner_mm[Rings::at(high)] - rings.inner_mm[Rings::at(low)]) / rise_mm : 0.0;
    return rings.inner_mm[Rings::at(i)] + kTrimmedWallMm * std::sqrt(1.0 + lean * lean);
}

void dry_to_leather(Rings& rings) noexcept {
    constexpr auto kLeather = static_cast<float>(kLeatherHardLiquidity);
    for (int i = 0; i < rings.count; ++i) {
        rings.film[Rings::at(i)] = 0.0F;
        if (rings.liquidity[Rings::at(i)] > kLeather) set_liquidity(rings, i, kLeatherHardLiquidity);
    }
}

}  // namespace studio

namespace {

using studio::Changed;
using studio::Contact;
using studio::Grip;
using studio::Hand;
using studio::Rings;
using tool::Side;
using tool::Tool;
using tool::Wire;

// The cursor that splits and joins: time of a round, and largest number of changes a second.
constexpr double kTendS = 0.020;
constexpr double kChangesPerS = 2000.0;

// A hand farther from the clay than this has let go.
constexpr double kLetGoMm = 3.0;

template <typename Hand>
bool is_finite(const Hand& hand) {
    return std::isfinite(hand.position_mm.x) && std::isfinite(hand.position_mm.y) &&
           std::isfinite(hand.position_mm.z) && std::isfinite(hand.radius_mm);
}

bool are_opposite(Side a, Side b) {
    return (a == Side::kOut && b == Side::kIn) || (a == Side::kIn && b == Side::kOut);
}

// Counts the present rings as the whole lump and restarts the load sweep.
void settle_as_lump(Rings& rings, double volume_mm3, studio::Ledger& ledger, studio::LoadSweep& sweep) {
    rings.find_floor();
    rings.settle(0, rings.count);
    ledger = {.lump_mm3 = volume_mm3};
    sweep = {};
    studio::restart(sweep, rings);
}

// Fingers touch this length of wall above and below their middle.
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

// The hands of a grip as a contact, with the depth that a ball of the same effect would have; print_mm above
// and below its middle.
void find_grip_contact(Contact& contact, const Rings& rings, double y_mm, double depth_mm,
                       double print_mm = kPrintMm) {
    contact.height_mm = std::clamp(y_mm, 0.0, rings.top_mm());
    contact.range = rings.rings_between(contact.height_mm - print_mm, contact.height_mm + print_mm);
    contact.touched = {0, contact.range.size()};
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

StudioClay::StudioClay(const StudioLump& lump)
    : lump_(lump),
      rings_(studio::ring_capacity(lump), lump.sectors),
      contacts_{Contact(rings_.capacity), Contact(rings_.capacity)},
      grip_space_(rings_.capacity),
      scratch_(static_cast<std::size_t>(rings_.capacity), 0.0) {
    assert(check(lump));
    restart();
}

void StudioClay::restart() noexcept {
    studio::put_lump(rings_, ledger_, lump_);
    sweep_ = {};
    studio::restart(sweep_, rings_);
    hands_ = {};
    grip_ = {};
    carried_ = {};
}

void StudioClay::restart_from(const StudioClay& start) noexcept {
    lump_ = start.lump_;
    rings_.copy_from(start.rings_);
    ledger_ = start.ledger_;
    wheel_ = start.wheel_;
    sweep_ = start.sweep_;
    hands_ = start.hands_;
    grip_ = start.grip_;
    carried_ = start.carried_;
}

void StudioClay::set_wall(double outer, double wall, double floor, double height, int count) {
    assert(count > 0 && count <= rings_.capacity && wall <= outer && floor <= height);
    const auto liquidity = static_cast<double>(rings_.count > 0 ? rings_.liquidity[0] : 0.6F);
    rings_.reset(count);
    double volume = 0.0;
    for (int i = 0; i < count; ++i) {
        const std::size_t at = Rings::at(i);
        const double ring = height / count;
        rings_.outer_mm[at] = outer;
        rings_.inner_mm[at] = (i + 0.5) * ring < floor ? 0.0 : outer - wall;
        rings_.volume_mm3[at] =
            studio::on_grid(kPi * ring * (outer - rings_.inner_mm[at]) * (outer + rings_.inner_mm[at]));
        volume += rings_.volume_mm3[at];
        studio::set_liquidity(rings_, i, liquidity);
    }
    settle_as_lump(rings_, volume, ledger_, sweep_);
    hands_ = {};
}

void StudioClay::set_profile(std::span<const double> outer, std::span<const double> inner) {
    const int count = rings_.count;
    assert(outer.size() >= Rings::at(count) && inner.size() >= Rings::at(count));
    double volume = 0.0;
    for (int i = 0; i < count; ++i) {
        const std::size_t at = Rings::at(i);
        rings_.outer_mm[at] = outer[at];
        rings_.inner_mm[at] = inner[at];
        rings_.volume_mm3[at] =
            studio::on_grid(kPi * rings_.height_mm[at] * (outer[at] - inner[at]) * (outer[at] + inner[at]));
        volume += rings_.volume_mm3[at];
    }
    settle_as_lump(rings_, volume, ledger_, sweep_);
    hands_ = {};
}

void StudioClay::set_centre(const dvec2& centre) {
    std::fill_n(rings_.centre_x_mm.begin(), rings_.count, static_cast<float>(centre.x));
    std::fill_n(rings_.centre_z_mm.begin(), rings_.count, static_cast<float>(centre.y));
}

void StudioClay::set_liquidity(double liquidity) {
    for (int i = 0; i < rings_.count; ++i)
        studio::set_liquidity(rings_, i, liquidity);
}

dvec2 StudioClay::centre_mm(int ring) const {
    return {static_cast<double>(rings_.centre_x_mm[Rings::at(ring)]),
            static_cast<double>(rings_.centre_z_mm[Rings::at(ring)])};
}

std::span<const float> StudioClay::residuals_mm(int ring) const {
    if (!(rings_.rough_mm[Rings::at(ring)] > 0.0F)) return {};
    return {rings_.row_of(ring), static_cast<std::size_t>(rings_.sectors)};
}

void StudioClay::use_wire(const tool::ToolState& tool) {
    const bool wanted = tool.wire != Wire::kNone && std::isfinite(tool.wire_height_mm);
    if (wanted && !carried_.wire_was_used && !carried_.cut_off && rings_.count > 0) {
        if (tool.wire == Wire::kCutRim) {
            studio::cut_above(rings_, ledger_, tool.wire_height_mm);
        } else {
            studio::cut_below(rings_, ledger_, tool.wire_height_mm);
            carried_.cut_off = true;
        }
        studio::restart(sweep_, rings_);
        carried_.tend_next = 0;
    }
    carried_.wire_was_used = wanted;
}

// Applies one hand to the clay. Its contact is known; the caller updates the places.
Changed StudioClay::act(Contact& contact, const Hand& hand, const Hand* other, double water,
                        const StudioParameters& parameters) {
    const double dt = parameters.dt_s();
    const bool turning = wheel_.speed_rad_s() > studio::kTurningRadS;
    const auto su = static_cast<double>(rings_.strength_kpa[Rings::at(contact.nearest)]);
    const double fraction = studio::relaxed_fraction(dt / studio::flow_time_s(su, parameters.flow_time_s));
    if (!turning) {
        studio::dent_sectors(rings_, contact, hand, studio::relaxed_fraction(dt / parameters.denting_time_s),
                             parameters.yield_depth_mm);
        return {};
    }

    Changed changed{};
    switch (hand.tool) {
        case Tool::kHand:
            if (hand.side == Side::kTop) {
                changed = studio::press_rim(rings_, contact, fraction, parameters);
            } else {
                changed = studio::push_rings(rings_, contact, hand, other, fraction, parameters);
                // At 2 kHz and faster, walls and cursors use alternate ticks, each with the time step of two.
                const bool takes_turns = studio::stripes_at(parameters.rate_hz) > 1;
                if (takes_turns && carried_.stripe % 2 != 0) break;
                const double wall_dt = takes_turns ? 2.0 * dt : dt;
                const double wall_fraction =
                    studio::relaxed_fraction(wall_dt / studio::flow_time_s(su, parameters.flow_time_s));
                const Changed wall =
                    studio::move_wall(rings_, contact, hand, wall_fraction, wall_dt, parameters);
                walls_took_turn_ = walls_took_turn_ || (takes_turns && wall.size() > 0);
                changed = studio::together(changed, wall);
            }
            break;
        case Tool::kRib:
            changed =
                studio::smooth_face(rings_, contact, hand, fraction, parameters.rib_length_mm, scratch_);
            break;
        case Tool::kSponge: {
            changed =
                studio::smooth_face(rings_, contact, hand, fraction, parameters.sponge_length_mm, scratch_);
            if (!(contact.deepest_mm > 0.0)) break;
            const int touched = std::max(contact.range.size(), 1);
            const double water_g = water * parameters.sponge_water_ml_s * dt / touched;
            constexpr double kFilmS = 0.1;  // chosen: the film is gone within a turn or two
            for (int i = contact.range.first; hand.drinks && i < contact.range.end; ++i)
                studio::drain_ring(rings_, i, parameters.sponge_water_ml_s * dt / touched,
                                   studio::relaxed_fraction(dt / kFilmS));
            for (int i = contact.range.first; water_g > 0.0 && i < contact.range.end; ++i)
                studio::wet_ring(rings_, i, water_g);
            // A wet sponge carries off a little clay as slip.
            const double taken = parameters.slip_mm_s * dt * carried_.film;
            if (taken > 0.0) {
                for (int k = 0; k < contact.range.size(); ++k)
                    scratch_[Rings::at(k)] = contact.depth_mm[Rings::at(k)] > 0.0 ? taken : 0.0;
                changed = studio::together(
                    changed, studio::cut_face(rings_, contact, hand, scratch_, 1.0, ledger_.slip_mm3));
            }
            break;
        }
        case Tool::kTrimmer:
            changed = studio::cut_face(rings_, contact, hand, contact.push_mm,
                                       studio::relaxed_fraction(dt / parameters.trim_time_s),
                                       ledger_.trimmings_mm3);
            break;
        case Tool::kWire:
            break;
    }
    // The assist follows the first hand: it does not centre the clay a second time.
    if (!hand.is_assist)
        studio::centre_rings(rings_, contact, hand, studio::relaxed_fraction(dt / parameters.centring_time_s),
                             parameters.yield_depth_mm);
    studio::round_sectors(rings_, contact, hand, carried_.stripe, parameters);
    if (carried_.film > 0.0 && !hand.drinks)
        studio::wet_faces(rings_, contact.range.first, contact.range.end, contact.depth_mm.data(),
                          carried_.film);
    return changed;
}

// The cursor that splits and joins. Returns true if it changed the rings.
bool StudioClay::tend_rings(double dt) {
    if (rings_.count == 0) return false;
    const double target = studio::target_height_mm(rings_, lump_.rings);
    carried_.tend_credit = std::min(carried_.tend_credit + rings_.count * (dt / kTendS), 1.0 * rings_.count);
    carried_.change_credit =
        std::min(carried_.change_credit + kChangesPerS * dt, std::max(1.0, kChangesPerS * dt));
    constexpr int kNoRing = std::numeric_limits<int>::max();
    int lowest = kNoRing;
    while (carried_.tend_credit >= 1.0 && carried_.change_credit >= 1.0) {
        if (carried_.tend_next >= rings_.count) carried_.tend_next = 0;
        // The rings that need no change are passed over at once; each takes its credit all the same.
        const int most = static_cast<int>(carried_.tend_credit);
        const int last = std::min(carried_.tend_next + most, rings_.count);
        const int found = studio::first_to_tend(rings_, {carried_.tend_next, last}, target);
        carried_.tend_credit -= found - carried_.tend_next;
        carried_.tend_next = found;
        if (found == last) continue;
        carried_.tend_credit -= 1.0;
        const studio::Resplit did = studio::tend_ring(rings_, carried_.tend_next++, target);
        if (did.changed_ring < 0) continue;
        carried_.change_credit -= 1.0;
        lowest = std::min(lowest, did.changed_ring);
        if (did.was_split) {
            studio::after_split(sweep_, did.changed_ring);
            ++carried_.splits;
            ++carried_.tend_next;  // the halves need no visit
        } else {
            studio::after_join(sweep_, did.changed_ring);
            ++carried_.joins;
            carried_.tend_next = did.changed_ring + 1;
        }
    }
    if (lowest == kNoRing) return false;
    rings_.place(std::min(lowest, std::max(rings_.count - 1, 0)), rings_.count);
    return true;
}

// The pedal's speed. A forgiving wheel lowers it while the clay is near its limit: stress grows as the square
// of the speed.
double StudioClay::allowed_speed(double wanted, const StudioParameters& parameters) const {
    const double pedal = std::isfinite(wanted) ? std::clamp(wanted, 0.0, studio::kFastestWheelRadS) : 0.0;
    const double index = std::max(sweep_.peak_index, sweep_.growing_peak);
    if (!parameters.forgiving || index <= studio::kForgivenLoad) return pedal;
    return std::min(pedal, wheel_.speed_rad_s() * std::sqrt(studio::kForgivenLoad / index));
}

ContactForces StudioClay::feel_hand(Hand& hand, const Contact& contact, const Hand* other,
                                    const StudioParameters& parameters, double& load_n_mm) {
    const dvec3 velocity = hand.has_previous && !hand.is_assist
                               ? (hand.position_mm - hand.previous_position_mm) * parameters.rate_hz
                               : dvec3(0.0);
    hand.previous_position_mm = hand.position_mm;
    hand.has_previous = true;
    const double supported =
        other == nullptr
            ? 0.0
            : studio::backing_of(*other, studio::face_at(rings_, *other)[Rings::at(contact.nearest)],
                                 contact.height_mm - other->position_mm.y)
                  .held;
    // A wet face slides as a wet hand does.
    const double wet = std::max(carried_.film, static_cast<double>(rings_.film[Rings::at(contact.nearest)]));
    const studio::Feel felt =
        studio::feel(rings_, contact, hand, velocity, wheel_.speed_rad_s(), wet, supported, parameters);
    if (felt.wheel_load_n_mm > 0.0)
        carried_.load_height_mm = std::max(carried_.load_height_mm, contact.height_mm);
    load_n_mm += felt.wheel_load_n_mm;
    return felt.forces;
}

StudioClay::Hands StudioClay::find_hands(const tool::ToolState& tool, const StudioParameters& parameters,
                                         bool touch) {
    auto& [first, second] = hands_;
    Hands hands{.present = {touch, touch && tool.second.present && is_finite(tool.second)}};
    auto& present = hands.present;
    const double dt = parameters.dt_s();
    if (present[0]) {
        studio::follow_hand(first, rings_, tool, wheel_.heading(), dt);
        studio::find_contact(contacts_[0], rings_, first, parameters);
    } else {
        first = {};
    }
    if (present[1]) {
        studio::follow_hand(second, rings_, tool.second, wheel_.heading(), dt);
    } else if (studio::has_assist(tool, rings_, first)) {
        second = studio::assist_of(first, contacts_[0], contacts_[1], rings_, tool.assist_gap_mm, parameters);
        present[1] = true;
    } else {
        second = {};
    }
    if (present[1]) studio::find_contact(contacts_[1], rings_, second, parameters);
    hands.opposite = present[0] && present[1] && are_opposite(first.side, second.side);
    for (std::size_t h = 0; h < 2; ++h) {
        if (!present[h]) continue;
        if (hands_[h].side == Side::kFree || !(contacts_[h].deepest_mm > -kLetGoMm))
            studio::forget_wobble(hands_[h]);
        else if (!hands_[h].is_assist)
            studio::follow_wobble(hands_[h], wheel_.speed_rad_s() * dt);
    }
    return hands;
}

void StudioClay::work_hands(const Hands& hands, double water, const StudioParameters& parameters,
                            StudioForces& result) {
    const auto& [present, opposite] = hands;
    const std::array<const Hand*, 2> other{opposite ? &hands_[1] : nullptr, opposite ? &hands_[0] : nullptr};
    for (std::size_t h = 0; h < 2; ++h) {
        if (!present[h] || !contacts_[h].touches()) continue;
        ContactForces& forces = h == 0 ? result.hand : result.second;
        forces = feel_hand(hands_[h], contacts_[h], other[h], parameters, carried_.wheel_load_n_mm);
    }
    Changed changed{};
    walls_took_turn_ = false;
    for (std::size_t h = 0; h < 2; ++h) {
        // The mean circle flows even where an off-centre ring does not touch the hand now.
        if (!present[h] || hands_[h].side == Side::kFree) continue;
        const Changed by_hand = act(contacts_[h], hands_[h], other[h], water, parameters);
        ContactForces& forces = h == 0 ? result.hand : result.second;
        forces.first_touched = by_hand.first;
        forces.touched_count = by_hand.size();
        changed = studio::together(changed, by_hand);
    }
    if (changed.size() > 0) rings_.place(changed.first, changed.end);
}

StudioForces StudioClay::tick(const tool::ToolState& tool, const StudioParameters& parameters) noexcept {
    StudioForces result;
    const double dt = parameters.dt_s();
    const double pedal_rad_s = tool.wheel_button ? units::rad_s_from_rev_min(tool.wheel_speed_rev_min) : 0.0;
    wheel_.step(allowed_speed(pedal_rad_s, parameters), carried_.wheel_load_n_mm, dt, parameters.wheel);
    carried_.wheel_load_n_mm = 0.0;
    carried_.load_height_mm = 0.0;
    if (tool.water > carried_.film) carried_.film = std::min(tool.water, 1.0);
    carried_.film -= carried_.film * studio::relaxed_fraction(dt / parameters.film_time_s);
    carried_.stripe = (carried_.stripe + 1) & (studio::stripes_at(parameters.rate_hz) - 1);
    const std::uint64_t changes_before = carried_.splits + carried_.joins;
    const int rings_before = rings_.count;
    use_wire(tool);
    if (rings_.count == 0 || carried_.cut_off) {
        result.rings_moved = rings_.count != rings_before;
        return result;
    }

    const bool touches = tool.pressing && is_finite(tool);
    const bool guided = touches && tool.guided;
    if (!guided) studio::let_go(grip_);
    const Hands hands = find_hands(tool, parameters, touches && !guided);
    result.side = hands_[0].side;
    result.second_side = hands_[1].side;
    result.has_second = hands.present[1];
    result.second_position_mm = hands_[1].position_mm;
    work_hands(hands, tool.water, parameters, result);
    if (guided) guide(tool, parameters, result);

    result.wheel_load_n_mm = carried_.wheel_load_n_mm;
    const double cursor_dt = carried_.owes_cursors ? 2.0 * dt : dt;
    carried_.owes_cursors = walls_took_turn_;
    if (carried_.owes_cursors) {
        result.rings_moved = rings_.count != rings_before;
        return result;
    }
    // Untouched clay that stands keeps its bits.
    const bool sinks = std::max(sweep_.peak_index, sweep_.growing_peak) >= 1.0;
    const bool tended = (touches || sinks) && tend_rings(cursor_dt);
    const Changed slumped = studio::sweep_load(sweep_, rings_,
                                               {.wheel_speed_rad_s = wheel_.speed_rad_s(),
                                                .twist_n_mm = carried_.wheel_load_n_mm,
                                                .twist_height_mm = carried_.load_height_mm,
                                                .evaporation_g_mm2_s = parameters.evaporation_g_mm2_s,
                                                .film_time_s = parameters.film_time_s,
                                                .diffusivity_mm2_s = parameters.diffusivity_mm2_s,
                                                .slumps = parameters.slumps,
                                                .dt_s = cursor_dt});
    if (slumped.size() > 0) rings_.place(slumped.first, slumped.end);
    if (sweep_.tear_at >= 0) tear();
    result.rings_moved =
        tended || carried_.splits + carried_.joins != changes_before || rings_.count != rings_before;
    return result;
}

// The twisted wall tears off.
void StudioClay::tear() {
    if (sweep_.tear_at < rings_.count) {
        const double y = rings_.bottom_mm(sweep_.tear_at);
        studio::cut_above(rings_, ledger_, y);
        sweep_.failure.torn = true;
    }
    std::fill_n(rings_.shear.begin(), rings_.count, 0.0F);
    studio::restart(sweep_, rings_);
}

// The guided hand's part of the tick: grip_work.h on this clay, and the resulting forces.

studio::GripClimate StudioClay::climate(const tool::ToolState& tool,
                                        const StudioParameters& parameters) const {
    constexpr double kFreshKpa = 13.0;
    constexpr double kKilogram = 1000.0;
    const int middle = std::max(rings_.ring_at(std::clamp(grip_.hand_mm.y, 0.0, rings_.top_mm())), 0);
    const auto su = static_cast<double>(rings_.strength_kpa[Rings::at(middle)]);
    const double pace = studio::flow_time_s(kFreshKpa, parameters.flow_time_s) /
                        studio::flow_time_s(su, parameters.flow_time_s);
    const bool wide = parameters.manner == studio::Manner::kWide;
    const double push = wide ? tool::push_of(tool) : 1.0;
    return {.load_index = std::max(sweep_.peak_index, sweep_.growing_peak),
            .softness = std::clamp(pace, 0.4, 1.3) * push,
            .size = exponential(natural_log(lump_.mass_g / kKilogram) / 3.0),
            .push = push,
            .wide = wide};
}

// While the wheel turns, the hands of the grip work; while it stands, a finger leaves a dent.
Changed StudioClay::guide(const tool::ToolState& tool, const StudioParameters& parameters,
                          StudioForces& result) {
    const dvec2 finger(tool.position_mm.x, tool.position_mm.y);
    studio::GripFingers fingers{.first_mm = finger};
    if (tool.second.present && is_finite(tool.second))
        fingers.second_mm = dvec2(tool.second.position_mm.x, tool.second.position_mm.y);
    const double dt = parameters.dt_s();
    const bool turning = wheel_.speed_rad_s() > studio::kTurningRadS;
    if (turning && tool.tool != Tool::kHand) return guide_tool(tool, parameters, result);
    if (tool.tool == Tool::kTrimmer) return {};  // a trimmer leaves no dent
    Changed changed{};
    if (turning) {
        changed = studio::work_grip(grip_, rings_, grip_space_, fingers, climate(tool, parameters), dt);
        result.grip = studio::report_of(grip_, fingers);
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
        studio::find_contact(contact, rings_, hand, parameters);
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

bool StudioClay::lay_tool(const tool::ToolState& tool, StudioForces& result, Hand& hand) {
    constexpr double kNearMm = 30.0;  // a finger farther out does not mean the tool
    studio::let_go(grip_);
    const dvec2 finger(tool.position_mm.x, tool.position_mm.y);
    result.grip.hand_mm = result.grip.finger_mm = finger;
    const double top = rings_.top_mm();
    const double side = finger.x < 0.0 ? -1.0 : 1.0;
    const double y = std::clamp(finger.y, 0.0, top);
    if (rings_.count < 3) return false;
    const double face = studio::outer_face_mm(rings_, y);
    if (std::fabs(finger.x) > face + kNearMm || finger.y > top + kNearMm) return false;
    hand.tool = tool.tool;
    hand.radius_mm = tool.radius_mm;
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
Changed StudioClay::guide_tool(const tool::ToolState& tool, const StudioParameters& parameters,
                               StudioForces& result) {
    constexpr double kDepthMm = 0.8;  // chosen: the tool rests without pushing
    constexpr double kDry = 1e-6;
    if (tool.tool == Tool::kTrimmer) return guide_trimmer(tool, parameters, result);
    Hand hand;
    if (!lay_tool(tool, result, hand)) return {};
    hand.drinks = hand.tool == Tool::kSponge && !(tool.water > kDry);
    hand.distance_mm -= kDepthMm;
    hand.position_mm.x = hand.direction.x * hand.distance_mm;
    const double y = hand.position_mm.y;
    Contact& contact = contacts_[0];
    find_tool_contact(contact, y, kDepthMm, hand.radius_mm);
    if (!contact.touches() || contact.range.size() <= 0) return {};
    feel_guided(contact, hand, studio::bearable_twist(rings_, y), parameters, result);
    const Changed changed = act(contact, hand, nullptr, tool.water, parameters);
    if (changed.size() > 0) rings_.place(changed.first, rings_.count);
    return changed;
}

// Forces on a guided hand and its load on the wheel, limited to bears_n_mm, the torque that the clay bears.
void StudioClay::feel_guided(const Contact& contact, const Hand& hand, double bears_n_mm,
                             const StudioParameters& parameters, StudioForces& result) {
    // The other hand supports the wall: it does not yield as a whole.
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

// The guided trimmer's part of the tick: a loop on the outer face at the finger's height that shaves off the
// clay beyond the finger. The pot is leather hard by then: the clay is cut and does not yield.
studio::Changed StudioClay::guide_trimmer(const tool::ToolState& tool, const StudioParameters& parameters,
                                          StudioForces& result) {
    constexpr double kDeepestMm = 2.0;  // depth of one shaving
    constexpr double kOfWheel = 0.2;    // fraction of the wheel's torque that a cut may load
    if (!is_leather_hard()) {
        studio::dry_to_leather(rings_);
        studio::restart(sweep_, rings_);
        carried_.film = 0.0;
    }
    studio::Hand hand;
    if (!lay_tool(tool, result, hand)) return {};
    const double y = hand.position_mm.y;
    const double face = std::fabs(result.grip.hand_mm.x);
    const double beyond = std::clamp(face - std::fabs(tool.position_mm.x), 0.0, kDeepestMm);
    studio::Contact& contact = contacts_[0];
    find_tool_contact(contact, y, beyond, hand.radius_mm);
    if (!contact.touches() || contact.range.size() <= 0) return {};
    feel_guided(contact, hand, kOfWheel * parameters.wheel.largest_torque_n_mm, parameters, result);
    const double fraction = studio::relaxed_fraction(parameters.dt_s() / parameters.trim_time_s);
    for (int k = 0; k < contact.range.size(); ++k) {
        const std::size_t at = studio::Rings::at(k);
        const int ring = contact.range.first + k;
        const double spare = rings_.outer_mm[studio::Rings::at(ring)] - studio::least_outer_mm(rings_, ring);
        const double most = parameters.forgiving ? std::max(spare, 0.0) / fraction : kDeepestMm;
        scratch_[at] = std::min(contact.depth_mm[at], most);
    }
    const studio::Changed changed =
        studio::cut_face(rings_, contact, hand, scratch_, fraction, ledger_.trimmings_mm3);
    if (changed.size() > 0) rings_.place(changed.first, rings_.count);
    return changed;
}

bool StudioClay::is_leather_hard() const {
    constexpr auto kLeather = static_cast<float>(studio::kLeatherHardLiquidity);
    return std::all_of(rings_.liquidity.begin(), rings_.liquidity.begin() + rings_.count,
                       [](float liquidity) { return liquidity <= kLeather; });
}

// Limits of a lump and of the parameters, and the sentence about a failed pot.

Result<void> check(const StudioLump& lump) {
    const Bound bounds[] = {
        {"mass, g", lump.mass_g, kLeastLumpG, kLargestLumpG},
        {"body", static_cast<double>(lump.body), 0.0, 2.0},
        {"liquidity index", lump.liquidity_index, 0.0, 1.2},
        {"rings", static_cast<double>(lump.rings), kFewestRings, kMostRings},
        {"sectors", static_cast<double>(lump.sectors), 16.0, 256.0},
        {"off-centre, mm", lump.off_centre_mm, 0.0, 5.0},
    };
    if (auto checked = check_bounds("lump", bounds); !checked) return checked;
    if ((lump.sectors & (lump.sectors - 1)) != 0)
        return bad_input(fmt::format("lump sectors: expected a power of two, found {}", lump.sectors));
    return {};
}

Result<void> check(const StudioParameters& p) {
    const Bound bounds[] = {
        {"rate, Hz", p.rate_hz, 100.0, 10000.0},
        {"flow time, s", p.flow_time_s, 0.01, 10.0},
        {"yield depth, mm", p.yield_depth_mm, 0.0, 5.0},
        {"wall share k0", p.wall_fraction_k0, 0.0, 0.95},
        {"thin wall, mm", p.thin_wall_mm, 1.0, 50.0},
        {"hoop share chi", p.hoop_fraction_chi, 0.0, 1.0},
        {"field length beta", p.field_length_beta, 0.1, 10.0},
        {"floor, mm", p.floor_mm, 1.0, 100.0},
        {"largest strain rate, 1/s", p.largest_strain_rate, 0.1, 50.0},
        {"centring time, s", p.centring_time_s, 0.05, 100.0},
        {"rounding time, s", p.rounding_time_s, 0.05, 100.0},
        {"denting time, s", p.denting_time_s, 0.05, 100.0},
        {"sponge length, mm", p.sponge_length_mm, 0.1, 3.0},
        {"rib length, mm", p.rib_length_mm, 0.1, 3.0},
        {"trim time, s", p.trim_time_s, 0.01, 10.0},
        {"sponge water, ml/s", p.sponge_water_ml_s, 0.0, 100.0},
        {"slip, mm/s", p.slip_mm_s, 0.0, 1.0},
        {"evaporation, g/(mm^2 s)", p.evaporation_g_mm2_s, 0.0, 1e-3},
        {"film time, s", p.film_time_s, 0.1, 1e4},
        {"diffusivity, mm^2/s", p.diffusivity_mm2_s, 0.0, 1.0},
        {"bearing factor Nc", p.bearing_factor_nc, 0.1, 100.0},
        {"viscosity c2, N s/mm", p.viscosity_c2_n_s_per_mm, 0.0, 1.0},
        {"dry friction", p.friction_dry, 0.0, 2.0},
        {"wet friction", p.friction_wet, 0.0, 2.0},
        {"largest force, N", p.largest_force_n, 0.1, 1000.0},
        {"wheel inertia, kg m^2", p.wheel.inertia_kg_m2, 1e-3, 100.0},
        {"wheel torque, N mm", p.wheel.largest_torque_n_mm, 0.0, 1e6},
        {"wheel drag, N mm s", p.wheel.drag_n_mm_s, 0.0, 1e5},
        {"wheel pull, N mm s", p.wheel.pull_n_mm_s, 0.0, 1e6},
    };
    return check_bounds("clay parameter", bounds);
}

std::string sentence(const studio::Failure& failure) {
    const double speed = units::rev_min_from_rad_s(failure.wheel_speed_rad_s);
    const std::string what = fmt::format("at {:.0f} mm the clay held {:.1f} kPa and had to carry {:.1f}",
                                         failure.height_mm, 2.0 * failure.strength_kpa, failure.stress_kpa);
    switch (failure.cause) {
        case studio::Cause::kNone:
            return {};
        case studio::Cause::kWeight:
            return fmt::format("The wall sank under its own weight: {}.", what);
        case studio::Cause::kSpin:
            return fmt::format("The wheel spun the wall apart: {:.0f} rev/min on {:.0f} mm across, {}.",
                               speed, 2.0 * failure.radius_mm, what);
        case studio::Cause::kOverhang:
            return fmt::format("The wall leaned out too far and sagged: {}.", what);
        case studio::Cause::kTwist:
            return fmt::format("The hands {} the wall: {}; more water on them would let it slide.",
                               failure.torn ? "tore off" : "twisted", what);
    }
    return {};
}

}  // namespace onggi::clay
