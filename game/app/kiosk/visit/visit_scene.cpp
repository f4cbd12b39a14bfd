#include "game/app/kiosk/visit/visit_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/screens/page/layout.h"
#include "game/visit/throw/throw.h"

namespace onggi::app {

// While a screen hides the scene, the camera moves to its next framing.
void VisitScene::aim_camera(const kiosk::State& state, double clay_mm, const screens::View* shown,
                            bool covered) {
    if (shown == nullptr || covered) parts_.view.scene().jump();
    parts_.view.scene().move_less(state.comfort.still);
    if (!visit::step_of(state.screen).shows_scene && !covered) return;
    const BackgroundSight sight{
        .width_px = parts_.view.width(),
        .height_px = parts_.view.height(),
        .project = [&](wheel::View view, const wheel::Framing& framing, const dvec3& place_mm) {
            return parts_.view.project_framed(view, framing, place_mm);
        }};
    if (sight.width_px <= 0 || sight.height_px <= 0) return;
    const bool shows_room =
        shown != nullptr && shown->attract_exhibit < 0 && !shown->wall && state.panel == kiosk::Panel::kNone;
    CameraRequest request = camera_.request(state, shows_room, clay_mm, sight);
    request.evening = evening_at(parts_.settings.config, parts_.minute_of_day());
    if (request == aimed_) return;
    aimed_ = request;
    parts_.view.scene().look_at(request.view);
    parts_.view.scene().set_framing(request.framing);
    parts_.view.sway(request.sways);
    parts_.view.scene().set_evening(request.evening);
}

SceneEdges VisitScene::edges() const {
    return scene_edges(aimed_.framing, parts_.view.width(), parts_.view.height());
}

SceneMarks VisitScene::marks(const kiosk::State& state, const VisitMoment& moment,
                             const screens::Stage& stage) {
    if (const std::uint64_t lump = wheel_.lumps_asked(); lump != cued_lump_) {
        cued_lump_ = lump;
        cue_.begin();
    }
    forces_.look(moment.snapshot, moment.now_s);
    return {.band = warning_band(state, moment.snapshot),
            .cue = cue(state, moment, stage),
            .forces = forces(state, moment.snapshot)};
}

// During the first steps of the lesson the forces are shown at the clay; numbers and plots only on request.
std::optional<screens::ForceFrame> VisitScene::forces(const kiosk::State& state,
                                                      const haptic::Snapshot& snapshot) const {
    if (visit::open_finger(state) != visit::Finger::kClay) return std::nullopt;
    const bool asked = state.comfort.forces;
    if (!asked && state.throwing.steps_done >= kiosk::kTeachingSteps) return std::nullopt;
    return forces_.frame(snapshot, sight_of(parts_.view), asked);
}

// The most loaded part of the clay.
std::optional<screens::Band> VisitScene::warning_band(const kiosk::State& state,
                                                      const haptic::Snapshot& snapshot) const {
    const bool is_clay = visit::step_of(state.screen).finger == visit::Finger::kClay;
    if (!is_clay || state.throwing.warning == kiosk::Warning::kNone) return std::nullopt;
    constexpr double kHalfHeightMm = 11.0;
    const double middle_mm = std::clamp(snapshot.load.height_mm, kHalfHeightMm,
                                        std::max(kHalfHeightMm, snapshot.pot->height_mm - kHalfHeightMm));
    return band_round(*snapshot.pot, middle_mm - kHalfHeightMm, middle_mm + kHalfHeightMm);
}

std::optional<screens::Band> VisitScene::band_round(const pot::Pot& shape, double low_mm,
                                                    double high_mm) const {
    constexpr int kPoints = 24;
    screens::Band band;
    for (const auto& [edge, y_mm] : {std::pair(&band.upper, high_mm), std::pair(&band.lower, low_mm)}) {
        const double radius_mm = wall_at(shape, std::min(y_mm, shape.height_mm - 0.5)).outer_mm;
        if (radius_mm <= 0.0) return std::nullopt;
        for (int i = 0; i <= kPoints; ++i) {
            const double angle = kPi * (1.0 - static_cast<double>(i) / kPoints);
            const auto px =
                parts_.view.project({radius_mm * std::cos(angle), y_mm, radius_mm * std::sin(angle)});
            if (!px) return std::nullopt;
            edge->push_back(vec2(*px));
        }
    }
    return band;
}

std::optional<screens::Cue> VisitScene::cue(const kiosk::State& state, const VisitMoment& moment,
                                            const screens::Stage& stage) {
    if (visit::open_finger(state) == visit::Finger::kBrush) {
        if (!input_.keys_lead() && stage.target_at(input_.pointer().at_px()) >= 0) return std::nullopt;
        screens::Cue dot{.ring = drawing_.ring(input_.keys_lead())};
        return dot.ring.empty() ? std::nullopt : std::optional(dot);
    }
    if (const auto foot = trim_.wanted()) {
        auto belt = band_round(trim_.pot(), foot->low_mm, foot->high_mm);
        return belt ? std::optional(screens::Cue{.belt = std::move(*belt)}) : std::nullopt;
    }
    if (visit::open_finger(state) != visit::Finger::kClay) return std::nullopt;
    const pot::Pot& shape = *moment.snapshot.pot;
    if (const auto wire_mm = wheel_.finger().wire_mm()) {
        // The wire's height: a line instead of a belt.
        constexpr double kHalfMm = 0.5;
        auto line = band_round(shape, *wire_mm - kHalfMm, *wire_mm + kHalfMm);
        return line ? std::optional(screens::Cue{.belt = std::move(*line)}) : std::nullopt;
    }
    const vec2 at_px = input_.pointer().at_px();
    std::optional<dvec2> hovers_mm;
    if (input_.hovers(moment.now_s) && stage.target_at(at_px) < 0) {
        hovers_mm = place_at(parts_.view, at_px);
    }
    std::optional<dvec2> marker_mm;
    if (input_.keys_lead()) marker_mm = wheel_.finger().marker_mm();
    std::optional<int> wanted;
    const bool holds_tool = state.throwing.held != tool::Tool::kHand;
    if (visit::shows_hint(state, moment.now_s, parts_.settings.rules) && !holds_tool)
        wanted = state.throwing.steps_done;
    const auto place = cue_.look({.now_s = moment.now_s,
                                  .shape = shape,
                                  .grip = moment.snapshot.result.grip,
                                  .is_shown = state.throwing.shown.has_value(),
                                  .wanted_step = wanted,
                                  .hovers_mm = hovers_mm,
                                  .marker_mm = marker_mm,
                                  .with_tool = holds_tool,
                                  .still = state.comfort.still});
    if (!place) return std::nullopt;
    screens::Cue cue{.guard = place->guard, .words_on_left = place->hand_side > 0.0};
    if (place->thread) {
        const auto finger_px =
            parts_.view.project({place->thread->finger_mm.x, place->thread->finger_mm.y, 0.0});
        const auto hand_px = parts_.view.project({place->thread->hand_mm.x, place->thread->hand_mm.y, 0.0});
        if (finger_px && hand_px)
            cue.thread = {vec2(*finger_px), vec2(*hand_px), static_cast<float>(place->thread->strength)};
    }
    if (place->hold && place->hold->opening_mm > 0.0) {
        constexpr int kPoints = 40;
        const CueHold& hold = *place->hold;
        for (int i = 0; i <= kPoints; ++i) {
            const double angle = kTurn * i / kPoints;
            const auto px = parts_.view.project(
                {hold.opening_mm * std::cos(angle), hold.high_mm, hold.opening_mm * std::sin(angle)});
            if (!px) return std::nullopt;
            cue.ring.push_back(vec2(*px));
        }
    } else if (place->hold) {
        auto belt = band_round(shape, place->hold->low_mm, place->hold->high_mm);
        if (!belt) return std::nullopt;
        cue.belt = std::move(*belt);
    }
    if (place->step) add_way(cue, shape, *place->step, side_of(state));
    if (place->marker_mm) point_at(cue, shape, *place->marker_mm);
    return cue;
}

// Adds the arrow at the marker of the keys, in the direction in which its hand works there: down into the
// middle, up from the rim of an open pot, or towards the wall.
void VisitScene::point_at(screens::Cue& cue, const pot::Pot& shape, const dvec2& marker_mm) const {
    const auto px = parts_.view.project({marker_mm.x, marker_mm.y, 0.0});
    if (!px) return;
    const bool is_right = marker_mm.x > 0.0;
    const auto way = marker_mm.x == 0.0                                   ? screens::CueWay::kDown
                     : marker_mm.y >= shape.height_mm && !is_solid(shape) ? screens::CueWay::kUp
                     : is_right                                           ? screens::CueWay::kLeft
                                                                          : screens::CueWay::kRight;
    place_arrow(cue, way, vec2(*px), is_right ? 1.0F : -1.0F);
}

// `side`: of the axis, for the arrows beside the wall.
void VisitScene::place_arrow(screens::Cue& cue, screens::CueWay way, vec2 at_px, float side) const {
    constexpr float kTowardsU = 150.0F;
    constexpr float kBesideU = 50.0F;
    constexpr float kAboveU = 122.0F;
    const float u = screens::px_per_u_of(parts_.view.width(), parts_.view.height());
    cue.way = way;
    cue.way_px = at_px + u * (way == screens::CueWay::kDown ? vec2(0.0F, -kAboveU)
                              : way == screens::CueWay::kUp ? vec2(side * kBesideU, 0.0F)
                                                            : vec2(side * kTowardsU, 0.0F));
}

// Adds the arrow of a step: towards the wall, down into the middle, or up beside the wall.
void VisitScene::add_way(screens::Cue& cue, const pot::Pot& shape, int step, double side) const {
    const CueHold hold = hold_of_step(shape, step);
    const double middle_mm = 0.5 * (hold.low_mm + hold.high_mm);
    const double edge_mm = hold.opening_mm > 0.0 ? 0.0 : side * wall_at(shape, middle_mm).outer_mm;
    const auto edge_px =
        parts_.view.project({edge_mm, hold.opening_mm > 0.0 ? hold.high_mm : middle_mm, 0.0});
    if (!edge_px) return;
    constexpr int kPresses = 0;
    const auto way = hold.opening_mm > 0.0 ? screens::CueWay::kDown
                     : step != kPresses    ? screens::CueWay::kUp
                     : side > 0.0          ? screens::CueWay::kLeft
                                           : screens::CueWay::kRight;
    place_arrow(cue, way, vec2(*edge_px), static_cast<float>(side));
}

}  // namespace onggi::app
