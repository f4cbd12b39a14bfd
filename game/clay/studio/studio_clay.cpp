#include "game/clay/studio/studio_clay.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "game/clay/studio/assist.h"
#include "game/clay/studio/force.h"
#include "game/clay/studio/moves.h"
#include "game/clay/studio/resplit.h"
#include "game/clay/studio/roundness.h"
#include "game/clay/studio/strength.h"
#include "game/clay/studio/volume_grid.h"
#include "game/clay/studio/wall_field.h"

namespace onggi::clay {
namespace {

using studio::Changed;
using studio::Contact;
using studio::Hand;
using studio::HandState;
using studio::Rings;
using studio::Side;

// The scan for rings to split or join: a round, and how many may change a second.
constexpr double kTendS = 0.020;
constexpr double kChangesPerS = 2000.0;

// A hand farther than this from the clay has let go of it.
constexpr double kLetGoMm = 3.0;

bool is_finite(const StudioHand& hand) {
    return std::isfinite(hand.position_mm.x) && std::isfinite(hand.position_mm.y) &&
           std::isfinite(hand.position_mm.z) && std::isfinite(hand.radius_mm);
}

bool are_opposite(Side a, Side b) {
    return (a == Side::kOut && b == Side::kIn) || (a == Side::kIn && b == Side::kOut);
}

// What was just put on the wheel is the whole lump from now on.
void settle_as_lump(Rings& rings, double volume_mm3, studio::Ledger& ledger, studio::LoadSweep& sweep) {
    rings.find_floor();
    rings.settle(0, rings.count);
    ledger = {.lump_mm3 = volume_mm3};
    sweep = {};
    studio::restart(sweep, rings);
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
        rings_.volume_mm3[at] = studio::on_grid(std::numbers::pi * ring * (outer - rings_.inner_mm[at]) *
                                                (outer + rings_.inner_mm[at]));
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
        rings_.volume_mm3[at] = studio::on_grid(std::numbers::pi * rings_.height_mm[at] *
                                                (outer[at] - inner[at]) * (outer[at] + inner[at]));
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

void StudioClay::use_wire(const StudioInput& input) {
    const bool wanted = input.wire != Wire::kNone && std::isfinite(input.wire_height_mm);
    if (wanted && !carried_.wire_was_used && !carried_.cut_off && rings_.count > 0) {
        if (input.wire == Wire::kCutRim) {
            studio::cut_above(rings_, ledger_, input.wire_height_mm);
        } else {
            studio::cut_below(rings_, ledger_, input.wire_height_mm);
            carried_.cut_off = true;
        }
        studio::restart(sweep_, rings_);
        carried_.tend_next = 0;
    }
    carried_.wire_was_used = wanted;
}

// What one hand does to the clay. Contact is known; places are not worked out again here.
Changed StudioClay::act(HandState& state, Contact& contact, const Hand& hand, const Hand* other, double water,
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
        case StudioTool::kHand:
            if (hand.side == Side::kTop) {
                changed = studio::press_rim(rings_, contact, fraction, parameters);
            } else {
                changed = studio::push_rings(rings_, contact, hand, other, fraction, parameters);
                // Walls take turns with the cursors at 2 kHz and beyond, each for the time of two ticks.
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
        case StudioTool::kRib:
            changed =
                studio::smooth_face(rings_, contact, hand, fraction, parameters.rib_length_mm, scratch_);
            break;
        case StudioTool::kSponge: {
            changed =
                studio::smooth_face(rings_, contact, hand, fraction, parameters.sponge_length_mm, scratch_);
            if (!(contact.deepest_mm > 0.0)) break;
            const int touched = std::max(contact.range.size(), 1);
            const double water_g = water * parameters.sponge_water_ml_s * dt / touched;
            constexpr double kFilmS = 0.1;  // chosen: gone within a turn or two
            for (int i = contact.range.first; hand.drinks && i < contact.range.end; ++i)
                studio::drain_ring(rings_, i, parameters.sponge_water_ml_s * dt / touched,
                                   studio::relaxed_fraction(dt / kFilmS));
            for (int i = contact.range.first; water_g > 0.0 && i < contact.range.end; ++i)
                studio::wet_ring(rings_, i, water_g);
            // A wet sponge carries a little clay off as slip.
            const double taken = parameters.slip_mm_s * dt * carried_.film;
            if (taken > 0.0) {
                for (int k = 0; k < contact.range.size(); ++k)
                    scratch_[Rings::at(k)] = contact.depth_mm[Rings::at(k)] > 0.0 ? taken : 0.0;
                changed = studio::together(
                    changed, studio::cut_face(rings_, contact, hand, scratch_, 1.0, ledger_.slip_mm3));
            }
            break;
        }
        case StudioTool::kTrimmer:
            changed = studio::cut_face(rings_, contact, hand, contact.push_mm,
                                       studio::relaxed_fraction(dt / parameters.trim_time_s),
                                       ledger_.trimmings_mm3);
            break;
    }
    // The assist goes where the first hand goes: it has no steadiness of its own to lend.
    if (!hand.is_assist)
        studio::centre_rings(rings_, contact, state,
                             studio::relaxed_fraction(dt / parameters.centring_time_s),
                             parameters.yield_depth_mm);
    studio::round_sectors(rings_, contact, hand, carried_.stripe, parameters);
    if (carried_.film > 0.0 && !hand.drinks)
        studio::wet_faces(rings_, contact.range.first, contact.range.end, contact.depth_mm.data(),
                          carried_.film);
    return changed;
}

// The cursor that splits and joins. True if rings came or went.
bool StudioClay::tend_rings(double dt) {
    if (rings_.count == 0) return false;
    const double target = studio::target_height_mm(rings_, lump_.rings);
    carried_.tend_credit = std::min(carried_.tend_credit + rings_.count * (dt / kTendS), 1.0 * rings_.count);
    carried_.change_credit =
        std::min(carried_.change_credit + kChangesPerS * dt, std::max(1.0, kChangesPerS * dt));
    constexpr int kNoRing = std::numeric_limits<int>::max();
    int lowest = kNoRing;
    while (carried_.tend_credit >= 1.0 && carried_.change_credit >= 1.0) {
        carried_.tend_credit -= 1.0;
        if (carried_.tend_next >= rings_.count) carried_.tend_next = 0;
        const studio::Resplit did = studio::tend_ring(rings_, carried_.tend_next++, target);
        if (did.changed_ring < 0) continue;
        carried_.change_credit -= 1.0;
        lowest = std::min(lowest, did.changed_ring);
        if (did.was_split) {
            studio::after_split(sweep_, did.changed_ring);
            ++carried_.splits;
            ++carried_.tend_next;  // the halves are as they should be
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

// The pedal's speed, or less where a forgiving wheel sees the clay near its limit: stress goes as the square
// of the speed.
double StudioClay::allowed_speed(double wanted, const StudioParameters& parameters) const {
    constexpr double kForgivenIndex = 0.8;
    const double pedal = std::isfinite(wanted) ? std::clamp(wanted, 0.0, studio::kFastestWheelRadS) : 0.0;
    const double index = std::max(sweep_.peak_index, sweep_.growing_peak);
    if (!parameters.forgiving || index <= kForgivenIndex) return pedal;
    return std::min(pedal, wheel_.speed_rad_s() * std::sqrt(kForgivenIndex / index));
}

ContactForces StudioClay::feel_hand(HandState& state, const Contact& contact, const Hand& hand,
                                    const Hand* other, const StudioParameters& parameters,
                                    double& load_n_mm) {
    const dvec3 velocity = state.has_previous && !hand.is_assist
                               ? (hand.position_mm - state.previous_position_mm) * parameters.rate_hz
                               : dvec3(0.0);
    state.previous_position_mm = hand.position_mm;
    state.has_previous = true;
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

StudioForces StudioClay::tick(const StudioInput& input, const StudioParameters& parameters) noexcept {
    StudioForces result;
    const double dt = parameters.dt_s();
    wheel_.step(allowed_speed(input.wheel_speed_rad_s, parameters), carried_.wheel_load_n_mm, dt,
                parameters.wheel);
    carried_.wheel_load_n_mm = 0.0;
    carried_.load_height_mm = 0.0;
    if (input.water > carried_.film) carried_.film = std::min(input.water, 1.0);
    carried_.film -= carried_.film * studio::relaxed_fraction(dt / parameters.film_time_s);
    carried_.stripe = (carried_.stripe + 1) & (studio::stripes_at(parameters.rate_hz) - 1);
    const std::uint64_t changes_before = carried_.splits + carried_.joins;
    const int rings_before = rings_.count;
    use_wire(input);
    if (rings_.count == 0 || carried_.cut_off) {
        result.rings_moved = rings_.count != rings_before;
        return result;
    }

    // The hands, and what each touches.
    std::array<Hand, 2> hand{};
    const bool touches = input.pressing && is_finite(input.hand);
    const bool guided = touches && input.guided;
    std::array<bool, 2> present{touches && !guided,
                                touches && !guided && input.has_second && is_finite(input.second)};
    if (!guided) studio::let_go(grip_);
    for (std::size_t h = 0; h < 2; ++h) {
        if (present[h]) {
            hand[h] = studio::follow_hand(hands_[h], rings_, h == 0 ? input.hand : input.second,
                                          wheel_.heading(), dt);
        } else if (h == 0 || !studio::has_assist(input, rings_, hand[0])) {
            hands_[h] = {};
        }
    }
    if (present[0]) studio::find_contact(contacts_[0], rings_, hand[0], hands_[0], parameters);
    if (present[0] && !present[1] && studio::has_assist(input, rings_, hand[0])) {
        hand[1] = studio::assist_of(hand[0], hands_[0], contacts_[0], contacts_[1], rings_,
                                    input.assist_gap_mm, parameters);
        hands_[1] = hands_[0];
        hands_[1].side = hand[1].side;
        studio::forget_wobble(hands_[1]);  // it rests on the mean circle
        present[1] = true;
    }
    if (present[1]) studio::find_contact(contacts_[1], rings_, hand[1], hands_[1], parameters);
    result.side = hand[0].side;
    result.second_side = hand[1].side;
    result.has_second = present[1];
    result.second_position_mm = hand[1].position_mm;

    std::array<const Hand*, 2> other{nullptr, nullptr};
    if (present[0] && present[1] && are_opposite(hand[0].side, hand[1].side)) other = {&hand[1], &hand[0]};
    for (std::size_t h = 0; h < 2; ++h) {
        if (!present[h]) continue;
        if (hand[h].side == Side::kFree || !(contacts_[h].deepest_mm > -kLetGoMm))
            studio::forget_wobble(hands_[h]);
        else if (!hand[h].is_assist)
            studio::follow_wobble(hands_[h], hand[h], wheel_.speed_rad_s() * dt);
    }

    for (std::size_t h = 0; h < 2; ++h) {
        if (!present[h] || !contacts_[h].touches()) continue;
        ContactForces& forces = h == 0 ? result.hand : result.second;
        forces = feel_hand(hands_[h], contacts_[h], hand[h], other[h], parameters, carried_.wheel_load_n_mm);
    }
    Changed changed{};
    walls_took_turn_ = false;
    for (std::size_t h = 0; h < 2; ++h) {
        // What flows is the mean circle, which an off-centre ring may bring past a hand that it does not
        // touch.
        if (!present[h] || hand[h].side == Side::kFree) continue;
        const Changed by_hand = act(hands_[h], contacts_[h], hand[h], other[h], input.water, parameters);
        ContactForces& forces = h == 0 ? result.hand : result.second;
        forces.first_touched = by_hand.first;
        forces.touched_count = by_hand.size();
        changed = studio::together(changed, by_hand);
    }
    if (changed.size() > 0) rings_.place(changed.first, changed.end);
    if (guided) guide(input, parameters, result);

    result.wheel_load_n_mm = carried_.wheel_load_n_mm;
    const double cursor_dt = carried_.owes_cursors ? 2.0 * dt : dt;
    carried_.owes_cursors = walls_took_turn_;
    if (carried_.owes_cursors) {
        result.rings_moved = rings_.count != rings_before;
        return result;
    }
    // Clay that nobody touches and that stands is left as it is, to the bit.
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

// Twisted through, the wall comes off in the hands.
void StudioClay::tear() {
    if (sweep_.tear_at < rings_.count) {
        const double y = rings_.bottom_mm(sweep_.tear_at);
        studio::cut_above(rings_, ledger_, y);
        sweep_.failure.torn = true;
    }
    std::fill_n(rings_.shear.begin(), rings_.count, 0.0F);
    studio::restart(sweep_, rings_);
}

}  // namespace onggi::clay
