#include "game/clay/studio/grip_work.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "game/clay/studio/spare_clay.h"
#include "game/clay/studio/strength.h"

namespace onggi::clay::studio {
namespace {

// WALL.
constexpr double kWallS = 0.05;
constexpr double kInwardMmS = 96.0;
constexpr double kOutwardMmS = 160.0;
constexpr double kConeMmS = 60.0;
constexpr double kRestsAfterS = 0.5;
constexpr double kRestMmS = 4.0;
constexpr double kRestMm = 4.0;
constexpr double kBehindMm = 12.0;

// The rim.
constexpr double kCatchBelowMm = 3.0;
constexpr double kLoseBelowMm = 12.0;
constexpr double kPullS = 0.06;
constexpr double kPullMmS = 60.0;
constexpr double kTallestPullMm = 225.0;
constexpr double kStrainPerS = 2.0;

// OPEN.
constexpr double kThickFloorMm = 12.5;

// What the load leaves of a move that thins or widens.
double load_fraction(const GripClimate& climate) {
    return std::clamp((0.85 - climate.load_index) / 0.2, 0.0, 1.0);
}

Bore bore_of(const GripState& state) {
    return {.bottom_mm = state.bottom_mm, .radius_mm = state.bore_mm};
}

// The bottom goes down and, once there, the bore widens. True once both are as far as asked.
bool deepen(GripState& state, const Rings& rings, double down_mm, double widen_mm, double widest_mm) {
    const double floor = std::min(kFloorMm, state.bottom_mm);
    state.bottom_mm = std::max(state.bottom_mm - down_mm, floor);
    const bool is_deep = state.bottom_mm <= floor + 6.0;
    if (is_deep) state.bore_mm = std::min(state.bore_mm + widen_mm, std::max(widest_mm, state.bore_mm));
    return state.bottom_mm <= floor && state.bore_mm >= widest_mm && rings.floor_mm() <= floor + 4.0;
}

void hold(GripState& state, double low, double high) {
    state.low_mm = low;
    state.high_mm = high;
}

Changed open_step(GripState& state, Rings& rings, const GripClimate& climate) {
    const double r = state.finger_mm.x;
    const double down = std::max(state.landed_mm.y - state.finger_mm.y, 0.0);
    const double aside = std::fabs(r - state.landed_mm.x);
    const double solid = outer_face_mm(rings, 0.5 * rings.top_mm());
    // One and a half times as deep as the finger went, or by itself where it lies still.
    const double wanted = state.landed_top_mm - 1.5 * down;
    double sink = std::clamp(state.bottom_mm - wanted, 0.0, 45.0 * kGripStepS);
    const bool lies = state.still_s > 0.15;
    if (lies) sink = std::max(sink, 28.0 * kGripStepS);
    double widest = state.bore_mm;
    double widen = 0.0;
    if (aside > 4.0) {
        widest = std::min(kThumbsMm + aside, 60.0 * climate.size);
        widen = 55.0 * kGripStepS;
    } else if (lies) {
        widest = 0.45 * solid;
        widen = 15.0 * kGripStepS;
    }
    const double grant = load_fraction(climate) * climate.softness;
    deepen(state, rings, sink * climate.softness, widen * grant, widest);
    state.hand_mm = {std::max(state.bore_mm - kThumbsMm, 0.0), state.bottom_mm + 0.5 * kThumbsMm};
    state.press_mm = 0.5 + (sink + widen) * 0.1 / kGripStepS;
    hold(state, state.bottom_mm, rings.top_mm());
    return open_bore(rings, bore_of(state));
}

// Solid clay that is asked for what only hollow clay can do: the other hand goes in.
Changed open_by_itself(GripState& state, Rings& rings, const GripClimate& climate) {
    const double widest = 0.45 * outer_face_mm(rings, 0.5 * rings.top_mm());
    state.bore_mm = std::max(state.bore_mm, kThumbsMm);
    const bool is_open = deepen(state, rings, 60.0 * kGripStepS * climate.softness,
                                30.0 * kGripStepS * climate.softness, widest);
    if (is_open) {
        state.opens_by_itself = false;
        state.landed_top_mm = rings.top_mm();
    }
    return open_bore(rings, bore_of(state));
}

Changed carry_step(GripState& state, Rings& rings, GripSpace& space, const GripClimate& climate) {
    const double top = rings.top_mm();
    const double y = std::clamp(state.hand_mm.y, 0.0, top);
    const bool hollow = is_hollow(rings);
    const double now = outer_face_mm(rings, y);
    double error = 0.0;
    if (state.grip == Grip::kInside) {
        const int ring = rings.ring_at(std::max(y, std::min(rings.floor_mm() + 0.5, top)));
        error = std::max(state.hand_mm.x - rings.inner_mm[Rings::at(ring)], 0.0);
    } else {
        error = wall_target(state, rings) - now;
    }
    double step = error * std::fabs(error) / (std::fabs(error) + 2.0) * relaxed(kWallS);
    const double inward = (hollow ? kInwardMmS : kConeMmS) * kGripStepS * climate.softness;
    step = std::clamp(step, -inward, kOutwardMmS * kGripStepS * climate.softness);
    const double wanted = step;
    if (step > 0.0) {
        step *= load_fraction(climate);
        if (wanted > 0.0 && step < 0.3 * wanted) state.guard = GripGuard::kNearLimit;
        step *= std::clamp((top - 46.0 * climate.size) / 10.0, 0.0, 1.0);
    } else {
        step *= std::clamp((std::max(state.landed_top_mm, y) + 12.0 - top) / 8.0, 0.0, 1.0);
        if (state.hand_mm.x + state.offset_mm < wall_target(state, rings) - 3.0)
            state.guard = GripGuard::kAsNarrow;
    }
    const double ahead = std::clamp(0.26 * top + 8.0, 16.0, 42.0);
    const double up = ahead + std::max(-state.heading, 0.0) * (kBehindMm - ahead);
    const double down = ahead + std::max(state.heading, 0.0) * (kBehindMm - ahead);
    state.press_mm = 0.3 + std::fabs(step) * 0.1 / kGripStepS;
    hold(state, std::max(y - down, 0.0), std::min(y + up, top));
    return carry_wall(rings, space,
                      {.height_mm = y,
                       .step_mm = step,
                       .up_mm = up,
                       .down_mm = down,
                       .foot_least_mm = 28.0 * climate.size,
                       .foot_most_mm = 68.0 * climate.size});
}

// A hand that passes the rim upward takes it along.
Changed pull_step(GripState& state, Rings& rings, GripSpace& space, const GripClimate& climate) {
    const double top = rings.top_mm();
    const double y = state.finger_mm.y;
    if (!state.pulls && state.heading > 0.2 && state.hand_mm.y > top - kCatchBelowMm) state.pulls = true;
    if (state.pulls && y < top - kLoseBelowMm) state.pulls = false;
    if (!state.pulls || !(y > top)) return {};
    const double highest = kTallestPullMm * climate.size;
    double rise = std::min((y - top) * relaxed(kPullS), kPullMmS * kGripStepS * climate.softness);
    rise = std::min(rise, highest - top) * load_fraction(climate);
    if (!(rise > 0.0)) {
        state.guard = GripGuard::kNearLimit;
        state.is_spent = true;
        return {};
    }
    const double risen = pull_up(rings, space, rise, kStrainPerS * kGripStepS);
    state.is_spent = risen < 0.2 * rise;
    if (state.is_spent) state.guard = GripGuard::kNoMoreClay;
    state.press_mm = std::max(state.press_mm, 0.5 + 0.1 * risen / kGripStepS);
    hold(state, std::max(top - 24.0, 0.0), rings.top_mm());
    return {rings.first_hollow, rings.count};
}

// The thinnest of the wall at three heights between floor and rim.
double sampled_wall(const Rings& rings) {
    const double floor = rings.floor_mm();
    const double depth = rings.top_mm() - floor;
    double thinnest = 1e9;
    for (const double fraction : {0.25, 0.5, 0.75})
        thinnest = std::min(thinnest, rings.wall_mm(rings.ring_at(floor + fraction * depth)));
    return thinnest;
}

// Moving up below the rim draws a pot that is thick all over up a little, so that who lifts often gets on.
// One that is drawn to an outline keeps its height.
Changed pull_below(GripState& state, Rings& rings, GripSpace& space, double climbed_mm,
                   const GripClimate& climate) {
    constexpr double kMostATouchMm = 4.0;
    if (state.pulls || !(climbed_mm > 0.0) || state.pulled_mm >= kMostATouchMm || !is_hollow(rings))
        return {};
    const double thick = std::clamp((sampled_wall(rings) - 14.0) / 10.0, 0.0, 1.0);
    const double rise = std::min(0.5 * thick * climbed_mm, kMostATouchMm - state.pulled_mm);
    const double risen = pull_up(rings, space, rise * load_fraction(climate), kStrainPerS * kGripStepS);
    state.pulled_mm += risen;
    return risen > 0.0 ? Changed{rings.first_hollow, rings.count} : Changed{};
}

Changed rim_step(GripState& state, Rings& rings, const GripClimate& climate) {
    constexpr double kSinkMmS = 8.0;
    constexpr double kMostShare = 0.08;
    constexpr double kLowestOverFloorMm = 28.0;
    const double top = rings.top_mm();
    const double depth = top - rings.floor_mm();
    hold(state, std::max(top - 0.3 * depth, 0.0), top);
    state.press_mm = 0.4;
    const double wanted = top - state.finger_mm.y;
    if (!(wanted > 1.0) || state.heading > -0.2) return {};
    double sink = std::min(wanted, kSinkMmS * kGripStepS * climate.softness);
    sink = std::min(sink, kMostShare * depth - state.sunk_mm);
    sink = std::min(sink, depth - kLowestOverFloorMm);
    if (!(sink > 0.0)) {
        state.guard = GripGuard::kAsLow;
        return {};
    }
    state.sunk_mm += sink;
    state.press_mm = 1.2;
    return press_down(rings, sink);
}

// A floor too thick for a pot is lowered while the hands are at work.
Changed lower_floor(Rings& rings, double rate_mm_s) {
    const double floor = rings.floor_mm();
    if (!is_hollow(rings) || floor <= kThickFloorMm) return {};
    const int above = rings.ring_at(std::min(floor + 4.0, rings.top_mm()));
    const double bore = std::max(rings.inner_mm[Rings::at(above)], kNarrowestBoreMm);
    return open_bore(rings, {.bottom_mm = std::max(floor - rate_mm_s * kGripStepS - 0.5, kFloorMm),
                             .radius_mm = bore,
                             .outward = 0.0,
                             .largest_strain = 0.01});
}

void place(Rings& rings, const Changed& changed) {
    if (changed.size() > 0) rings.place(changed.first, rings.count);
}

Changed first_stage(GripState& state, Rings& rings, GripSpace& space, const dvec2& finger,
                    const GripClimate& climate) {
    follow_finger(state, finger);
    state.press_mm = 0.0;
    decide(state, rings);
    if (state.grip == Grip::kOpen) return open_step(state, rings, climate);
    if (state.grip == Grip::kNone || state.grip == Grip::kAsking) {
        walk(state, 0.0, 1e9);
        return {};
    }
    if (state.opens_by_itself) return open_by_itself(state, rings, climate);
    const double top = rings.top_mm();
    const double now = outer_face_mm(rings, state.hand_mm.y);
    const double error = state.grip == Grip::kWall ? wall_target(state, rings) - now : 0.0;
    const double before = state.hand_mm.y;
    walk(state, error, top + 1.5);
    if (state.grip == Grip::kRim) return rim_step(state, rings, climate);
    return pull_below(state, rings, space, std::min(state.hand_mm.y, top) - std::min(before, top), climate);
}

Changed second_stage(GripState& state, Rings& rings, GripSpace& space, const GripClimate& climate) {
    if (state.grip != Grip::kWall && state.grip != Grip::kInside) return {};
    if (state.opens_by_itself) return {};
    if (state.travel_mm < kStartsAfterMm) {
        // Resting on the wall presses it in a little, and no more.
        hold(state, std::max(state.hand_mm.y - kBehindMm, 0.0),
             std::min(state.hand_mm.y + kBehindMm, rings.top_mm()));
        state.press_mm = 0.3;
        if (state.still_s < kRestsAfterS || state.grip != Grip::kWall) return {};
        state.rests_mm = std::min(state.rests_mm + kRestMmS * kGripStepS, kRestMm);
    }
    return carry_step(state, rings, space, climate);
}

Changed third_stage(GripState& state, Rings& rings, GripSpace& space, const GripClimate& climate) {
    if (state.grip != Grip::kWall && state.grip != Grip::kInside) return {};
    if (state.opens_by_itself || state.travel_mm < kStartsAfterMm) return {};
    return pull_step(state, rings, space, climate);
}

Changed fourth_stage(GripState& state, Rings& rings, GripSpace& space) {
    state.bears_n_mm = bearable_twist(rings, state.hand_mm.y);
    if (state.grip == Grip::kNone || state.grip == Grip::kAsking || !is_hollow(rings)) return {};
    const bool opens = state.grip == Grip::kOpen || state.opens_by_itself;
    if (opens || state.travel_mm < kStartsAfterMm) return {};
    Changed changed =
        fair_wall(rings, space, std::clamp(state.hand_mm.y, 0.0, rings.top_mm()), relaxed(0.3), relaxed(1.5));
    place(rings, changed);
    if (state.hand_mm.y > rings.top_mm() - 20.0)
        changed = together(changed, soften_lip(rings, space, relaxed(0.6)));
    place(rings, changed);
    return together(changed, lower_floor(rings, 10.0));
}

}  // namespace

double bearable_twist(const Rings& rings, double y) {
    double least = 1e9;
    const int end = rings.ring_at(std::clamp(y, 0.0, rings.top_mm())) + 1;
    for (int i = 0; i < end; ++i) {
        const std::size_t k = Rings::at(i);
        const double middle = 0.5 * (rings.outer_mm[k] + rings.inner_mm[k]);
        const double wall = rings.outer_mm[k] - rings.inner_mm[k];
        const double bears = static_cast<double>(rings.strength_kpa[k]) * middle * middle * wall;
        least = bears < least ? bears : least;
    }
    // su of 2 pi r^2 t; what is equivalent to it by von Mises is the square root of three as much.
    constexpr double kHalf = 0.5;
    return kHalf * least * 2.0 * std::numbers::pi / (std::sqrt(3.0) * kKpaPerNMm2);
}

Changed work_grip(GripState& state, Rings& rings, GripSpace& space, const dvec2& finger,
                  const GripClimate& climate, double dt_s) noexcept {
    if (rings.count < 3) return {};
    if (!state.presses) land(state, rings, finger);
    Changed changed{};
    state.credit_s += dt_s;
    while (state.credit_s > kGripStageS - 1e-9) {
        state.credit_s -= kGripStageS;
        Changed now{};
        switch (state.stage) {
            case 0:
                now = first_stage(state, rings, space, finger, climate);
                break;
            case 1:
                now = second_stage(state, rings, space, climate);
                break;
            case 2:
                now = third_stage(state, rings, space, climate);
                break;
            default:
                now = fourth_stage(state, rings, space);
                break;
        }
        state.stage = (state.stage + 1) % kGripStages;
        if (state.stage == 0) state.shown_guard = std::exchange(state.guard, GripGuard::kNone);
        place(rings, now);
        changed = together(changed, now);
    }
    return changed;
}

}  // namespace onggi::clay::studio
