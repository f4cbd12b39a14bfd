#include "game/app/kiosk/visit/visit_screens.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/app/kiosk/visit/bench_tools.h"
#include "game/screens/page/legibility.h"
#include "game/visit/finish/finish.h"
#include "game/visit/flow/flow.h"

namespace onggi::app {
namespace {

// Attract mode repeats: the throwing, then a museum's pot, then the wall of the day, if there is one. After a
// pot was put on the wall, the wall comes first.
constexpr double kAttractThrowsS = 25.0;
constexpr double kAttractPotS = 20.0;
constexpr double kAttractWallS = 20.0;
constexpr double kWallIsNewS = 60.0;
constexpr float kNearPx = 0.5F;  // smaller motions of an outline are ignored

bool are_near(const std::vector<std::vector<vec2>>& x, const std::vector<std::vector<vec2>>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const auto& a, const auto& b) {
        return a.size() == b.size() && (a.empty() || glm::length(a.back() - b.back()) <= kNearPx);
    });
}

bool is_for_nobody(const kiosk::ScreenState& state) {
    return visit::step_of(state.screen).whose == visit::Whose::kNobody;
}

// True also under a panel.
bool works_clay(const kiosk::ScreenState& state) {
    return visit::step_of(state.screen).finger == visit::Finger::kClay;
}

}  // namespace

bool VisitScreens::is_closed(const kiosk::State& state) const {
    return is_for_nobody(state) && state.panel == kiosk::Panel::kNone &&
           !kiosk::is_open(parts_.settings.config, parts_.minute_of_day());
}

void VisitScreens::update(const kiosk::State& state, const VisitMoment& moment, const SceneEdges& edges,
                          const std::optional<double>& wire_mm) {
    screens::View view;
    view.state = state;
    view.width_px = parts_.view.width();
    view.height_px = parts_.view.height();
    if (view.width_px <= 0 || view.height_px <= 0) return;
    const kiosk::Config& config = parts_.settings.config;
    view.px_per_mm = screens::px_per_mm(view.width_px, view.height_px, config.screen.diagonal_inch);
    view.distance_mm = config.screen.distance_mm;
    view.own_digits = config.languages.own_digits;
    view.seconds_left = state.panel == kiosk::Panel::kIdle
                            ? visit::seconds_left(state, parts_.settings.rules.countdown_s, moment.now_s)
                        : state.panel == kiosk::Panel::kPin ? visit::pin_seconds_left(state, moment.now_s)
                                                            : 0;
    view.countdown_s = parts_.settings.rules.countdown_s;
    view.languages = parts_.settings.languages;
    view.exhibits = parts_.settings.exhibits;
    view.pot = effects_.pot();
    if (state.screen == kiosk::Screen::kResume) view.left_over = effects_.left_over();
    view.phone = effects_.phone_way();
    view.has_wall = parts_.settings.rules.has_wall;
    view.offers_speech = parts_.settings.rules.offers_speech;
    add_shelf(view, state);
    view.focus = pointer_.focus();
    view.scans = pointer_.scans();
    if (config.sound.captions && works_clay(state)) view.heard = caption(moment);
    if (config.sound.captions && visit::kiln_burns(state)) view.heard = "cap.kiln";
    add_attract(view, state, moment.now_s);
    view.can_look_in = parts_.view.project_framed(wheel::View::kLookingIn, {}, dvec3(0.0)).has_value();
    view.scene_edges_px = vec3(edges.left, edges.top, edges.right);
    add_scene(view, state, moment.snapshot);
    add_aside(view);
    add_wire(view, moment.snapshot, wire_mm);
    if (works_clay(state) && state.throwing.tray) view.bench = bench_tools(parts_, state);
    if (state.panel == kiosk::Panel::kStaff) {
        desk_.add_to(view, moment.snapshot);
    } else {
        desk_.leave();
    }
    view.closed = is_closed(state);
    if (is_asked(view)) return;
    asked_ = std::make_shared<const screens::View>(std::move(view));
    composer_.ask(asked_);
}

void VisitScreens::add_attract(screens::View& view, const kiosk::State& state, double now_s) const {
    if (!is_for_nobody(state)) return;
    const bool has_wall = effects_.wall() && !effects_.wall()->empty() && !is_closed(state);
    const double pot_s = view.exhibits->empty() ? 0.0 : kAttractPotS;
    const double wall_s = has_wall ? kAttractWallS : 0.0;
    const double put_s = effects_.put_on_wall_s();
    const double first_s = has_wall && state.screen_s - put_s < kWallIsNewS ? kAttractWallS : 0.0;
    const double in_turns_s = std::max(0.0, now_s - state.screen_s) - first_s;
    const double turn_s = kAttractThrowsS + pot_s + wall_s;
    const auto turn = static_cast<std::size_t>(std::max(0.0, in_turns_s) / turn_s);
    const double in_turn_s = std::fmod(std::max(0.0, in_turns_s), turn_s);
    view.attract_turn = static_cast<int>(turn);
    if (in_turns_s < 0.0 || in_turn_s >= kAttractThrowsS + pot_s) {
        view.wall = effects_.wall();
        view.wall_is_new = now_s - put_s < kWallIsNewS;
    } else if (in_turn_s >= kAttractThrowsS) {
        view.attract_exhibit = static_cast<int>(turn % view.exhibits->size());
    }
}

// The newest pot is left out while it is shown in the middle.
void VisitScreens::add_shelf(screens::View& view, const kiosk::State& state) {
    const bool without_newest = view.pot && state.keeping.outcome == kiosk::Keeping::Outcome::kKept;
    if (!shelf_ || shelf_kept_ != effects_.pots_kept() || shelf_without_newest_ != without_newest) {
        shelf_kept_ = effects_.pots_kept();
        shelf_without_newest_ = without_newest;
        std::vector<screens::ShelfPot> others = effects_.day();
        if (without_newest && !others.empty()) others.erase(others.begin());
        shelf_ = std::make_shared<const std::vector<screens::ShelfPot>>(std::move(others));
    }
    view.shelf = shelf_;
}

bool VisitScreens::is_asked(screens::View& view) const {
    constexpr float kWarningPx = 6.0F;
    if (!asked_) return false;
    // Ignores small motions of the outlines in the comparison, but requests their exact places.
    std::vector<std::vector<vec2>> outline_px = view.outline_px;
    const std::optional<vec2> warning_at_px = view.warning_at_px;
    const std::optional<vec2> wire_at_px = view.wire_at_px;
    if (are_near(asked_->outline_px, outline_px)) view.outline_px = asked_->outline_px;
    if (asked_->warning_at_px && warning_at_px &&
        glm::length(*asked_->warning_at_px - *warning_at_px) < kWarningPx)
        view.warning_at_px = asked_->warning_at_px;
    if (asked_->wire_at_px && wire_at_px && glm::length(*asked_->wire_at_px - *wire_at_px) < kWarningPx)
        view.wire_at_px = asked_->wire_at_px;
    const bool is_same = *asked_ == view;
    view.outline_px = std::move(outline_px);
    view.warning_at_px = warning_at_px;
    view.wire_at_px = wire_at_px;
    return is_same;
}

void VisitScreens::add_scene(screens::View& view, const kiosk::State& state,
                             const haptic::Snapshot& snapshot) const {
    if (!works_clay(state)) return;
    const auto seen = [&](const dvec3& place_mm) {
        const auto px = parts_.view.project(place_mm);
        return px ? vec2(*px) : vec2(0.0F);
    };
    const pot::Pot& shape = *snapshot.pot;
    if (state.throwing.warning != kiosk::Warning::kNone) {
        view.thinnest_mm =
            0.1 * static_cast<double>(std::lround(10.0 * thinnest_wall_mm(shape)));  // as displayed
        const bool rtl = (*view.languages)[static_cast<std::size_t>(state.comfort.language)].right_to_left();
        const double radius_mm = wall_at(shape, snapshot.load.height_mm).outer_mm;
        view.warning_at_px = seen({(rtl ? -radius_mm : radius_mm), snapshot.load.height_mm, 0.0});
    }
    const std::vector<vec2> outline = jar_.outline();
    if (outline.empty()) return;
    std::vector<vec2> left;
    std::vector<vec2> right;
    for (const vec2& point : outline) {
        left.push_back(seen({-double{point.x}, double{point.y}, 0.0}));
        right.push_back(seen({double{point.x}, double{point.y}, 0.0}));
    }
    std::vector<vec2> rim;
    constexpr int kPoints = 48;
    for (int i = 0; i <= kPoints; ++i) {
        const double angle = kTurn * i / kPoints;
        rim.push_back(seen({double{outline.back().x} * std::cos(angle), double{outline.back().y},
                            double{outline.back().x} * std::sin(angle)}));
    }
    view.outline_px = {std::move(left), std::move(right), std::move(rim)};
}

// Places the bowl on the bench to the left of the wheel.
void VisitScreens::add_aside(screens::View& view) const {
    constexpr dvec3 kPlaceMm{-335.0, -52.0, -150.0};
    constexpr double kHalfMm = 50.0;
    view.aside = jar_.aside();
    if (!view.aside) return;
    const auto foot = parts_.view.project(kPlaceMm);
    const auto left = parts_.view.project(kPlaceMm - dvec3(kHalfMm, 0.0, 0.0));
    const auto right = parts_.view.project(kPlaceMm + dvec3(kHalfMm, 0.0, 0.0));
    if (!foot || !left || !right) {
        view.aside.reset();
        return;
    }
    // Whole pixels, so that small camera motions do not change the view.
    view.aside_foot_px = vec2(glm::round(*foot));
    view.aside_px_per_mm = static_cast<float>(std::round(right->x - left->x) / (2.0 * kHalfMm));
}

void VisitScreens::add_wire(screens::View& view, const haptic::Snapshot& snapshot,
                            const std::optional<double>& wire_mm) const {
    if (!wire_mm || !works_clay(view.state)) return;
    constexpr double kBesideMm = 90.0;
    const auto px = parts_.view.project({kBesideMm, *wire_mm, 0.0});
    if (!px) return;
    view.wire_off_mm = static_cast<int>(std::lround(std::max(0.0, snapshot.pot->height_mm - *wire_mm)));
    view.wire_at_px = vec2(*px);
}

// Keeps a caption long enough to be read, even if the hand lifts.
const std::string& VisitScreens::caption(const VisitMoment& moment) {
    constexpr double kReadS = 1.5;
    const std::string_view heard = caption_key(scene_of(moment.snapshot, 1.0));
    if (heard == caption_ || moment.now_s - caption_s_ < kReadS) return caption_;
    caption_s_ = moment.now_s;
    return caption_ = heard;
}

}  // namespace onggi::app
