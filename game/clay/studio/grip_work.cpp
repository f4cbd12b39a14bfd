#include "game/clay/studio/grip_work.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/clay/studio/load.h"
#include "game/clay/studio/spare_clay.h"
#include "game/clay/studio/strength.h"

namespace onggi::clay::studio {

// The path of the hands behind the finger, and the choice of their grip.

namespace {

// Smoothing time: a pointer reports only sixty times a second.
constexpr double kFingerS = 0.025;
constexpr double kTrailMm = 0.5;
constexpr double kHandMmS = 260.0;
constexpr double kErrorSlowsFromMm = 4.0;
constexpr double kErrorSlowsOverMm = 10.0;
constexpr double kSlowest = 0.12;
constexpr double kStillMmS = 12.0;  // a slower finger counts as lying still

// Fractions of the radius: so far inside the outline, a finger is on the face. Lower down it may mean the
// foot.
constexpr double kOnFace = 0.3;
constexpr double kOnFoot = 0.6;
constexpr double kFootMm = 15.0;
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

// The fraction of a step that relaxes in tau_s.
double relaxed(double tau_s) noexcept {
    return relaxed_fraction(kGripStepS / tau_s);
}

bool is_hollow(const Rings& rings) noexcept {
    return rings.top_mm() - rings.floor_mm() > kHollowMm;
}

// Inner radius at that height, or right above the floor.
double inner_face_mm(const Rings& rings, double y) noexcept {
    return rings.inner_mm[at(rings.ring_at(std::max(y, std::min(rings.floor_mm() + 0.5, rings.top_mm()))))];
}

// Input of grip_of_touch() from these rings.
GripOutline outline_of(const Rings& rings, double y) noexcept {
    const int last = rings.count - 1;
    if (last < 0) return {};
    return {.height_mm = rings.top_mm(),
            .floor_mm = rings.floor_mm(),
            .outer_mm = outer_face_mm(rings, y),
            .rim_outer_mm = rings.outer_mm[Rings::at(last)],
            .rim_inner_mm = rings.inner_mm[Rings::at(last)]};
}

// Starts a touch at (x, y).
void land(GripState& state, const Rings& rings, const dvec2& finger, bool wide) noexcept {
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
    // On the face of a hollow pot, a finger moves the wall behind it without drawing it to itself.
    const double on_face = finger.y < kFootMm ? kOnFoot : kOnFace;
    if (wide && is_hollow(rings) && state.offset_mm > on_face * wall) state.offset_way_mm = 1e6;
    state.bottom_mm = is_hollow(rings) ? rings.floor_mm() : top;
    state.bore_mm = kThumbsMm;
    if (state.grip == Grip::kOpen && is_hollow(rings)) {
        const int above = rings.ring_at(std::min(rings.floor_mm() + kThumbsMm, top));
        state.bore_mm = std::max(kThumbsMm, rings.inner_mm[Rings::at(above)]);
    }
}

// Whether a finger that began off the clay has come to it.
bool is_at_clay(const Rings& rings, const dvec2& finger) noexcept {
    constexpr double kNearMm = 6.0;
    return finger.y < rings.top_mm() + kNearMm &&
           std::fabs(finger.x) < outer_face_mm(rings, finger.y) + kNearMm;
}

// Smooths the finger by one step and extends the trail.
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

// Moves the hands along the trail, slower while the wall is far from its target (error_mm). They wait at
// highest_mm.
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

// Target radius of the wall's outer face at the hands' height.
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

// Changes the grip if the motion so far calls for another.
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

}  // namespace

void let_go(GripState& state) noexcept {
    if (state.presses) state = {};
}

GripReport report_of(const GripState& state, const GripFingers& fingers) noexcept {
    const dvec2& finger = fingers.first_mm;
    if (!state.presses) return {.finger_mm = finger};
    return {.grip = state.grip,
            .guard = state.shown_guard,
            .pulls = state.pulls,
            .opens_by_itself = state.opens_by_itself,
            .hand_mm = {state.side * state.hand_mm.x, state.hand_mm.y},
            .finger_mm = finger,
            .low_mm = state.low_mm,
            .high_mm = state.high_mm,
            .has_second = state.second.presses,
            .second_is_inside = state.second.is_inside,
            .second_mm = fingers.second_mm.value_or(finger)};
}

// The moves of the hands on the clay.

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
constexpr double kLowestWallMm = 46.0;  // lower clay is not moved outward
constexpr double kWidestFootMm = 68.0;

// DISH: a kilogram may become 25 mm high and 240 mm wide.
constexpr double kLowestDishMm = 24.0;
constexpr double kDishFootMm = 105.0;
constexpr double kDishFromMm = 80.0;  // the foot widens from this height
constexpr double kDishToMm = 50.0;    // to this
constexpr double kFlattest = 4.0;     // a flatter way of the finger is sideways

// The rim.
constexpr double kCatchBelowMm = 3.0;
constexpr double kLoseBelowMm = 12.0;
constexpr double kPullS = 0.06;
constexpr double kPullMmS = 60.0;
constexpr double kTallestPullMm = 225.0;
constexpr double kStrainPerS = 2.0;

// The second hand.
constexpr double kSecondReachMm = 40.0;  // a finger farther from the clay is no hand
constexpr double kOppositeMm = 40.0;     // hands farther apart in height do not hold the same wall
constexpr double kOppositeFadeMm = 15.0;
constexpr double kPinchReachMm = 14.0;
constexpr double kSqueezeMmS = 12.0;  // chosen: a wall of 12 mm takes as long as a slow pull
constexpr double kTakes = 0.5;        // of what a wall could yield, in a pass of the hands
constexpr double kMostSpare = 1.5;    // a very thick wall yields no more
constexpr double kTwoCreepMmS = 1.0;  // two hands have had more when their part has run out

// OPEN.
constexpr double kThickFloorMm = 12.5;

// PULL.
constexpr double kTouchEndsMm = 12.0;  // over this way a touch's part of the rise runs out
constexpr double kCreepsMmS = 8.0;     // and then goes on so slowly
constexpr double kCarryUpS = 0.15;     // relaxation of clay that is thicker than the rest

// The numbers in which the manners differ.
struct MannerNumbers {
    double opening;      // fraction of the radius to which an opening widens by itself
    double outward;      // fraction of an opening's clay that goes to the outer face
    double sinks_mm_s;   // of thumbs that lie still
    double moving_mm_s;  // of thumbs that move
    double widens_mm_s;  // of thumbs that lie still
    double steepest;     // bounds of |dR/dy|
    double steepest_at_foot;
    double lowest_fade_mm;  // over this height, moving outward ends
    double rim_mm_s;        // of a rim that is pressed down
    double rim_fraction;    // of the depth, a touch
};
constexpr MannerNumbers kNarrow{0.45, 0.3, 28.0, 0.0, 15.0, 1.4, 0.8, 10.0, 8.0, 0.08};
constexpr MannerNumbers kWide{0.7, 0.5, 36.0, 12.0, 60.0, 1.6, 1.0, 4.0, 12.0, 0.1};

const MannerNumbers& numbers_of(const GripClimate& climate) {
    return climate.wide ? kWide : kNarrow;
}

double opening_mm(const Rings& rings, const MannerNumbers& manner) {
    return manner.opening * outer_face_mm(rings, 0.5 * rings.top_mm());
}

// Fraction of a thinning or widening move that the load allows.
double load_fraction(const GripClimate& climate) {
    return std::clamp((kGuardedLoad - climate.load_index) / kGuardWidth, 0.0, 1.0);
}

Bore bore_of(const GripState& state, const GripClimate& climate) {
    return {.bottom_mm = state.bottom_mm, .radius_mm = state.bore_mm, .outward = numbers_of(climate).outward};
}

// Lowers the bottom of the bore; once there, widens the bore. Returns true once both are complete.
bool deepen(GripState& state, const Rings& rings, double down_mm, double widen_mm, double widest_mm) {
    const double floor = std::min(kFloorMm, state.bottom_mm);
    state.bottom_mm = std::max(state.bottom_mm - down_mm, floor);
    const bool is_deep = state.bottom_mm <= floor + 6.0;
    if (is_deep) state.bore_mm = std::min(state.bore_mm + widen_mm, std::max(widest_mm, state.bore_mm));
    return state.bottom_mm <= floor && state.bore_mm >= widest_mm && rings.floor_mm() <= floor + 4.0;
}

// Distance between the fingers on both faces, across the wall.
double apart_mm(const GripState& state, const dvec2& second) {
    const double inward = state.finger_mm.x - std::fabs(second.x);
    return state.second.is_inside ? inward : -inward;
}

// Lands and lifts the second finger.
void follow_second(GripState& state, const Rings& rings, const GripFingers& fingers, bool wide) {
    SecondGrip& second = state.second;
    if (!fingers.second_mm || !wide) {
        second = {};
        return;
    }
    const dvec2& finger = *fingers.second_mm;
    const double top = rings.top_mm();
    const double y = std::clamp(finger.y, 0.0, top);
    const double r = std::fabs(finger.x);
    const double outer = outer_face_mm(rings, y);
    if (second.presses || finger.y > top + kSecondReachMm || r > outer + kSecondReachMm) return;
    const bool hollow = is_hollow(rings);
    const GripOutline outline = outline_of(rings, finger.y);
    if (!hollow && grip_of_touch(outline, finger) != Grip::kWall) return;  // over solid clay there is no wall
    const double inner = hollow ? inner_face_mm(rings, y) : 0.0;
    second.presses = true;
    second.is_inside = hollow && r < 0.5 * (outer + inner);
    second.offset_mm = (second.is_inside ? inner : outer) - r;
    second.between_mm = outer - inner - apart_mm(state, finger);
}

void hold(GripState& state, double low, double high) {
    state.low_mm = low;
    state.high_mm = high;
}

Changed open_step(GripState& state, Rings& rings, const GripClimate& climate) {
    const double r = state.finger_mm.x;
    const double down = std::max(state.landed_mm.y - state.finger_mm.y, 0.0);
    const double aside = std::fabs(r - state.landed_mm.x);
    // One and a half times as deep as the finger went; also sinks by itself under a finger that lies still.
    const double wanted = state.landed_top_mm - 1.5 * down;
    double sink = std::clamp(state.bottom_mm - wanted, 0.0, 45.0 * kGripStepS);
    const bool lies = state.still_s > 0.15;
    const MannerNumbers& manner = numbers_of(climate);
    sink = std::max(sink, (lies ? manner.sinks_mm_s : manner.moving_mm_s) * kGripStepS);
    double widest = state.bore_mm;
    double widen = 0.0;
    if (aside > 4.0) {
        widest = std::min(kThumbsMm + aside, 60.0 * climate.size);
        widen = 55.0 * kGripStepS;
    }
    if (climate.wide || (lies && !(aside > 4.0))) {
        widest = std::max(widest, opening_mm(rings, manner));
        widen = std::max(widen, manner.widens_mm_s * kGripStepS);
    }
    const double grant = load_fraction(climate) * climate.softness;
    deepen(state, rings, sink * climate.softness, widen * grant, widest);
    state.hand_mm = {std::max(state.bore_mm - kThumbsMm, 0.0), state.bottom_mm + 0.5 * kThumbsMm};
    state.press_mm = 0.5 + (sink + widen) * 0.1 / kGripStepS;
    hold(state, state.bottom_mm, rings.top_mm());
    return open_bore(rings, bore_of(state, climate));
}

// Solid clay got a touch that needs hollow clay: the other hand opens the clay.
Changed open_by_itself(GripState& state, Rings& rings, const GripClimate& climate) {
    // Who draws an outline needs its clay in the wall: not as wide as thumbs go.
    const double widest = opening_mm(rings, kNarrow);
    state.bore_mm = std::max(state.bore_mm, kThumbsMm);
    const bool is_open = deepen(state, rings, 60.0 * kGripStepS * climate.softness,
                                30.0 * kGripStepS * climate.softness, widest);
    if (is_open) {
        state.opens_by_itself = false;
        state.landed_top_mm = rings.top_mm();
    }
    return open_bore(rings, bore_of(state, climate));
}

// 1 where the rim is as wide as that of a dish, or the finger leads there; 0 for narrow pots and for
// Manner::kNarrow.
double dish_fraction(const GripState& state, const Rings& rings, const GripClimate& climate) {
    constexpr double kFromMm = 65.0;
    constexpr double kToMm = 85.0;
    if (!climate.wide) return 0.0;
    const double widest = std::max(outer_face_mm(rings, rings.top_mm()), state.finger_mm.x);
    return std::clamp((widest - kFromMm) / (kToMm - kFromMm), 0.0, 1.0);
}

void place(Rings& rings, const Changed& changed) {
    if (changed.size() > 0) rings.place(changed.first, rings.count);
}

// A wall that a hand moves at height_mm: how far, and where the face that it moves is now.
struct Move {
    double height_mm = 0.0;
    double error_mm = 0.0;
    double face_mm = 0.0;   // the outer face
    double wants_mm = 0.0;  // where the hand wants it
    double heading = 0.0;   // of the hand
};

// Moves a wall towards a hand, within the bounds of every hand.
Changed move_wall_to(GripState& state, Rings& rings, GripSpace& space, const Move& move,
                     const GripClimate& climate) {
    const double top = rings.top_mm();
    const double y = move.height_mm;
    const bool hollow = is_hollow(rings);
    const MannerNumbers& manner = numbers_of(climate);
    const double error = move.error_mm;
    double step = error * std::fabs(error) / (std::fabs(error) + 2.0) * relaxed(kWallS) * climate.push;
    const double inward = (hollow ? kInwardMmS : kConeMmS) * kGripStepS * climate.softness;
    step = std::clamp(step, -inward, kOutwardMmS * kGripStepS * climate.softness);
    const double wanted = step;
    if (step > 0.0) {
        step *= load_fraction(climate);
        if (wanted > 0.0 && step < 0.3 * wanted) state.guard = GripGuard::kNearLimit;
        const double lowest =
            kLowestWallMm + dish_fraction(state, rings, climate) * (kLowestDishMm - kLowestWallMm);
        const double spreads = std::clamp((top - lowest * climate.size) / manner.lowest_fade_mm, 0.0, 1.0);
        step *= spreads;
        const bool is_widest = move.face_mm > kWidestGripMm - 1.0 && move.wants_mm > move.face_mm + 3.0;
        if (climate.wide && (is_widest || (spreads < 0.3 && error > 3.0))) state.guard = GripGuard::kAsWide;
    } else {
        step *= std::clamp((std::max(state.landed_top_mm, y) + 12.0 - top) / 8.0, 0.0, 1.0);
    }
    const double ahead = std::clamp(0.26 * top + 8.0, 16.0, 42.0);
    const double up = ahead + std::max(-move.heading, 0.0) * (kBehindMm - ahead);
    const double down = ahead + std::max(move.heading, 0.0) * (kBehindMm - ahead);
    state.press_mm = std::max(state.press_mm, 0.3 + std::fabs(step) * 0.1 / kGripStepS);
    hold(state, std::max(y - down, 0.0), std::min(y + up, top));
    double widest_foot_mm = kWidestFootMm;
    double leans = 0.0;
    if (climate.wide && top < kDishFromMm * climate.size) {
        const double low = (kDishFromMm - top / climate.size) / (kDishFromMm - kDishToMm);
        widest_foot_mm += std::min(low, 1.0) * (kDishFootMm - kWidestFootMm);
        // A finger that climbs outward leans the wall as far as its own way.
        const double climbs = std::min(move.heading, 1.0);
        if (climbs > 1.0 / kFlattest) leans = std::sqrt(1.0 - climbs * climbs) / climbs;
    }
    return carry_wall(rings, space,
                      {.height_mm = y,
                       .step_mm = step,
                       .up_mm = up,
                       .down_mm = down,
                       .foot_least_mm = 28.0 * climate.size,
                       .foot_most_mm = widest_foot_mm * climate.size,
                       .steepest = std::max(manner.steepest, leans),
                       .steepest_at_foot = std::max(manner.steepest_at_foot, leans),
                       .keeps_slopes = climate.wide});
}

Changed carry_step(GripState& state, Rings& rings, GripSpace& space, const GripClimate& climate) {
    const double y = std::clamp(state.hand_mm.y, 0.0, rings.top_mm());
    Move move{.height_mm = y,
              .face_mm = outer_face_mm(rings, y),
              .wants_mm = state.hand_mm.x,
              .heading = state.heading};
    if (state.grip == Grip::kInside) {
        move.error_mm = std::max(state.hand_mm.x - inner_face_mm(rings, y), 0.0);
    } else {
        const double target = wall_target(state, rings);
        move.error_mm = target - move.face_mm;
        if (move.error_mm <= 0.0 && state.hand_mm.x + state.offset_mm < target - 3.0)
            state.guard = GripGuard::kAsNarrow;
    }
    return move_wall_to(state, rings, space, move, climate);
}

// Whether the hands are on both faces of the wall, at heights that are not far apart.
bool holds_between(const GripState& state, const Rings& rings, const GripFingers& fingers) {
    constexpr double kOnFaceMm =
        6.0;  // a first finger that landed farther inside the outline draws from inside
    const SecondGrip& second = state.second;
    if (!second.presses || !is_hollow(rings) || state.opens_by_itself) return false;
    if (std::fabs(fingers.second_mm->y - state.finger_mm.y) >= kOppositeMm) return false;
    if (second.is_inside) return state.grip == Grip::kWall;
    return state.grip == Grip::kInside || (state.grip == Grip::kWall && state.offset_mm > kOnFaceMm);
}

// What is left of a touch's part of the rise, 1 to 0. One finger takes half of what it found: what it has
// risen is at most what is left. Two hands on the wall take five sixths.
double part_left(const GripState& state, const Rings& rings, const GripFingers& fingers) {
    const double risen = rings.top_mm() - state.landed_top_mm;
    const double left = spare_rise(rings) - (holds_between(state, rings, fingers) ? risen / 5.0 : risen);
    return std::clamp(left / kTouchEndsMm, 0.0, 1.0);
}

// A hand that passes the rim upward pulls it along.
Changed pull_step(GripState& state, Rings& rings, GripSpace& space, const GripFingers& fingers,
                  const GripClimate& climate) {
    const double top = rings.top_mm();
    const double y = state.finger_mm.y;
    if (!state.pulls && state.heading > 0.2 && state.hand_mm.y > top - kCatchBelowMm) state.pulls = true;
    if (state.pulls && y < top - kLoseBelowMm) state.pulls = false;
    if (!state.pulls || !(y > top)) return {};
    const double highest = kTallestPullMm * climate.size;
    double rise = std::min((y - top) * relaxed(kPullS), kPullMmS * kGripStepS * climate.softness);
    rise = std::min(rise, highest - top) * load_fraction(climate);
    if (climate.wide) {
        const double part = part_left(state, rings, fingers);
        if (part < 0.3 && rise > 0.0) state.guard = GripGuard::kAsHigh;
        const double creeps = holds_between(state, rings, fingers) ? kTwoCreepMmS : kCreepsMmS;
        rise = std::min(rise, (part * kPullMmS + creeps) * kGripStepS * climate.softness);
    }
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

// Moving up below the rim pulls a pot with thick walls up a little, so that repeated lifting has an effect. A
// pot with thin walls keeps its height.
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

// Hands on both faces squeeze the wall between them as far as the fingers come closer, and take clay up as
// they climb past it.
Changed pinch_step(GripState& state, Rings& rings, GripSpace& space, const GripFingers& fingers,
                   double climbed_mm, const GripClimate& climate) {
    const double higher = fingers.second_mm->y - state.finger_mm.y;
    const double top = rings.top_mm();
    const double y = std::clamp(state.hand_mm.y + 0.5 * higher, std::min(rings.floor_mm() + 0.5, top), top);
    const double wall = rings.wall_mm(rings.ring_at(y));
    const double spare = std::max(wall / thinnest_mm(rings, y) - 1.0, 0.0);
    const double closer = wall - state.second.between_mm - apart_mm(state, *fingers.second_mm);
    const double thins = std::min(std::max(closer, 0.0) * relaxed(kWallS), kSqueezeMmS * kGripStepS);
    double rise =
        thins / wall * kPinchReachMm + kTakes * std::max(climbed_mm, 0.0) * std::min(spare, kMostSpare);
    rise *= std::clamp((kOppositeMm - std::fabs(higher)) / kOppositeFadeMm, 0.0, 1.0) * climate.softness;
    rise = std::min(rise, kTallestPullMm * climate.size - top) * load_fraction(climate);
    const double part = part_left(state, rings, fingers);
    if (!(rise > 0.0)) return {};
    if (part < 0.3) state.guard = GripGuard::kAsHigh;
    const double risen = pull_up(rings, space, rise * part, kStrainPerS * kGripStepS,
                                 {.height_mm = y, .reach_mm = kPinchReachMm});
    state.press_mm = std::max(state.press_mm, 0.5 + 0.1 * risen / kGripStepS);
    return risen > 0.0 ? Changed{rings.first_hollow, rings.count} : Changed{};
}

// A second hand that does not hold the wall against the first one pushes it where it is: in from outside,
// out from inside.
Changed push_step(GripState& state, Rings& rings, GripSpace& space, const GripFingers& fingers,
                  const GripClimate& climate) {
    const SecondGrip& second = state.second;
    if (!second.presses || state.opens_by_itself || holds_between(state, rings, fingers)) return {};
    const double top = rings.top_mm();
    const double y = std::clamp(fingers.second_mm->y, 0.0, top);
    Move move{.height_mm = y,
              .face_mm = outer_face_mm(rings, y),
              .wants_mm = std::fabs(fingers.second_mm->x) + second.offset_mm};
    if (second.is_inside) {
        move.error_mm = std::max(move.wants_mm - inner_face_mm(rings, y), 0.0);
    } else {
        const double narrowest = kNarrowsTo * landed_outer(state, y / std::max(top, 1.0));
        move.error_mm = std::min(std::max(move.wants_mm, narrowest) - move.face_mm, 0.0);
        if (move.wants_mm < narrowest - 3.0) state.guard = GripGuard::kAsNarrow;
    }
    if (move.error_mm == 0.0) return {};
    const double first_mm = outer_face_mm(rings, state.hand_mm.y);
    Changed changed = move_wall_to(state, rings, space, move, climate);
    place(rings, changed);
    if (is_hollow(rings)) changed = together(changed, fair_wall(rings, space, y, relaxed(0.3), relaxed(1.5)));
    place(rings, changed);
    // The first hand goes along: it does not pull the wall back, nor does it jump when this one lifts.
    if (state.grip == Grip::kWall) state.offset_mm += outer_face_mm(rings, state.hand_mm.y) - first_mm;
    return changed;
}

Changed rim_step(GripState& state, Rings& rings, const GripClimate& climate) {
    const MannerNumbers& manner = numbers_of(climate);
    const double top = rings.top_mm();
    const double lowest_over_floor_mm =
        28.0 + dish_fraction(state, rings, climate) * (kLowestDishMm - kFloorMm - 28.0);
    const double depth = top - rings.floor_mm();
    hold(state, std::max(top - 0.3 * depth, 0.0), top);
    state.press_mm = 0.4;
    const double wanted = top - state.finger_mm.y;
    if (!(wanted > 1.0) || state.heading > -0.2) return {};
    double sink = std::min(wanted, manner.rim_mm_s * kGripStepS * climate.softness);
    sink = std::min(sink, manner.rim_fraction * depth - state.sunk_mm);
    sink = std::min(sink, depth - lowest_over_floor_mm);
    if (!(sink > 0.0)) {
        state.guard = GripGuard::kAsLow;
        return {};
    }
    state.sunk_mm += sink;
    state.press_mm = 1.2;
    return press_down(rings, sink);
}

// Lowers a floor that is too thick for a pot while the hands work.
Changed lower_floor(Rings& rings, double rate_mm_s) {
    const double floor = rings.floor_mm();
    if (!is_hollow(rings) || floor <= kThickFloorMm) return {};
    const int above = rings.ring_at(std::min(floor + 4.0, rings.top_mm()));
    const double bore = std::max(rings.inner_mm[Rings::at(above)], kNarrowestBoreMm);
    return open_bore(rings, {.bottom_mm = std::max(floor - rate_mm_s * kGripStepS - 0.5, kFloorMm),
                             .radius_mm = bore,
                             .largest_strain = 0.01});
}

Changed first_stage(GripState& state, Rings& rings, GripSpace& space, const GripFingers& fingers,
                    const GripClimate& climate) {
    const dvec2& finger = fingers.first_mm;
    follow_finger(state, finger);
    state.press_mm = 0.0;
    decide(state, rings);
    if (state.grip == Grip::kOpen) return open_step(state, rings, climate);
    if (climate.wide && state.grip == Grip::kNone && is_at_clay(rings, finger))
        land(state, rings, finger, true);
    follow_second(state, rings, fingers, climate.wide);
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
    const double climbed = std::min(state.hand_mm.y, top) - std::min(before, top);
    if (holds_between(state, rings, fingers))
        return pinch_step(state, rings, space, fingers, climbed, climate);
    return pull_below(state, rings, space, climbed, climate);
}

Changed second_stage(GripState& state, Rings& rings, GripSpace& space, const GripClimate& climate) {
    if (state.grip != Grip::kWall && state.grip != Grip::kInside) return {};
    if (state.opens_by_itself) return {};
    if (state.travel_mm < kStartsAfterMm) {
        // Resting on the wall presses it in by a bounded depth.
        hold(state, std::max(state.hand_mm.y - kBehindMm, 0.0),
             std::min(state.hand_mm.y + kBehindMm, rings.top_mm()));
        state.press_mm = 0.3;
        if (state.still_s < kRestsAfterS || state.grip != Grip::kWall) return {};
        state.rests_mm = std::min(state.rests_mm + kRestMmS * climate.push * kGripStepS, kRestMm);
    }
    return carry_step(state, rings, space, climate);
}

Changed third_stage(GripState& state, Rings& rings, GripSpace& space, const GripFingers& fingers,
                    const GripClimate& climate) {
    if (state.grip == Grip::kNone || state.grip == Grip::kAsking) return {};
    const Changed changed = push_step(state, rings, space, fingers, climate);
    if (state.grip != Grip::kWall && state.grip != Grip::kInside) return changed;
    if (state.opens_by_itself || state.travel_mm < kStartsAfterMm) return changed;
    return together(changed, pull_step(state, rings, space, fingers, climate));
}

Changed fourth_stage(GripState& state, Rings& rings, GripSpace& space, const GripClimate& climate) {
    state.bears_n_mm = bearable_twist(rings, state.hand_mm.y);
    if (state.grip == Grip::kNone || state.grip == Grip::kAsking || !is_hollow(rings)) return {};
    const bool opens = state.grip == Grip::kOpen || state.opens_by_itself;
    if (opens || state.travel_mm < kStartsAfterMm) return {};
    Changed changed =
        fair_wall(rings, space, std::clamp(state.hand_mm.y, 0.0, rings.top_mm()), relaxed(0.3), relaxed(1.5));
    place(rings, changed);
    if (climate.wide && state.heading > 0.2) {
        const double y = std::clamp(state.hand_mm.y, 0.0, rings.top_mm());
        changed = together(changed, carry_up(rings, space, y, relaxed(kCarryUpS)));
        place(rings, changed);
    }
    if (state.hand_mm.y > rings.top_mm() - 20.0)
        changed = together(changed, soften_lip(rings, space, relaxed(0.6)));
    place(rings, changed);
    return together(changed, lower_floor(rings, 10.0));
}

}  // namespace

Changed work_grip(GripState& state, Rings& rings, GripSpace& space, const GripFingers& fingers,
                  const GripClimate& climate, double dt_s) noexcept {
    if (rings.count < 3) return {};
    if (!state.presses) land(state, rings, fingers.first_mm, climate.wide);
    Changed changed{};
    state.credit_s += dt_s;
    while (state.credit_s > kGripStageS - 1e-9) {
        state.credit_s -= kGripStageS;
        Changed now{};
        switch (state.stage) {
            case 0:
                now = first_stage(state, rings, space, fingers, climate);
                break;
            case 1:
                now = second_stage(state, rings, space, climate);
                break;
            case 2:
                now = third_stage(state, rings, space, fingers, climate);
                break;
            default:
                now = fourth_stage(state, rings, space, climate);
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
