#include "game/visit/trim/visit_trim.h"

#include <algorithm>
#include <cmath>

#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_parameters.h"
#include "game/pot/set_aside.h"
#include "game/visit/flow/step.h"

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

void VisitTrim::show(wheel::WheelView& shown, const haptic::Snapshot& snapshot) {
    if (!is_there()) return;
    over_ = pot::turned_over(*snapshot.pot);
    over_.stage = clay::Firing::kDry;  // as it looks; it is measured and touched at the size it is
    shown.pot = &over_;
    shown.peak_load = 0.0;
    shown.wire_shown = false;
    shown.second_hand.shown = false;
    const bool works = snapshot.tool.pressing && snapshot.result.grip.grip != clay::studio::Grip::kNone;
    const dvec2 at_mm = turned(works ? snapshot.result.grip.hand_mm : dvec2(snapshot.tool.position_mm));
    const double side = std::signbit(at_mm.x) ? -1.0 : 1.0;
    const double gone_mm = snapshot.tool.radius_mm + (works ? 0.0 : kTrimmerHoversMm);
    shown.hand.position_mm = {at_mm.x + side * gone_mm, std::max(at_mm.y, kTrimmerHoversMm), 0.0};
    shown.hand.tool = tool::Tool::kTrimmer;
    shown.hand.side = tool::Side::kOut;
    shown.hand.shown = shown.hand.guided = true;
    shown.hand.digs = false;
    shown.hand.touching = works;
    shown.shaved_mm3 = std::max(0.0, begun_mm3_ - snapshot.on_wheel_mm3);
    shown.shaved_at_mm = {at_mm.x, at_mm.y, 0.0};
}

}  // namespace onggi::visit
