// What the screens are told of a moment: the second half of KioskVisit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "game/app/kiosk/kiosk_staff.h"
#include "game/app/kiosk/kiosk_visit.h"
#include "game/screens/layout.h"
#include "game/screens/legibility.h"

namespace onggi::app {
namespace {

// Attract: the throwing, then one pot of a museum, and so on.
constexpr double kAttractThrowsS = 25.0;
constexpr double kAttractPotS = 20.0;

// Whether the screens would look the same: what changes every frame is not in a View.
bool looks_the_same(const screens::View& a, const screens::View& b) {
    const kiosk::State& s = a.state;
    const kiosk::State& t = b.state;
    const auto near = [](const std::vector<std::vector<vec2>>& x, const std::vector<std::vector<vec2>>& y) {
        if (x.size() != y.size()) return false;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (x[i].size() != y[i].size() ||
                (!x[i].empty() && glm::length(x[i].back() - y[i].back()) > 0.5F))
                return false;
        }
        return true;
    };
    const bool same_warning_place =
        a.warning_at_px.has_value() == b.warning_at_px.has_value() &&
        (!a.warning_at_px || glm::length(*a.warning_at_px - *b.warning_at_px) < 6.0F);
    return s.screen == t.screen && s.panel == t.panel && s.comfort == t.comfort && s.firing == t.firing &&
           s.glaze == t.glaze && s.shelf_first == t.shelf_first && s.keeping.outcome == t.keeping.outcome &&
           s.keeping.number == t.keeping.number && s.throwing.target == t.throwing.target &&
           s.throwing.steps_done == t.throwing.steps_done && s.throwing.tool == t.throwing.tool &&
           s.throwing.water == t.throwing.water && s.throwing.speed == t.throwing.speed &&
           s.throwing.warning == t.throwing.warning && s.staff.digits == t.staff.digits &&
           s.staff.was_wrong == t.staff.was_wrong && s.staff.page == t.staff.page &&
           s.staff.first_line == t.staff.first_line && s.staff.question == t.staff.question &&
           s.house_language == t.house_language && s.device_lost == t.device_lost &&
           s.force_rests == t.force_rests && a.width_px == b.width_px && a.height_px == b.height_px &&
           s.throwing.shown == t.throwing.shown && a.seconds_left == b.seconds_left && a.pot == b.pot &&
           a.attract_exhibit == b.attract_exhibit && a.attract_turn == b.attract_turn &&
           near(a.outline_px, b.outline_px) && a.scene_edges_px == b.scene_edges_px &&
           s.throwing.looks_in == t.throwing.looks_in &&
           std::lround(a.thinnest_mm * 10.0) == std::lround(b.thinnest_mm * 10.0) && same_warning_place &&
           a.focus == b.focus && a.scans == b.scans && a.heard == b.heard && a.closed == b.closed &&
           a.staff_title == b.staff_title && a.staff_lines == b.staff_lines && a.staff_pot == b.staff_pot &&
           a.staff_notice == b.staff_notice && a.staff_plot == b.staff_plot;
}

}  // namespace

// Over a wall that covers the scene the camera goes where it will be wanted next, unseen.
void KioskVisit::aim_camera(const haptic::Snapshot& snapshot) {
    const bool will_cover =
        state_.screen != kiosk::Screen::kAttract && state_.screen != kiosk::Screen::kThrow &&
        state_.screen != kiosk::Screen::kFailure && state_.screen != kiosk::Screen::kResume;
    const bool is_first = asked_ == nullptr;
    if (is_first || stage_.covers()) parts_.view.jump();
    parts_.view.move_less(state_.comfort.still);
    if (will_cover && !stage_.covers()) return;
    const PlateSight sight{
        .width_px = parts_.view.width(),
        .height_px = parts_.view.height(),
        .project = [&](wheel::View view, const wheel::Framing& framing, const dvec3& place_mm) {
            return parts_.view.project_framed(view, framing, place_mm);
        }};
    if (sight.width_px <= 0 || sight.height_px <= 0) return;
    const bool shows_room = asked_ && asked_->attract_exhibit < 0 && state_.panel == kiosk::Panel::kNone;
    CameraWish wish = camera_.wish(state_, shows_room, snapshot.shape->height_mm, sight);
    wish.evening = evening_at(parts_.settings.config, parts_.minute_of_day());
    if (wish == aimed_) return;
    aimed_ = wish;
    parts_.view.look_at(wish.view);
    parts_.view.set_framing(wish.framing);
    parts_.view.sway(wish.sways);
    parts_.view.set_evening(wish.evening);
}

// Long enough to be read, however the hand comes and goes.
const std::string& KioskVisit::caption(const haptic::Snapshot& snapshot) {
    constexpr double kReadS = 1.5;
    const std::string_view heard = caption_key(scene_of(snapshot, 1.0));
    if (heard == caption_ || now_s_ - caption_s_ < kReadS) return caption_;
    caption_s_ = now_s_;
    return caption_ = heard;
}

bool KioskVisit::kiln_burns() const {
    return state_.screen == kiosk::Screen::kFiring && state_.firing == kiosk::FiringStage::kFire &&
           state_.panel == kiosk::Panel::kNone;
}

bool KioskVisit::is_closed() const {
    return state_.screen == kiosk::Screen::kAttract && state_.panel == kiosk::Panel::kNone &&
           !kiosk::is_open(parts_.settings.config, parts_.minute_of_day());
}

void KioskVisit::compose(const haptic::Snapshot& snapshot) {
    screens::View view;
    view.state = state_;
    view.width_px = parts_.view.width();
    view.height_px = parts_.view.height();
    if (view.width_px <= 0 || view.height_px <= 0) return;
    const kiosk::Config& config = parts_.settings.config;
    view.px_per_mm = screens::px_per_mm(view.width_px, view.height_px, config.screen.diagonal_inch);
    view.distance_mm = config.screen.distance_mm;
    view.own_digits = config.languages.own_digits;
    view.seconds_left = state_.panel == kiosk::Panel::kIdle
                            ? kiosk::seconds_left(state_, parts_.settings.rules.countdown_s, now_s_)
                        : state_.panel == kiosk::Panel::kPin ? kiosk::pin_seconds_left(state_, now_s_)
                                                             : 0;
    view.countdown_s = parts_.settings.rules.countdown_s;
    view.languages = parts_.settings.languages;
    view.exhibits = parts_.settings.exhibits;
    view.pot = pot_;
    // The newest stands in the middle already while its maker looks at it.
    std::vector<screens::ShelfPot> others = day_;
    const bool newest_is_shown = pot_ && state_.keeping.outcome == kiosk::Keeping::Outcome::kKept;
    if (newest_is_shown && !others.empty()) others.erase(others.begin());
    view.shelf = std::make_shared<const std::vector<screens::ShelfPot>>(std::move(others));
    view.focus = pointer_.focus();
    view.scans = pointer_.scans();
    if (config.sound.captions && state_.screen == kiosk::Screen::kThrow) view.heard = caption(snapshot);
    if (config.sound.captions && kiln_burns()) view.heard = "cap.kiln";
    if (state_.screen == kiosk::Screen::kAttract && !view.exhibits->empty()) {
        // The throwing, then one of the pots, and again with the next.
        const double in_turn = std::max(0.0, now_s_ - state_.screen_s);
        const double turn_s = kAttractThrowsS + kAttractPotS;
        const auto turn = static_cast<std::size_t>(in_turn / turn_s);
        const bool pot_now = std::fmod(in_turn, turn_s) >= kAttractThrowsS;
        view.attract_turn = static_cast<int>(turn);
        if (pot_now) view.attract_exhibit = static_cast<int>(turn % view.exhibits->size());
    }
    const SceneEdges edges = scene_edges(aimed_.framing, view.width_px, view.height_px);
    view.can_look_in = parts_.view.project_framed(wheel::View::kLookingIn, {}, dvec3(0.0)).has_value();
    view.scene_edges_px = vec3(edges.left, edges.top, edges.right);
    add_scene(view, snapshot);
    if (state_.panel == kiosk::Panel::kStaff) {
        desk_.add_to(view, snapshot);
    } else {
        desk_.leave();
    }
    view.closed = is_closed();
    if (asked_ && looks_the_same(*asked_, view)) return;
    asked_ = std::make_shared<const screens::View>(std::move(view));
    composer_.ask(asked_);
}

void KioskVisit::add_scene(screens::View& view, const haptic::Snapshot& snapshot) {
    if (state_.screen != kiosk::Screen::kThrow) return;
    const auto seen = [&](const dvec3& place_mm) {
        const auto px = parts_.view.project(place_mm);
        return px ? vec2(*px) : vec2(0.0F);
    };
    const haptic::PotShape& shape = *snapshot.shape;
    if (state_.throwing.warning != kiosk::Warning::kNone) {
        view.thinnest_mm = thinnest_wall_mm(shape);
        const bool rtl = (*view.languages)[static_cast<std::size_t>(state_.comfort.language)].right_to_left();
        const double radius_mm = wall_at(shape, snapshot.load.height_mm).outer_mm;
        view.warning_at_px = seen({(rtl ? -radius_mm : radius_mm), snapshot.load.height_mm, 0.0});
    }
    if (!state_.throwing.target) return;
    const auto place = parts_.settings.exhibit_places[static_cast<std::size_t>(*state_.throwing.target)];
    const std::vector<vec2> outline = wet_outline(parts_.settings.targets[place]);
    std::vector<vec2> left;
    std::vector<vec2> right;
    for (const vec2& point : outline) {
        left.push_back(seen({-double{point.x}, double{point.y}, 0.0}));
        right.push_back(seen({double{point.x}, double{point.y}, 0.0}));
    }
    std::vector<vec2> rim;
    constexpr int kPoints = 48;
    for (int i = 0; i <= kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        rim.push_back(seen({double{outline.back().x} * std::cos(angle), double{outline.back().y},
                            double{outline.back().x} * std::sin(angle)}));
    }
    view.outline_px = {std::move(left), std::move(right), std::move(rim)};
}

// While the first moves are learnt, what the hand feels is shown at the clay; numbers and plots only to who
// asks.
std::optional<screens::ForceFrame> KioskVisit::force_frame(const haptic::Snapshot& snapshot,
                                                           const wheel::PotView& pot) const {
    if (state_.screen != kiosk::Screen::kThrow || state_.panel != kiosk::Panel::kNone) return std::nullopt;
    const bool asked = state_.comfort.forces;
    if (!asked && state_.throwing.steps_done >= kiosk::kTeachingSteps) return std::nullopt;
    return forces_.frame(snapshot, pot, sight_of(parts_.view), asked);
}

// The clay where it carries most.
std::optional<screens::Band> KioskVisit::warning_band(const haptic::Snapshot& snapshot) const {
    if (state_.screen != kiosk::Screen::kThrow || state_.throwing.warning == kiosk::Warning::kNone)
        return std::nullopt;
    constexpr double kHalfHeightMm = 11.0;
    const double middle_mm = std::clamp(snapshot.load.height_mm, kHalfHeightMm,
                                        std::max(kHalfHeightMm, snapshot.shape->height_mm - kHalfHeightMm));
    return band_round(*snapshot.shape, middle_mm - kHalfHeightMm, middle_mm + kHalfHeightMm);
}

std::optional<screens::Band> KioskVisit::band_round(const haptic::PotShape& shape, double low_mm,
                                                    double high_mm) const {
    constexpr int kPoints = 24;
    screens::Band band;
    for (const auto& [edge, y_mm] : {std::pair(&band.upper, high_mm), std::pair(&band.lower, low_mm)}) {
        const double radius_mm = wall_at(shape, std::min(y_mm, shape.height_mm - 0.5)).outer_mm;
        if (radius_mm <= 0.0) return std::nullopt;
        for (int i = 0; i <= kPoints; ++i) {
            const double angle = std::numbers::pi * (1.0 - static_cast<double>(i) / kPoints);
            const auto px =
                parts_.view.project({radius_mm * std::cos(angle), y_mm, radius_mm * std::sin(angle)});
            if (!px) return std::nullopt;
            edge->push_back(vec2(*px));
        }
    }
    return band;
}

std::optional<screens::Cue> KioskVisit::cue(const haptic::Snapshot& snapshot) {
    constexpr double kHoversS = 4.0;  // a mouse at rest for longer wants nothing
    if (state_.screen != kiosk::Screen::kThrow || state_.panel != kiosk::Panel::kNone) return std::nullopt;
    const haptic::PotShape& shape = *snapshot.shape;
    const vec2 at_px = pointer_.at_px();
    std::optional<dvec2> hovers_mm;
    if (now_s_ - hovered_s_ < kHoversS && stage_.target_at(at_px) < 0) {
        hovers_mm = place_at(at_px);
    }
    std::optional<dvec2> marker_mm;
    if (keys_lead_) marker_mm = hand_.marker_mm();
    std::optional<int> wanted;
    if (kiosk::shows_hint(state_, now_s_, parts_.settings.rules)) wanted = state_.throwing.steps_done;
    const auto place = cue_.look({.now_s = now_s_,
                                  .shape = shape,
                                  .grip = snapshot.result.grip,
                                  .is_shown = state_.throwing.shown.has_value(),
                                  .wanted_step = wanted,
                                  .hovers_mm = hovers_mm,
                                  .marker_mm = marker_mm,
                                  .still = state_.comfort.still});
    if (!place) return std::nullopt;
    screens::Cue cue{.guard = place->guard, .words_on_left = place->hand_side > 0.0};
    const CueHold& hold = *place->hold;
    if (hold.opening_mm > 0.0) {
        constexpr int kPoints = 40;
        for (int i = 0; i <= kPoints; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / kPoints;
            const auto px = parts_.view.project(
                {hold.opening_mm * std::cos(angle), hold.high_mm, hold.opening_mm * std::sin(angle)});
            if (!px) return std::nullopt;
            cue.ring.push_back(vec2(*px));
        }
    } else {
        auto belt = band_round(shape, hold.low_mm, hold.high_mm);
        if (!belt) return std::nullopt;
        cue.belt = std::move(*belt);
    }
    if (place->step) add_way(cue, shape, *place->step);
    return cue;
}

// The arrow of a step: towards the wall, down into the middle, or up beside the wall.
void KioskVisit::add_way(screens::Cue& cue, const haptic::PotShape& shape, int step) const {
    constexpr float kTowardsU = 150.0F;
    constexpr float kBesideU = 50.0F;
    constexpr float kAboveU = 122.0F;
    const CueHold hold = hold_of_step(shape, step);
    const double middle_mm = 0.5 * (hold.low_mm + hold.high_mm);
    const double edge_mm = hold.opening_mm > 0.0 ? 0.0 : side() * wall_at(shape, middle_mm).outer_mm;
    const auto edge_px =
        parts_.view.project({edge_mm, hold.opening_mm > 0.0 ? hold.high_mm : middle_mm, 0.0});
    if (!edge_px) return;
    const float u = screens::px_per_u_of(parts_.view.width(), parts_.view.height());
    const float out = static_cast<float>(side());
    constexpr int kPresses = 0;
    if (hold.opening_mm > 0.0) {
        cue.way = screens::CueWay::kDown;
        cue.way_px = vec2(*edge_px) - vec2(0.0F, kAboveU * u);
    } else if (step == kPresses) {
        cue.way = out > 0.0F ? screens::CueWay::kLeft : screens::CueWay::kRight;
        cue.way_px = vec2(*edge_px) + vec2(out * kTowardsU * u, 0.0F);
    } else {
        cue.way = screens::CueWay::kUp;
        cue.way_px = vec2(*edge_px) + vec2(out * kBesideU * u, 0.0F);
    }
}

}  // namespace onggi::app
