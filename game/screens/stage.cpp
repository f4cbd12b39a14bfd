#include "game/screens/stage.h"

#include <algorithm>
#include <cmath>

#include "game/screens/page/design.h"

namespace onggi::screens {
namespace {

constexpr double kChangeS = 0.24;
constexpr double kAttractChangeS = 0.6;  // between the throwing, a museum's pot and the night
constexpr double kChangeStillS = 0.12;
constexpr float kRiseU = 12.0F;
constexpr double kCueInS = 0.2;
constexpr double kCueOutS = 0.18;
constexpr double kHatchStepsPerS = 6.0 / 13.0;  // 6 u a second

bool is_still(const Composed& composed) {
    return composed.view->state.comfort.still;
}

bool is_other_screen(const Composed& one, const Composed& other) {
    const kiosk::ScreenState& a = one.view->state;
    const kiosk::ScreenState& b = other.view->state;
    return a.screen != b.screen || a.panel != b.panel || a.comfort.language != b.comfort.language ||
           one.view->attract_exhibit != other.view->attract_exhibit ||
           one.view->closed != other.view->closed || a.firing != b.firing;
}

// The duration of the transition.
double change_s(const Composed& before, const Composed& now) {
    if (is_still(now)) return kChangeStillS;
    return before.composition.plays_by_itself && now.composition.plays_by_itself ? kAttractChangeS : kChangeS;
}

bool are_alike(const Item& a, const Item& b) {
    return !a.turning && !b.turning && a.rect == b.rect && a.key == b.key && a.alpha == b.alpha &&
           (a.painting == nullptr) == (b.painting == nullptr) && a.corners == b.corners &&
           a.motion == b.motion;
}

}  // namespace

Moved moved(const Motion& motion, double since_s) {
    // Two slow waves whose beat does not repeat within a visit; slower than the three flashes a second of
    // WCAG 2.3.1.
    constexpr float kWavesRadS[] = {5.1F, 8.3F};
    const auto since = static_cast<float>(since_s);
    const float along =
        motion.lasts_s > 0.0F ? std::clamp((since - motion.begins_s) / motion.lasts_s, 0.0F, 1.0F) : 1.0F;
    const float eased = along * along * (3.0F - 2.0F * along);
    const float wave = 0.6F * std::sin(kWavesRadS[0] * since + motion.phase_rad) +
                       0.4F * std::sin(kWavesRadS[1] * since + 2.0F * motion.phase_rad);
    return {.alpha = std::lerp(motion.from_alpha, motion.to_alpha, eased) *
                     (1.0F - 0.5F * motion.flicker * (1.0F + wave)),
            .down_u = motion.from_y_u * (1.0F - eased)};
}
Moved moved_to_the_end(const Motion& motion) {
    return {.alpha = motion.to_alpha};
}

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// Removes the pairing of items that lie over an unpaired item: they would be drawn under it. Returns whether
// there were any.
bool drop_covered(const std::vector<Item>& items, std::vector<std::size_t>& partner,
                  std::vector<std::size_t>& partner_of_other) {
    bool dropped = false;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (partner[i] == kNone) continue;
        for (std::size_t under = 0; under < i && partner[i] != kNone; ++under) {
            const ui::Rect common = overlap(items[i].rect, items[under].rect);
            if (partner[under] != kNone || common.width * common.height <= 0.0F) continue;
            partner_of_other[partner[i]] = kNone;
            partner[i] = kNone;
            dropped = true;
        }
    }
    return dropped;
}

}  // namespace

// A screen of another size is repainted and needs another atlas size.
void Stage::fit_atlas() {
    const ui::Rect picture = now_->composition.bounds.scaled(now_->composition.px_per_u);
    const int side_px = ui::Atlas::side_px_for(static_cast<int>(picture.width + 0.5F),
                                               static_cast<int>(picture.height + 0.5F));
    if (side_px == atlas_.side_px()) return;
    atlas_ = ui::Atlas(side_px);
    turning_.clear();
}

void Stage::take(std::shared_ptr<const Composed> composed, double now_s) {
    if (!composed || composed == now_) return;
    if (now_ && is_other_screen(*now_, *composed)) {
        before_ = now_;
        since_s_ = now_s;
    }
    now_ = std::move(composed);
    find_alike();
    // Drop the pots of earlier screens.
    if (turning_.size() > 16) turning_.clear();
}

void Stage::find_alike() {
    alike_before_.clear();
    alike_now_.clear();
    if (!before_) return;
    const std::vector<Item>& old_items = before_->composition.items;
    const std::vector<Item>& new_items = now_->composition.items;
    std::vector<std::size_t> of_old(old_items.size(), kNone);
    std::vector<std::size_t> of_new(new_items.size(), kNone);
    for (std::size_t i = 0; i < new_items.size(); ++i) {
        for (std::size_t k = 0; k < old_items.size() && of_new[i] == kNone; ++k) {
            if (of_old[k] != kNone || !are_alike(new_items[i], old_items[k])) continue;
            of_new[i] = k;
            of_old[k] = i;
        }
    }
    for (bool settles = false; !settles;) {
        const bool dropped = drop_covered(new_items, of_new, of_old);
        settles = !drop_covered(old_items, of_old, of_new) && !dropped;
    }
    for (const std::size_t partner : of_old)
        alike_before_.push_back(partner != kNone ? 1 : 0);
    for (const std::size_t partner : of_new)
        alike_now_.push_back(partner != kNone ? 1 : 0);
}

bool Stage::changes(double now_s) const {
    return before_ != nullptr && now_s - since_s_ < change_s(*before_, *now_);
}

int Stage::target_at(vec2 px) const {
    if (!now_) return -1;
    const Composition& composition = now_->composition;
    const vec2 at = px / composition.px_per_u;
    for (std::size_t i = composition.targets.size(); i-- > 0;) {
        if (composition.targets[i].lies_under(at)) return static_cast<int>(i);
    }
    return -1;
}

// Places all pictures of a composition in the atlas. Returns false if that removed another picture.
bool Stage::all_placed(const Composed& composed) {
    const std::uint64_t generation = atlas_.generation();
    for (const Item& item : composed.composition.items) {
        if (item.painting) static_cast<void>(place_of(item));
        if (item.pressed_painting) static_cast<void>(atlas_.place(item.pressed_key, item.pressed_painting));
    }
    for (const Item& words : composed.composition.guard_words)
        if (words.painting) static_cast<void>(atlas_.place(words.key, words.painting));
    if (composed.composition.forces) {
        for (const Item& item : composed.composition.forces->digits)
            static_cast<void>(atlas_.place(item.key, item.painting));
        for (const Item& item : composed.composition.forces->names)
            static_cast<void>(atlas_.place(item.key, item.painting));
        const Item& point = composed.composition.forces->point;
        static_cast<void>(atlas_.place(point.key, point.painting));
    }
    return atlas_.generation() == generation;
}

std::optional<ui::Rect> Stage::place_of(const Item& item) {
    std::shared_ptr<const ui::Painting> newest;
    if (item.turning && turned_) {
        for (const Turned& turned : *turned_) {
            if (turned.key == item.key) newest = turned.painting;
        }
    }
    if (!newest) return atlas_.place(item.key, item.painting);
    Turning& turning = turning_[item.key];
    const auto key = [&] { return (item.key ^ 0x7475726eU) * 2U + (turning.second ? 1U : 0U); };
    if (turning.shown == newest) return atlas_.place(key(), newest);
    turning.shown = newest;
    turning.second = !turning.second;
    return atlas_.replace(key(), newest);
}

const ui::DrawList& Stage::draw(const StageFrame& frame) {
    list_.clear();
    covers_ = false;
    scene_rests_ = false;
    const double step_s = std::clamp(frame.now_s - last_s_, 0.0, 0.1);
    last_s_ = frame.now_s;
    if (!now_) return list_;
    fit_atlas();
    follow_cue(frame, step_s);

    const double along = before_ ? (frame.now_s - since_s_) / change_s(*before_, *now_) : 1.0;
    const bool has_changed = before_ != nullptr && along >= 1.0;
    if (has_changed) before_.reset();
    if (has_changed) atlas_.begin_asking();
    // Repeat: adding a painting may have cleared the half of the atlas that holds an earlier one.
    for (int look = 0; look < 3; ++look) {
        const bool kept_before = !before_ || all_placed(*before_);
        if (all_placed(*now_) && kept_before) break;
    }
    if (has_changed) atlas_.forget_unasked();
    if (!before_) {
        covers_ = now_->composition.covers;
        add(*now_, frame, {});
    } else {
        const float fraction = static_cast<float>(along * (2.0 - along));  // eased out
        const bool from_wall = before_->composition.covers;
        const bool to_wall = now_->composition.covers;
        covers_ = from_wall && to_wall;
        scene_rests_ = from_wall != to_wall;
        // The fade has not begun: show the old screen while the scene is prepared.
        const bool still_covers = from_wall && !to_wall && fraction <= 0.0F;
        if (still_covers) {
            covers_ = true;
            add(*before_, frame, {});
        } else {
            add_changing(frame, fraction);
        }
    }
    uploads_ = atlas_.take_uploads();
    return list_;
}

// Adds both compositions, one fading in and one fading out.
void Stage::add_changing(const StageFrame& frame, float fraction) {
    const float rise = is_still(*now_) ? 0.0F : kRiseU * (1.0F - fraction);
    const bool from_wall = before_->composition.covers;
    const bool to_wall = now_->composition.covers;
    // A wall is always the first item. If the walls differ or the wall is new, it fades in over the previous
    // screen.
    const bool is_other_wall = to_wall && (alike_now_.empty() || alike_now_.front() == 0);
    add(*now_, frame, {.part = Part::kAlike});
    if (is_other_wall) {
        add(*before_, frame, {.part = Part::kOthers});
        add(*now_, frame, {fraction, rise, Part::kOthers});
    } else {
        add(*now_, frame, {from_wall && !to_wall ? 1.0F : fraction, rise, Part::kOthers});
        add(*before_, frame, {1.0F - fraction, 0.0F, Part::kOthers});
    }
}

void Stage::add(const Composed& composed, const StageFrame& frame, const Fade& fade) {
    const Composition& composition = composed.composition;
    const float scale = composition.px_per_u;
    const bool is_now = &composed == now_.get();
    const std::vector<char>& alike = is_now ? alike_now_ : alike_before_;
    const bool is_whole = is_now && fade.part != Part::kAlike && fade.alpha >= 1.0F;
    if (is_whole && frame.band != nullptr) {
        const double steps = is_still(composed) ? 0.0 : frame.now_s * kHatchStepsPerS;
        draw_warning(list_, *frame.band, static_cast<float>(steps - std::floor(steps)), scale);
    }
    if (is_whole && cue_alpha_ > 0.0 && composition.has_cue) {
        draw_cue(list_, cue_, static_cast<float>(cue_alpha_), scale);
        add_guard_words(composition);
    }
    const bool shows_forces = is_whole && frame.forces != nullptr && composition.forces != nullptr;
    const ForcePainter force_painter{
        .list = list_,
        .px_per_u = scale,
        .bounds_px = composition.bounds.scaled(scale),
        .place = [&](const Item& item) { return atlas_.place(item.key, item.painting); }};
    if (shows_forces) draw_touches(*frame.forces, *composition.forces, force_painter);
    for (std::size_t i = 0; i < composition.items.size(); ++i) {
        if (fade.part != Part::kAll && (alike[i] != 0) != (fade.part == Part::kAlike)) continue;
        const Item& item = composition.items[i];
        const Moved moves = is_now && !is_still(composed) ? moved(item.motion, frame.now_s - since_s_)
                                                          : moved_to_the_end(item.motion);
        const float item_alpha = fade.alpha * item.alpha * moves.alpha;
        vec2 shift(0.0F, moves.down_u + (composition.covers ? 0.0F : fade.rise_u));
        const bool pressed = is_now && item.target >= 0 && item.target == frame.pressed;
        if (item_alpha <= 0.0F) continue;
        if (!item.painting) {
            std::array<ui::Colour, 4> corners = item.corners;
            for (ui::Colour& corner : corners)
                corner.a *= item_alpha;
            list_.add_box(item.rect.scaled(scale), corners);
            continue;
        }
        const bool has_pressed = pressed && item.pressed_painting != nullptr;
        const auto& painting = has_pressed ? item.pressed_painting : item.painting;
        const auto place = has_pressed ? atlas_.place(item.pressed_key, painting) : place_of(item);
        if (!place) continue;
        if (pressed && !has_pressed) shift.y += 4.0F;
        list_.add_picture((vec2(item.rect.x, item.rect.y) + shift) * scale, *place, item_alpha);
    }
    if (shows_forces && composition.forces->has_panel)
        draw_force_panel(*frame.forces, *composition.forces, force_painter);
}

void Stage::follow_cue(const StageFrame& frame, double step_s) {
    const bool is_wanted = frame.cue != nullptr && frame.band == nullptr;
    if (is_wanted) cue_ = *frame.cue;
    const double change = is_wanted ? step_s / kCueInS : -step_s / kCueOutS;
    cue_alpha_ = is_still(*now_) ? (is_wanted ? 1.0 : 0.0) : std::clamp(cue_alpha_ + change, 0.0, 1.0);
}

// Places the words beside the belt, away from the hand, or below it if there is no room.
void Stage::add_guard_words(const Composition& composition) {
    const Item& words = composition.guard_words[static_cast<std::size_t>(cue_.guard)];
    if (cue_.guard == CueGuard::kNone || !words.painting || cue_.belt.lower.empty()) return;
    const float u = composition.px_per_u;
    constexpr float kAsideU = 26.0F;
    constexpr float kEdgeU = 16.0F;
    const ui::Rect bounds = composition.bounds.scaled(u).grown(-kEdgeU * u);
    const ui::Rect size = words.rect.scaled(u);
    const std::vector<vec2>& low = cue_.belt.lower;
    const float middle = 0.5F * (cue_.belt.upper.front().y + low.front().y);
    vec2 at(cue_.words_on_left ? low.front().x - kAsideU * u - size.width : low.back().x + kAsideU * u,
            middle - 0.5F * size.height);
    if (at.x < bounds.x || at.x + size.width > bounds.right())
        at = {0.5F * (low.front().x + low.back().x - size.width), low[low.size() / 2].y + kAsideU * u};
    at.x = std::clamp(at.x, bounds.x, std::max(bounds.x, bounds.right() - size.width));
    if (const auto from = atlas_.place(words.key, words.painting))
        list_.add_picture(at, *from, static_cast<float>(cue_alpha_));
}

}  // namespace onggi::screens
