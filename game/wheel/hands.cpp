#include "game/wheel/hands.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "game/clay/studio/grip.h"

namespace onggi::wheel {
namespace {

using clay::studio::Grip;
using tool::Side;

constexpr double kHoversMm = 14.0;         // distance from the clay
constexpr double kAboveWheelMm = 14.0;     // a palm's edge
constexpr double kTipsBelowRimMm = 3.0;    // place of finger tips that hold a rim
constexpr double kTipsAboveFloorMm = 8.0;  // inside
constexpr double kThumbMm = 8.0;           // from the middle of the thumbs to their tips
constexpr double kOpensWithin =
    0.3;  // fraction of the radius: distance of the thumbs from the axis over solid clay
constexpr double kLeansOut = 0.25;  // fraction of the depth: outward reach of a hand below a neck
constexpr double kAsideMm = 205.0;  // a finger farther out is outside the picture

using Hands = std::array<DrawnHand, 2>;

// The input for placing the hands of a finger.
struct Guide {
    const pot::Pot& shape;
    double side;    // side of the axis on which the hands work
    dvec2 at_mm;    // the hands' distance and height
    double gap_mm;  // distance to the clay
    double radius_mm;
    bool works;
};

// The centre of a hand's ball at its contact, on the side from which it comes.
dvec3 ball_at(const Guide& guide, Side side, double distance_mm, double y_mm) {
    const double gone_mm = guide.radius_mm + guide.gap_mm;
    switch (side) {
        case Side::kIn:
            return {guide.side * (distance_mm - gone_mm), y_mm, 0.0};
        case Side::kTop:
            return {guide.side * distance_mm, y_mm + gone_mm, 0.0};
        case Side::kFree:
        case Side::kOut:
            break;
    }
    return {guide.side * (distance_mm + gone_mm), y_mm, 0.0};
}

void put(DrawnHand& hand, const Guide& guide, Side side, const dvec3& ball_mm) {
    hand.position_mm = ball_mm;
    hand.radius_mm = guide.radius_mm;
    hand.side = side;
    hand.shown = true;
    hand.guided = true;
    hand.touching = guide.works;
}

double on_wall(const Guide& guide) {
    const double top_mm = std::max(kAboveWheelMm, guide.shape.height_mm - kTipsBelowRimMm);
    return std::clamp(guide.at_mm.y, kAboveWheelMm, top_mm);
}

// The outward reach of fingers inside at that height: to the wall, or as far as an arm through the narrower
// opening above allows. Behind a shoulder a missing contact is invisible, but fingers through it would be
// visible.
double reach_mm(const pot::Pot& shape, double y_mm) {
    double reach = wall_at(shape, y_mm).inner_mm;
    const auto& inner = shape.inner_mm;
    const auto& tops = shape.top_mm;
    for (std::size_t ring = 0; ring < tops.size(); ++ring) {
        const double above_mm = double{tops[ring]} - y_mm;
        if (above_mm > 0.0) reach = std::min(reach, double{inner[ring]} + kLeansOut * above_mm);
    }
    return reach;
}

// A palm on the outer face and, while it works, fingers behind the wall or a second palm across the lump.
void hold_wall(Hands& hands, const Guide& guide) {
    const double y_mm = on_wall(guide);
    const pot::Wall wall = wall_at(guide.shape, y_mm);
    const double out_mm = guide.works ? wall.outer_mm : std::max(wall.outer_mm, guide.at_mm.x - guide.gap_mm);
    put(hands[0], guide, Side::kOut, ball_at(guide, Side::kOut, out_mm, y_mm));
    if (!guide.works) return;
    if (wall.inner_mm > 0.0) {
        const double in_y_mm = std::max(y_mm, guide.shape.floor_mm + kTipsAboveFloorMm);
        put(hands[1], guide, Side::kIn, ball_at(guide, Side::kIn, reach_mm(guide.shape, in_y_mm), in_y_mm));
    } else if (is_solid(guide.shape)) {
        Guide across = guide;
        across.side = -guide.side;
        put(hands[1], across, Side::kOut, ball_at(across, Side::kOut, wall.outer_mm, y_mm));
    }
}

void reach_inside(Hands& hands, const Guide& guide) {
    if (!guide.works) {
        // Above the mouth, so that the hand goes straight down.
        Guide above = guide;
        above.gap_mm = 0.0;
        const double inner_mm = std::max(rim_of(guide.shape).inner_mm - guide.gap_mm, guide.radius_mm);
        put(hands[1], above, Side::kIn,
            ball_at(above, Side::kIn, inner_mm, guide.shape.height_mm + guide.gap_mm));
        hands[0].shown = false;
        return;
    }
    const double y_mm = std::max(on_wall(guide), guide.shape.floor_mm + kTipsAboveFloorMm);
    const double held_y_mm = std::min(y_mm, guide.shape.height_mm - kTipsBelowRimMm);
    const pot::Wall wall = wall_at(guide.shape, held_y_mm);
    put(hands[1], guide, Side::kIn, ball_at(guide, Side::kIn, reach_mm(guide.shape, held_y_mm), y_mm));
    put(hands[0], guide, Side::kOut, ball_at(guide, Side::kOut, wall.outer_mm, y_mm));
}

void open(Hands& hands, const Guide& guide) {
    const double top_mm = guide.shape.height_mm;
    const double widest_mm = kOpensWithin * rim_of(guide.shape).outer_mm;
    const double tips_mm = guide.works ? std::min(guide.at_mm.y - kThumbMm, top_mm) : top_mm;
    const double x_mm = guide.works ? guide.at_mm.x : std::min(guide.at_mm.x, widest_mm);
    put(hands[0], guide, Side::kTop, ball_at(guide, Side::kTop, x_mm, tips_mm));
    hands[0].digs = true;
}

void press_rim(Hands& hands, const Guide& guide) {
    const pot::Wall rim = rim_of(guide.shape);
    put(hands[0], guide, Side::kTop,
        ball_at(guide, Side::kTop, 0.5 * (rim.outer_mm + rim.inner_mm), guide.shape.height_mm));
}

// Off the clay, the hands hover at the finger's place beside the pot.
void hang_about(Hands& hands, const Guide& guide) {
    const double y_mm = std::max(guide.at_mm.y, kAboveWheelMm);
    const double widest_mm = [&] {
        const auto& outer = guide.shape.outer_mm;
        return outer.empty() ? 0.0 : double{*std::max_element(outer.begin(), outer.end())};
    }();
    const double x_mm = std::min(std::max(guide.at_mm.x, widest_mm), std::max(kAsideMm, widest_mm));
    put(hands[0], guide, Side::kOut, ball_at(guide, Side::kOut, x_mm, y_mm));
}

// A second finger on the clay: the other hand is where it is.
void put_second(Hands& hands, const Guide& first, const clay::studio::GripReport& report) {
    DrawnHand& hand = report.grip == Grip::kInside && !report.second_is_inside ? hands[0] : hands[1];
    Guide guide = first;
    guide.side = std::signbit(report.second_mm.x) ? -1.0 : 1.0;
    guide.at_mm = {std::abs(report.second_mm.x), report.second_mm.y};
    double y_mm = on_wall(guide);
    if (report.second_is_inside) y_mm = std::max(y_mm, guide.shape.floor_mm + kTipsAboveFloorMm);
    const Side side = report.second_is_inside ? Side::kIn : Side::kOut;
    const double at_mm =
        report.second_is_inside ? reach_mm(guide.shape, y_mm) : wall_at(guide.shape, y_mm).outer_mm;
    put(hand, guide, side, ball_at(guide, side, at_mm, y_mm));
}

// The hands of a grip, both on the clay or over it.
void hold(Hands& hands, const Guide& guide, Grip grip) {
    switch (grip) {
        case Grip::kNone:
            return hang_about(hands, guide);
        case Grip::kAsking:
        case Grip::kOpen:
            return open(hands, guide);
        case Grip::kWall:
            return hold_wall(hands, guide);
        case Grip::kInside:
            return reach_inside(hands, guide);
        case Grip::kRim:
            return press_rim(hands, guide);
    }
}

// The outline that a finger at that height meets.
clay::studio::GripOutline grip_outline(const pot::Pot& shape, double y_mm) {
    constexpr double kWithinMm = 0.5;
    const pot::Wall rim = rim_of(shape);
    return {.height_mm = shape.height_mm,
            .floor_mm = is_solid(shape) ? shape.height_mm : shape.floor_mm,
            .outer_mm =
                wall_at(shape, std::clamp(y_mm, 0.0, std::max(0.0, shape.height_mm - kWithinMm))).outer_mm,
            .rim_outer_mm = rim.outer_mm,
            .rim_inner_mm = rim.inner_mm};
}

// Both hands of a finger.
void guide_hands(Hands& hands, const haptic::Snapshot& snapshot) {
    const pot::Pot& shape = *snapshot.pot;
    const clay::studio::GripReport& report = snapshot.result.grip;
    const bool presses = snapshot.tool.pressing;
    const bool works = presses && report.grip != Grip::kNone;
    const dvec2 finger_mm(snapshot.tool.position_mm);
    const dvec2 at_mm = works ? report.hand_mm : finger_mm;
    const Guide guide{.shape = shape,
                      .side = std::signbit(at_mm.x) ? -1.0 : 1.0,
                      .at_mm = {std::abs(at_mm.x), at_mm.y},
                      .gap_mm = presses ? 0.0 : kHoversMm,
                      .radius_mm = snapshot.tool.radius_mm,
                      .works = works};
    hands[0].digs = hands[1].digs = false;
    hands[1].shown = false;
    hands[1].guided = true;
    // A tool is always on the outer face, whichever side the finger comes from.
    const bool holds_tool = hands[0].tool != tool::Tool::kHand;
    const Grip grip = works        ? report.grip
                      : holds_tool ? Grip::kWall
                                   : clay::studio::grip_of_touch(grip_outline(shape, finger_mm.y), finger_mm);
    hold(hands, guide, grip);
    if (works && report.has_second) put_second(hands, guide, report);
}

// Slope dR/dy of a face, over a span that averages out the throwing rings.
double lean_at(const pot::Pot& pot, std::span<const float> face, double height_mm) {
    constexpr double kSpanMm = 9.0;
    if (face.empty()) return 0.0;
    const auto top_of = [&](std::size_t ring) {
        if (pot.top_mm.size() == pot.outer_mm.size()) return double{pot.top_mm[ring]};
        return pot.height_mm * (static_cast<double>(ring) + 1.0) / static_cast<double>(pot.outer_mm.size());
    };
    const std::size_t below = ring_at(pot, height_mm - kSpanMm);
    const std::size_t above = ring_at(pot, height_mm + kSpanMm);
    const double rise = top_of(above) - top_of(below);
    return rise > 1.0 ? (double{face[above]} - double{face[below]}) / rise : 0.0;
}

}  // namespace

void meet(DrawnHand& hand, const pot::Pot& pot) {
    // A fired pot hides the hands. Trimming works on dry clay, so the trimmer stays.
    hand.shown = hand.shown && (pot.stage == clay::Firing::kWet || hand.tool == tool::Tool::kTrimmer);
    hand.wall_lean = lean_at(pot, hand.side == Side::kIn ? pot.inner_mm : pot.outer_mm, hand.position_mm.y);
    hand.mouth_radius_mm = pot.inner_mm.empty() ? 0.0 : double{pot.inner_mm.back()};
    hand.below_rim_mm = pot.height_mm - hand.position_mm.y;
}

Hands hands_of(const haptic::Snapshot& snapshot) {
    const haptic::TickResult& result = snapshot.result;
    const tool::ToolState& told = snapshot.tool;
    const bool assists = result.has_second && !told.second.present;  // with the first hand's size
    Hands hands{
        DrawnHand{.position_mm = told.position_mm,
                  .radius_mm = snapshot.tool.radius_mm,
                  .tool = told.tool,
                  .side = result.side,
                  .touching = result.forces.contacts > 0},
        DrawnHand{.position_mm = result.has_second ? result.second_position_mm : told.second.position_mm,
                  .radius_mm = assists ? told.radius_mm : told.second.radius_mm,
                  .tool = assists ? tool::Tool::kHand : told.second.tool,
                  .side = result.second_side,
                  .shown = result.has_second || told.second.present,
                  .touching = result.second_forces.contacts > 0,
                  .is_second = true}};
    if (snapshot.tool.guided) guide_hands(hands, snapshot);
    return hands;
}

}  // namespace onggi::wheel
