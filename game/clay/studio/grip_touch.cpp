#include "game/clay/studio/grip_touch.h"

#include <algorithm>
#include <cmath>

#include "game/clay/studio/spare_clay.h"
#include "game/clay/studio/strength.h"

namespace onggi::clay::studio {
namespace {

// Smoothing time: a pointer reports only sixty times a second.
constexpr double kFingerS = 0.025;
constexpr double kTrailMm = 0.5;
constexpr double kHandMmS = 260.0;
constexpr double kErrorSlowsFromMm = 4.0;
constexpr double kErrorSlowsOverMm = 10.0;
constexpr double kSlowest = 0.12;
constexpr double kStillMmS = 12.0;  // a slower finger counts as lying still

constexpr double kNarrowsTo = 0.7;  // fraction of the radius at landing

double distance(const dvec2& a, const dvec2& b) {
    const dvec2 way = a - b;
    return std::sqrt(way.x * way.x + way.y * way.y);
}

double landed_outer(const GripState& state, double fraction) {
    const double place =
        std::clamp(fraction, 0.0, 1.0) * static_cast<double>(state.landed_outer_mm.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(place), state.landed_outer_mm.size() - 2);
    const double part = place - static_cast<double>(low);
    return (1.0 - part) * static_cast<double>(state.landed_outer_mm[low]) +
           part * static_cast<double>(state.landed_outer_mm[low + 1]);
}

void drop_oldest(GripTrail& trail) {
    trail.first = (trail.first + 1) % GripTrail::kMost;
    --trail.count;
}

}  // namespace

double relaxed(double tau_s) noexcept {
    return relaxed_fraction(kGripStepS / tau_s);
}

bool is_hollow(const Rings& rings) noexcept {
    return rings.top_mm() - rings.floor_mm() > kHollowMm;
}

double outer_face_mm(const Rings& rings, double y) noexcept {
    return rings.outer_mm[Rings::at(rings.ring_at(std::clamp(y, 0.0, rings.top_mm())))];
}

void land(GripState& state, const Rings& rings, const dvec2& finger) noexcept {
    const double credit = state.credit_s;
    state = {};
    state.credit_s = credit;
    state.presses = true;
    state.side = finger.x < 0.0 ? -1.0 : 1.0;
    state.finger_mm = state.hand_mm = state.landed_mm = {std::fabs(finger.x), finger.y};
    state.grip = grip_of_touch(outline_of(rings, finger.y), finger);
    const double top = rings.top_mm();
    state.landed_top_mm = top;
    for (std::size_t i = 0; i < state.landed_outer_mm.size(); ++i) {
        const double fraction =
            static_cast<double>(i) / static_cast<double>(state.landed_outer_mm.size() - 1);
        state.landed_outer_mm[i] = static_cast<float>(outer_face_mm(rings, fraction * top));
    }
    const double wall = outer_face_mm(rings, finger.y);
    state.offset_mm = wall - state.finger_mm.x;
    state.offset_way_mm = std::fabs(state.offset_mm) <= std::max(14.0, 0.6 * wall) ? 4.0 : 60.0;
    state.bottom_mm = is_hollow(rings) ? rings.floor_mm() : top;
    state.bore_mm = kThumbsMm;
    if (state.grip == Grip::kOpen && is_hollow(rings)) {
        const int above = rings.ring_at(std::min(rings.floor_mm() + kThumbsMm, top));
        state.bore_mm = std::max(kThumbsMm, rings.inner_mm[Rings::at(above)]);
    }
}

void follow_finger(GripState& state, const dvec2& finger) noexcept {
    const dvec2 now{std::max(0.0, state.side * finger.x), finger.y};
    const dvec2 before = state.finger_mm;
    state.finger_mm += (now - before) * relaxed(kFingerS);
    const double way = distance(state.finger_mm, before);
    state.still_s = way < kStillMmS * kGripStepS ? state.still_s + kGripStepS : 0.0;
    GripTrail& trail = state.trail;
    const auto last = [&]() -> const dvec2& {
        return trail.point_mm[static_cast<std::size_t>((trail.first + trail.count - 1) % GripTrail::kMost)];
    };
    const dvec2& end = trail.count > 0 ? last() : state.hand_mm;
    if (distance(state.finger_mm, end) < kTrailMm) return;
    // The trail is full: drop its oldest point.
    if (trail.count == GripTrail::kMost) drop_oldest(trail);
    trail.point_mm[static_cast<std::size_t>((trail.first + trail.count) % GripTrail::kMost)] =
        state.finger_mm;
    ++trail.count;
}

void walk(GripState& state, double error_mm, double highest_mm) noexcept {
    const double pace =
        std::clamp(1.0 - (std::fabs(error_mm) - kErrorSlowsFromMm) / kErrorSlowsOverMm, kSlowest, 1.0);
    double left = kHandMmS * pace * kGripStepS;
    GripTrail& trail = state.trail;
    while (left > 0.0 && trail.count > 0) {
        const dvec2& next = trail.point_mm[static_cast<std::size_t>(trail.first)];
        if (next.y > highest_mm && next.y > state.hand_mm.y) {
            // The rim is not there yet. If it can rise no higher, the hands move on sideways.
            const dvec2 way = next - state.hand_mm;
            const double part = std::clamp((highest_mm - state.hand_mm.y) / way.y, 0.0, 1.0);
            const double aside = state.is_spent ? way.x : part * way.x;
            state.hand_mm.x += std::clamp(aside, -left, left);
            state.hand_mm.y += std::min(part * way.y, left);
            if (!state.is_spent || trail.count < 2 || std::fabs(aside) > left) break;
            left -= std::fabs(aside);
            drop_oldest(trail);
            continue;
        }
        const double way = distance(next, state.hand_mm);
        const double step = std::min(way, left);
        if (way > 1e-9) {
            const dvec2 move = (next - state.hand_mm) * (step / way);
            state.hand_mm += move;
            state.travel_mm += step;
            const double fraction = relaxed_fraction(std::min(step / 4.0, 50.0));
            state.heading += fraction * (move.y / std::max(step, 1e-9) - state.heading);
            state.offset_mm -= state.offset_mm * relaxed_fraction(std::min(step / state.offset_way_mm, 50.0));
        }
        left -= step;
        if (step >= way) drop_oldest(trail);
    }
}

double wall_target(const GripState& state, const Rings& rings) noexcept {
    const double top = rings.top_mm();
    const double fraction = std::clamp(state.hand_mm.y / std::max(top, 1.0), 0.0, 1.0);
    double target = state.hand_mm.x + state.offset_mm - state.rests_mm;
    target = std::max(target, kNarrowsTo * landed_outer(state, fraction));
    // A touch that lands on the top does not press the side in.
    if (state.landed_mm.y > state.landed_top_mm - 1.0 && state.landed_mm.x < landed_outer(state, 1.0) - 5.0)
        target = std::max(target, landed_outer(state, fraction));
    return std::min(target, kWidestGripMm);
}

void decide(GripState& state, const Rings& rings) noexcept {
    if (state.grip == Grip::kAsking) {
        const double down = state.landed_mm.y - state.finger_mm.y;
        const double aside = std::fabs(state.finger_mm.x - state.landed_mm.x);
        const double way = std::sqrt(down * down + aside * aside);
        if (way > 4.0)
            state.grip = down > 0.6 * aside ? Grip::kOpen : Grip::kWall;
        else if (state.still_s > 0.35)
            state.grip = Grip::kOpen;
    }
    if (state.grip == Grip::kRim &&
        (std::fabs(state.finger_mm.x - state.landed_mm.x) > 6.0 || state.finger_mm.y > rings.top_mm() + 4.0))
        state.grip = Grip::kWall;
    // Thumbs that rise past the rim again have fingers outside, and pull.
    if (state.grip == Grip::kOpen && is_hollow(rings) && state.bottom_mm <= kFloorMm + 1.0 &&
        state.finger_mm.y > rings.top_mm() && state.finger_mm.y > state.landed_mm.y) {
        state.grip = Grip::kWall;
        state.offset_mm = outer_face_mm(rings, rings.top_mm()) - state.finger_mm.x;
        state.offset_way_mm = 1e6;
        state.hand_mm = {state.finger_mm.x, rings.top_mm()};
        state.heading = 1.0;
        state.travel_mm = kStartsAfterMm;
        state.trail.count = 0;
    }
    const bool works_wall = state.grip == Grip::kWall && state.travel_mm > kStartsAfterMm;
    if (works_wall && !is_hollow(rings) && !state.opens_by_itself) {
        const bool asks = state.hand_mm.x + state.offset_mm > outer_face_mm(rings, state.hand_mm.y) + 8.0 ||
                          state.finger_mm.y > rings.top_mm() + 8.0;
        state.wants_s = asks ? state.wants_s + kGripStepS : 0.0;
        if (state.wants_s > 0.12) {
            state.opens_by_itself = true;
            state.bottom_mm = rings.top_mm();
            state.bore_mm = kThumbsMm;
        }
    }
}

GripOutline outline_of(const Rings& rings, double y) noexcept {
    const int last = rings.count - 1;
    if (last < 0) return {};
    return {.height_mm = rings.top_mm(),
            .floor_mm = rings.floor_mm(),
            .outer_mm = outer_face_mm(rings, y),
            .rim_outer_mm = rings.outer_mm[Rings::at(last)],
            .rim_inner_mm = rings.inner_mm[Rings::at(last)]};
}

void let_go(GripState& state) noexcept {
    if (state.presses) state = {};
}

GripReport report_of(const GripState& state, const dvec2& finger) noexcept {
    if (!state.presses) return {.finger_mm = finger};
    return {.grip = state.grip,
            .guard = state.shown_guard,
            .pulls = state.pulls,
            .opens_by_itself = state.opens_by_itself,
            .hand_mm = {state.side * state.hand_mm.x, state.hand_mm.y},
            .finger_mm = finger,
            .low_mm = state.low_mm,
            .high_mm = state.high_mm};
}

}  // namespace onggi::clay::studio
