#include "game/app/kiosk/presentation/snapshot_view.h"

#include <algorithm>
#include <cmath>

#include "game/app/kiosk/finger/kiosk_touch.h"

namespace onggi::app {
namespace {

using clay::studio::Grip;
using tool::Side;

constexpr double kHoversMm = 14.0;      // off the clay
constexpr double kAboveWheelMm = 14.0;  // a palm's edge
constexpr double kBelowRimMm = 3.0;     // where finger tips hold a rim
constexpr double kAboveFloorMm = 8.0;   // inside
constexpr double kThumbMm = 8.0;        // from the thumbs' middle to their tips
constexpr double kOpensWithin = 0.3;    // of the radius: so far from the axis thumbs hang over solid clay
constexpr double kLeansOut = 0.25;      // of the depth: so far a hand inside reaches out below a neck
constexpr double kAsideMm = 205.0;      // a finger farther out is out of the picture

// What both hands are given for one of them.
struct Scene {
    const pot::Pot& shape;
    double side;    // of the axis, on which the hands work
    dvec2 at_mm;    // of the hands: distance, height
    double gap_mm;  // to the clay
    double radius_mm;
    bool works;
};

// The ball that stands for a hand, at what it touches, on the side from which it comes.
dvec3 ball_at(const Scene& scene, Side side, double distance_mm, double y_mm) {
    const double gone_mm = scene.radius_mm + scene.gap_mm;
    switch (side) {
        case Side::kIn:
            return {scene.side * (distance_mm - gone_mm), y_mm, 0.0};
        case Side::kTop:
            return {scene.side * distance_mm, y_mm + gone_mm, 0.0};
        case Side::kFree:
        case Side::kOut:
            break;
    }
    return {scene.side * (distance_mm + gone_mm), y_mm, 0.0};
}

void put(wheel::HandView& hand, const Scene& scene, Side side, const dvec3& ball_mm) {
    hand.position_mm = ball_mm;
    hand.radius_mm = scene.radius_mm;
    hand.side = side;
    hand.shown = true;
    hand.guided = true;
    hand.touching = scene.works;
}

double on_wall(const Scene& scene) {
    const double top_mm = std::max(kAboveWheelMm, scene.shape.height_mm - kBelowRimMm);
    return std::clamp(scene.at_mm.y, kAboveWheelMm, top_mm);
}

// How far out fingers reach inside at that height: to the wall, or as far as an arm can that comes down
// through what is narrower above. Behind a shoulder nobody sees whether they touch; through it everybody
// would.
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

// A palm on the outer face; and, while it works, fingers behind the wall or a second palm across the lump.
void hold_wall(wheel::WheelView& shown, const Scene& scene) {
    const double y_mm = on_wall(scene);
    const Wall wall = wall_at(scene.shape, y_mm);
    const double out_mm = scene.works ? wall.outer_mm : std::max(wall.outer_mm, scene.at_mm.x - scene.gap_mm);
    put(shown.hand, scene, Side::kOut, ball_at(scene, Side::kOut, out_mm, y_mm));
    if (!scene.works) return;
    if (wall.inner_mm > 0.0) {
        const double in_y_mm = std::max(y_mm, scene.shape.floor_mm + kAboveFloorMm);
        put(shown.second_hand, scene, Side::kIn,
            ball_at(scene, Side::kIn, reach_mm(scene.shape, in_y_mm), in_y_mm));
    } else if (is_solid(scene.shape)) {
        Scene across = scene;
        across.side = -scene.side;
        put(shown.second_hand, across, Side::kOut, ball_at(across, Side::kOut, wall.outer_mm, y_mm));
    }
}

void reach_inside(wheel::WheelView& shown, const Scene& scene) {
    if (!scene.works) {
        // Over the mouth, so that it goes straight down.
        Scene above = scene;
        above.gap_mm = 0.0;
        const double inner_mm = std::max(rim_of(scene.shape).inner_mm - scene.gap_mm, scene.radius_mm);
        put(shown.second_hand, above, Side::kIn,
            ball_at(above, Side::kIn, inner_mm, scene.shape.height_mm + scene.gap_mm));
        shown.hand.shown = false;
        return;
    }
    const double y_mm = std::max(on_wall(scene), scene.shape.floor_mm + kAboveFloorMm);
    const double held_y_mm = std::min(y_mm, scene.shape.height_mm - kBelowRimMm);
    const Wall wall = wall_at(scene.shape, held_y_mm);
    put(shown.second_hand, scene, Side::kIn,
        ball_at(scene, Side::kIn, reach_mm(scene.shape, held_y_mm), y_mm));
    put(shown.hand, scene, Side::kOut, ball_at(scene, Side::kOut, wall.outer_mm, y_mm));
}

void open(wheel::WheelView& shown, const Scene& scene) {
    const double top_mm = scene.shape.height_mm;
    const double widest_mm = kOpensWithin * rim_of(scene.shape).outer_mm;
    const double tips_mm = scene.works ? std::min(scene.at_mm.y - kThumbMm, top_mm) : top_mm;
    const double x_mm = scene.works ? scene.at_mm.x : std::min(scene.at_mm.x, widest_mm);
    put(shown.hand, scene, Side::kTop, ball_at(scene, Side::kTop, x_mm, tips_mm));
    shown.hand.digs = true;
}

void press_rim(wheel::WheelView& shown, const Scene& scene) {
    const Wall rim = rim_of(scene.shape);
    put(shown.hand, scene, Side::kTop,
        ball_at(scene, Side::kTop, 0.5 * (rim.outer_mm + rim.inner_mm), scene.shape.height_mm));
}

// Off the clay: where the finger is, beside the pot.
void hang_about(wheel::WheelView& shown, const Scene& scene) {
    const double y_mm = std::max(scene.at_mm.y, kAboveWheelMm);
    const double widest_mm = [&] {
        const auto& outer = scene.shape.outer_mm;
        return outer.empty() ? 0.0 : double{*std::max_element(outer.begin(), outer.end())};
    }();
    const double x_mm = std::min(std::max(scene.at_mm.x, widest_mm), std::max(kAsideMm, widest_mm));
    put(shown.hand, scene, Side::kOut, ball_at(scene, Side::kOut, x_mm, y_mm));
}

}  // namespace

clay::studio::GripOutline grip_outline(const pot::Pot& shape, double y_mm) {
    constexpr double kWithinMm = 0.5;
    const Wall rim = rim_of(shape);
    return {.height_mm = shape.height_mm,
            .floor_mm = is_solid(shape) ? shape.height_mm : shape.floor_mm,
            .outer_mm =
                wall_at(shape, std::clamp(y_mm, 0.0, std::max(0.0, shape.height_mm - kWithinMm))).outer_mm,
            .rim_outer_mm = rim.outer_mm,
            .rim_inner_mm = rim.inner_mm};
}

void show_guided_hands(wheel::WheelView& shown, const haptic::Snapshot& snapshot) {
    const pot::Pot& shape = *snapshot.pot;
    const clay::studio::GripReport& report = snapshot.result.grip;
    const bool presses = snapshot.tool.pressing;
    const bool works = presses && report.grip != Grip::kNone;
    const dvec2 finger_mm(snapshot.tool.position_mm);
    const dvec2 at_mm = works ? report.hand_mm : finger_mm;
    const Scene scene{.shape = shape,
                      .side = std::signbit(at_mm.x) ? -1.0 : 1.0,
                      .at_mm = {std::abs(at_mm.x), at_mm.y},
                      .gap_mm = presses ? 0.0 : kHoversMm,
                      .radius_mm = snapshot.tool.radius_mm,
                      .works = works};
    shown.hand.digs = shown.second_hand.digs = false;
    shown.second_hand.shown = false;
    shown.second_hand.guided = true;
    // A tool lies on the wall wherever the finger comes from.
    const bool holds_tool = shown.hand.tool != tool::Tool::kHand;
    const Grip grip = works        ? report.grip
                      : holds_tool ? Grip::kWall
                                   : clay::studio::grip_of_touch(grip_outline(shape, finger_mm.y), finger_mm);
    switch (grip) {
        case Grip::kNone:
            return hang_about(shown, scene);
        case Grip::kAsking:
        case Grip::kOpen:
            return open(shown, scene);
        case Grip::kWall:
            return hold_wall(shown, scene);
        case Grip::kInside:
            return reach_inside(shown, scene);
        case Grip::kRim:
            return press_rim(shown, scene);
    }
}

wheel::WheelView wheel_view(const haptic::Snapshot& snapshot) {
    const haptic::TickResult& result = snapshot.result;
    const tool::ToolState& told = snapshot.tool;
    wheel::WheelView shown{.pot = snapshot.pot,
                           .peak_load = snapshot.load.index,
                           .peak_load_height_mm = snapshot.load.height_mm,
                           .peak_load_cause = snapshot.load.cause,
                           .wire_shown = told.wire != tool::Wire::kNone,
                           .wire_height_mm = told.wire_height_mm,
                           .wheel_direction = snapshot.wheel_direction,
                           .wheel_turning = snapshot.wheel_turning,
                           .wheel_speed_rad_s = snapshot.wheel_speed_rad_s,
                           .contacts = result.forces.contacts};
    shown.hand = {.position_mm = told.position_mm,
                  .radius_mm = told.radius_mm,
                  .tool = told.tool,
                  .side = result.side,
                  .touching = result.forces.contacts > 0};
    const bool assists = result.has_second && !told.second.present;  // with the first hand's size
    shown.second_hand = {
        .position_mm = result.has_second ? result.second_position_mm : told.second.position_mm,
        .radius_mm = assists ? told.radius_mm : told.second.radius_mm,
        .tool = assists ? tool::Tool::kHand : told.second.tool,
        .side = result.second_side,
        .shown = result.has_second || told.second.present,
        .touching = result.second_forces.contacts > 0};
    if (snapshot.tool.guided) show_guided_hands(shown, snapshot);
    return shown;
}

}  // namespace onggi::app
