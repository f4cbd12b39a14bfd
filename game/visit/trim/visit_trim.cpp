#include "game/visit/trim/visit_trim.h"

#include <algorithm>
#include <cmath>

#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_parameters.h"
#include "game/pot/set_aside.h"
#include "game/visit/flow/step.h"
#include "game/wheel/hands.h"

namespace onggi::visit {
namespace {

constexpr double kTrimmerHoversMm = 14.0;

}  // namespace

bool VisitTrim::is_there() const {
    return step_of(flow_.state().screen).finger == Finger::kFoot;
}

void VisitTrim::begin(const haptic::Snapshot& snapshot) {
    begun_mm3_ = snapshot.on_wheel_mm3;
    height_mm_ = snapshot.pot->height_mm;
}

void VisitTrim::look(const haptic::Snapshot& snapshot) {
    if (!is_there()) return;
    height_mm_ = snapshot.pot->height_mm;
    const double taken_g = (begun_mm3_ - snapshot.on_wheel_mm3) * clay::studio::kDensityGPerMm3;
    const int grams = static_cast<int>(std::lround(std::max(0.0, taken_g)));
    if (grams == flow_.state().trimming.taken_g) return;
    flow_.dispatch(kiosk::event::Trimmed{grams});
}

dvec2 VisitTrim::turned(const dvec2& place_mm) const {
    return {place_mm.x, height_mm_ - place_mm.y};
}

std::optional<VisitTrim::Foot> VisitTrim::wanted() const {
    constexpr double kFootMm = 26.0;
    constexpr double kFromTopMm = 5.0;
    const bool is_wanted = open_finger(flow_.state()) == Finger::kFoot && !flow_.state().trimming.touched;
    if (!is_wanted || over_.height_mm < 2.0 * kFootMm) return std::nullopt;
    return Foot{over_.height_mm - kFootMm, over_.height_mm - kFromTopMm};
}

void VisitTrim::show(wheel::WheelScene& scene, const haptic::Snapshot& snapshot) {
    if (!is_there()) {
        if (!scene.registry().alive(in_scene_)) return;
        scene.registry().destroy(in_scene_);
        scene.lead_hands(std::nullopt);
        return scene.shave(0.0, dvec3(0.0));
    }
    over_ = pot::turned_over(*snapshot.pot);
    over_.stage = clay::Firing::kDry;  // look only: dry clay's colour, without shrinking
    scene.put_on_wheel(in_scene_, {.pot = &over_});
    const bool works = snapshot.tool.pressing && snapshot.result.grip.grip != clay::studio::Grip::kNone;
    const dvec2 at_mm = turned(works ? snapshot.result.grip.hand_mm : dvec2(snapshot.tool.position_mm));
    const double side = std::signbit(at_mm.x) ? -1.0 : 1.0;
    auto hands = wheel::hands_of(snapshot);
    wheel::DrawnHand& hand = hands.front();
    const double gone_mm = snapshot.tool.radius_mm + (works ? 0.0 : kTrimmerHoversMm);
    hand.position_mm = {at_mm.x + side * gone_mm, std::max(at_mm.y, kTrimmerHoversMm), 0.0};
    hand.tool = tool::Tool::kTrimmer;
    hand.side = tool::Side::kOut;
    hand.shown = hand.guided = true;
    hand.digs = false;
    hand.touching = works;
    hands.back().shown = false;
    scene.lead_hands(hands);
    scene.shave(std::max(0.0, begun_mm3_ - snapshot.on_wheel_mm3), {at_mm.x, at_mm.y, 0.0});
}

}  // namespace onggi::visit
