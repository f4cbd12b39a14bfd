#include "game/app/kiosk/visit/narrator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <utility>

#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/visit/steps.h"
#include "game/visit/throw/throw.h"

namespace onggi::app {
namespace {

using kiosk::Panel;
using kiosk::Screen;

constexpr double kClayEveryS = 4.0;
constexpr double kSameGuardEveryS = 12.0;
// Changes of the clay that are worth a word.
constexpr int kHighMm = 8;
constexpr int kWallMm = 3;
constexpr int kLoadPercent = 10;
constexpr int kMuchLoadPercent = 60;
constexpr int kSoonS = 10;  // before the end of the idle countdown, which is told once more

// With the language's comma, unless the text ends a sentence.
void append(std::string& text, const std::string& more, const kiosk::Language& language) {
    const kiosk::Punctuation& signs = language.punctuation();
    const bool ends = text.ends_with(signs.stop) || text.ends_with('!') || text.ends_with('?');
    if (!text.empty()) text += ends ? " " : signs.comma;
    text += more;
}

std::string whole(double value) {
    return fmt::format("{:.0f}", value);
}

const kiosk::Language& language_of(const screens::View& view) {
    const auto place = static_cast<std::size_t>(std::max(0, view.state.comfort.language));
    return (*view.languages)[std::min(place, view.languages->size() - 1)];
}

bool is_staffs(const kiosk::ScreenState& state) {
    return state.panel != Panel::kNone && visit::overlay_of(state.panel).is_staffs;
}

bool throws_clay(const kiosk::ScreenState& state) {
    return state.screen == Screen::kThrow && state.panel == Panel::kNone;
}

}  // namespace

MarkerPlace marker_place(const std::optional<dvec2>& marker_mm, const pot::Pot& shape) {
    constexpr double kNearMm = 0.5;
    if (!marker_mm) return MarkerPlace::kNone;
    if (std::abs(marker_mm->x) < kNearMm) return MarkerPlace::kMiddle;
    return marker_mm->y > shape.height_mm - kNearMm ? MarkerPlace::kRim : MarkerPlace::kWall;
}

TipPlace tip_place(const haptic::Snapshot& snapshot, bool is_at_buttons,
                   const std::optional<TipPlace>& before) {
    using Where = TipPlace::Where;
    using Height = TipPlace::Height;
    constexpr double kOverMm = 15.0;
    constexpr double kNearMm = 8.0;
    constexpr double kBase = 0.35;  // of the pot's height
    constexpr double kTop = 0.75;
    constexpr double kBorder = 0.04;
    const pot::Pot& shape = *snapshot.pot;
    const dvec3& tip_mm = snapshot.tool.position_mm;
    TipPlace place{.touches = snapshot.result.forces.contacts > 0};
    if (is_at_buttons || shape.outer_mm.empty()) {
        place.where = Where::kButtons;
        place.touches = false;
        return place;
    }
    const double radius_mm = std::hypot(tip_mm.x, tip_mm.z);
    const pot::Wall rim = rim_of(shape);
    const bool is_inside = snapshot.result.side == tool::Side::kIn;
    if (!is_inside && tip_mm.y > shape.height_mm - kNearMm) {
        if (radius_mm < std::max(kOverMm, rim.inner_mm - kNearMm)) {
            place.where = Where::kMiddle;
            return place;
        }
        if (radius_mm < rim.outer_mm + kNearMm) {
            place.where = Where::kRim;
            return place;
        }
    }
    constexpr double kFarMm = 30.0;
    const double y_mm = std::clamp(tip_mm.y, 0.0, std::max(0.0, shape.height_mm - kNearMm));
    if (!is_inside && radius_mm > wall_at(shape, y_mm).outer_mm + kFarMm) {
        const bool is_beside = std::abs(tip_mm.x) > std::abs(tip_mm.z);
        place.where = is_beside ? (tip_mm.x > 0.0 ? Where::kRight : Where::kLeft)
                                : (tip_mm.z > 0.0 ? Where::kFront : Where::kBehind);
        return place;
    }
    place.where = is_inside ? Where::kInside : Where::kOutside;
    const double fraction = tip_mm.y / std::max(shape.height_mm, 1.0);
    const auto is_above = [&](double border, Height above) {
        const bool was_above = before && before->where == place.where && before->height >= above;
        return fraction > border + (was_above ? -kBorder : kBorder);
    };
    place.height = is_above(kTop, Height::kTop)        ? Height::kTop
                   : is_above(kBase, Height::kHalfway) ? Height::kHalfway
                                                       : Height::kBase;
    return place;
}

void Narrator::say(std::string_view key, std::string text, bool is_urgent) {
    if (text.empty()) return;
    due_.push_back({.language = language_->code(),
                    .key = std::string(key),
                    .text = std::move(text),
                    .is_urgent = is_urgent});
}

void Narrator::say(std::string_view key) {
    if (!key.empty()) say(key, language_->spoken(key));
}

bool Narrator::tell_line(const screens::View& view, bool again) {
    kiosk::State state;
    static_cast<kiosk::ScreenState&>(state) = view.state;
    const std::string_view key = visit::spoken_key(state);
    const bool is_soon = view.state.panel == Panel::kIdle && view.seconds_left <= kSoonS;
    const std::string line = fmt::format("{}/{}/{}", language_->code(), key, is_soon);
    if (line == told_line_ && !again) return false;
    told_line_ = line;
    if (!key.empty())
        say(key, kiosk::filled_in(language_->spoken(key), std::to_string(view.seconds_left)), true);
    return true;
}

void Narrator::tell_pot(const screens::FiredPot& pot) {
    const auto measure = [&](std::string_view key, const std::string& number, std::string_view unit_key) {
        return fmt::format("{} {} {}", language_->spoken(key), number, language_->spoken(unit_key));
    };
    std::string all = measure("your.h", whole(pot.height_mm), "unit.mm");
    append(all, measure("your.w", whole(pot.width_mm), "unit.mm"), *language_);
    append(all, measure("your.wt", whole(pot.weight_g), "unit.g"), *language_);
    append(all,
           measure("your.cap", language_->number(fmt::format("{:.1f}", pot.capacity_l), false), "unit.l"),
           *language_);
    say({}, std::move(all));
    say(pot.good_key);
    say(pot.next_key);
}

// What a screen shows beside its title, for those who cannot look.
void Narrator::tell_more(const screens::View& view, bool has_device) {
    const kiosk::ScreenState& state = view.state;
    if (state.panel == Panel::kCard) {
        const auto place = static_cast<std::size_t>(std::max(0, state.card));
        const bool is_on_shelf = state.card >= 0 && place < view.exhibits->size();
        const std::shared_ptr<const screens::ExhibitCard> card =
            is_on_shelf ? (*view.exhibits)[place].card : nullptr;
        const auto language = static_cast<std::size_t>(language_ - view.languages->data());
        if (card && language < card->lines.size())
            for (const std::string& line : card->lines[language])
                say({}, line);
    }
    if (state.panel != Panel::kNone) return;
    if (state.screen == Screen::kChoose && !std::exchange(has_told_keys_, true)) {
        say("ear.keys");
        if (has_device) say("ear.strokes");
    }
    if (state.screen == Screen::kThrow && !std::exchange(has_told_hand_, true)) {
        say("ear.hand");
        say("ear.arrows");
        if (has_device) say("ear.device");
    }
    if (state.screen == Screen::kFailure) say(visit::failure_key(state.throwing.collapse));
    if (state.screen == Screen::kYourPot && view.pot) tell_pot(*view.pot);
    if (state.screen == Screen::kKeep && state.keeping.outcome == kiosk::Keeping::Outcome::kKept) {
        say({}, kiosk::filled_in(language_->spoken("keep.no"), std::to_string(state.keeping.number)));
        if (state.keeping.phone == kiosk::Phone::kReady && view.phone) {
            std::string letters;  // each by itself
            for (const char letter : view.phone->code)
                if (std::isalnum(static_cast<unsigned char>(letter)) != 0)
                    append(letters, {letter}, *language_);
            say({}, std::move(letters));
        }
    }
}

void Narrator::tell_focus(const Hearing& now, bool is_after_line) {
    const auto& targets = now.shown.composition.targets;
    const auto count = static_cast<int>(targets.size());
    const int focus = now.focus < count ? now.focus : -1;
    const std::string name = focus >= 0 ? targets[static_cast<std::size_t>(focus)].spoken : std::string();
    const bool is_new = focus != told_focus_ || name != told_target_;
    const bool had_ring = told_focus_ >= 0;
    told_focus_ = focus;
    told_target_ = name;
    // Of the arrow keys, if a device's strokes did not move the ring.
    const bool by_keys = !ring_is_devices_;
    if (is_new) ring_is_devices_ = now.device_is_at_buttons.value_or(false);
    if (focus < 0 && is_new && had_ring && by_keys && visit::finger_is_hand(now.shown.view->state))
        say("ear.back", language_->spoken("ear.back"), !is_after_line);
    if (focus < 0 || !(is_new || now.asks_where)) return;
    const screens::Target& target = targets[static_cast<std::size_t>(focus)];
    if (target.button == kiosk::Button::kDigit && !now.is_private) return;
    std::string text = name;
    append(text,
           kiosk::filled_in(language_->spoken("ear.place"), std::to_string(focus + 1), std::to_string(count)),
           *language_);
    say(target.key, std::move(text), !is_after_line);
    // A language is named by its own voice.
    const auto place = static_cast<std::size_t>(std::max(0, target.value));
    const auto& languages = *now.shown.view->languages;
    if (target.button == kiosk::Button::kLanguage && place < languages.size()) {
        due_.back().language = languages[place].code();
        due_.back().text = name;
    }
}

Narrator::Clay Narrator::clay_of(const haptic::Snapshot& snapshot) {
    const pot::Pot& shape = *snapshot.pot;
    const auto tens = 10 * static_cast<int>(std::lround(10.0 * std::clamp(snapshot.load.index, 0.0, 1.0)));
    return {.is_solid = is_solid(shape),
            .high_mm = static_cast<int>(std::lround(shape.height_mm)),
            .wall_mm = static_cast<int>(std::lround(across_wall(shape).thickest_mm)),
            .load_percent = tens >= kMuchLoadPercent ? tens : 0};
}

void Narrator::tell_tip(const Hearing& now) {
    using Where = TipPlace::Where;
    // A tip on its way is not told, nor more places than one can follow.
    constexpr double kStaysS = 0.35;
    constexpr double kEveryS = 1.5;
    constexpr std::array kWhere{"ear.buttons", "ear.middle", "ear.rim",     "ear.right", "ear.left",
                                "ear.front",   "ear.behind", "ear.outside", "ear.inside"};
    constexpr std::array kHeights{"ear.base", "ear.halfway", "ear.top"};
    if (!now.device_is_at_buttons) {
        tip_.reset();
        told_tip_.reset();
        return;
    }
    const TipPlace tip = tip_place(now.snapshot, *now.device_is_at_buttons, tip_);
    if (tip_ != tip) tip_s_ = now.now_s;
    tip_ = tip;
    if (now.is_quiet && due_.empty()) is_explaining_ = false;
    const bool is_elsewhere = !told_tip_ || tip.where != told_tip_->where || now.asks_where;
    const bool is_due = tip != told_tip_ && now.now_s - tip_s_ >= kStaysS &&
                        now.now_s - told_tip_s_ >= kEveryS &&
                        (now.is_quiet ? due_.empty() : is_elsewhere && !is_explaining_);
    if (!is_due && !now.asks_where) return;
    std::string text;
    const auto add = [&](std::string_view key) { append(text, language_->spoken(key), *language_); };
    if (is_elsewhere) add(kWhere.at(static_cast<std::size_t>(tip.where)));
    const bool has_height = tip.where == Where::kOutside || tip.where == Where::kInside;
    if (has_height && (is_elsewhere || tip.height != told_tip_->height))
        add(kHeights.at(static_cast<std::size_t>(tip.height)));
    if (is_elsewhere ? tip.touches : tip.touches != told_tip_->touches)
        add(tip.touches ? "ear.touching" : "ear.off");
    told_tip_ = tip;
    told_tip_s_ = now.now_s;
    say({}, std::move(text), is_elsewhere);
}

// One sentence, of what has changed by more than little.
void Narrator::tell_clay(const Hearing& now) {
    if (!throws_clay(now.shown.view->state)) {
        told_clay_.reset();
        told_tip_.reset();
        told_marker_ = MarkerPlace::kNone;
        return;
    }
    const MarkerPlace before = std::exchange(told_marker_, now.marker);
    if (now.marker != before && now.marker == MarkerPlace::kRim)
        say("ear.rim", language_->spoken("ear.rim"), true);
    if (now.marker != before && now.marker == MarkerPlace::kMiddle)
        say("ear.middle", language_->spoken("ear.middle"), true);
    tell_tip(now);
    const bool force_rests = now.shown.view->state.force_rests;
    if (force_rests && !told_force_rests_) say("dev.rest");
    told_force_rests_ = force_rests;
    tell_guard(now);
    const Clay clay = clay_of(now.snapshot);
    if (!told_clay_) told_clay_ = clay;
    Clay& told = *told_clay_;
    const bool is_due = now.is_quiet && due_.empty() && now.now_s - clay_s_ >= kClayEveryS;
    if (!is_due && !now.asks_where) return;
    std::string text;
    const auto add = [&](bool has_changed, std::string_view key, int n) {
        if (has_changed || now.asks_where)
            append(text, kiosk::filled_in(language_->spoken(key), std::to_string(n)), *language_);
        return has_changed || now.asks_where;
    };
    if (add(clay.is_solid != told.is_solid, clay.is_solid ? "ear.solid" : "ear.open", 0))
        told.is_solid = clay.is_solid;
    constexpr int kMmPerCm = 10;
    if (add(std::abs(clay.high_mm - told.high_mm) >= kHighMm, "ear.high",
            static_cast<int>(std::lround(static_cast<double>(clay.high_mm) / kMmPerCm))))
        told.high_mm = clay.high_mm;
    if (!clay.is_solid && add(std::abs(clay.wall_mm - told.wall_mm) >= kWallMm, "ear.wall", clay.wall_mm))
        told.wall_mm = clay.wall_mm;
    const bool is_heavier = clay.load_percent >= told.load_percent + kLoadPercent;
    if (clay.load_percent > 0 && add(is_heavier, "ear.load", clay.load_percent))
        told.load_percent = clay.load_percent;
    told.load_percent = std::min(told.load_percent, clay.load_percent);
    if (text.empty()) return;
    clay_s_ = now.now_s;
    say({}, std::move(text));
}

// Why the clay follows only in part; not the same again while a hand goes on trying.
void Narrator::tell_guard(const Hearing& now) {
    if (now.guard == screens::CueGuard::kNone) return;
    const double since_s = now.now_s - guard_s_;
    const bool is_due = now.guard != told_guard_ || since_s >= kSameGuardEveryS;
    if (!now.asks_where && (!is_due || !now.is_quiet || !due_.empty())) return;
    told_guard_ = now.guard;
    guard_s_ = now.now_s;
    say(screens::key_of(now.guard));
}

void Narrator::tell_staff(const Hearing& now) {
    const screens::View& view = *now.shown.view;
    const kiosk::Staff& staff = view.state.staff;
    // Figures that change by themselves are not told again.
    const std::string line =
        fmt::format("{}/{}/{}/{}/{}/{}", static_cast<int>(view.state.panel), static_cast<int>(staff.page),
                    staff.first_line, static_cast<int>(staff.question), staff.digits, staff.was_wrong);
    const bool is_new = line != told_line_ || now.asks_where;
    told_line_ = line;
    std::string all;
    for (const std::string& words : now.shown.composition.told)
        append(all, words, *language_);
    if (is_new) say({}, std::move(all), true);
    if (view.staff_notice != told_notice_ && !is_new) say({}, view.staff_notice, true);
    told_notice_ = view.staff_notice;
    tell_focus(now, is_new);
}

std::vector<SaidLine> Narrator::look(const Hearing& now) {
    const screens::View& view = *now.shown.view;
    language_ = &language_of(view);
    if (is_staffs(view.state)) {
        language_ = &kiosk::built_in_languages().front();
        tell_staff(now);
        return std::exchange(due_, {});
    }
    if (visit::step_of(view.state.screen).whose == visit::Whose::kNobody)
        has_told_keys_ = has_told_hand_ = false;
    const bool is_new = tell_line(view, now.asks_where);
    is_explaining_ = is_explaining_ || is_new;
    if (is_new) tell_more(view, now.has_device);
    tell_focus(now, is_new);
    tell_clay(now);
    return std::exchange(due_, {});
}

std::vector<SaidLine> Narrator::look_for_recordings(const screens::View& view) {
    language_ = &language_of(view);
    tell_line(view, false);
    for (SaidLine& line : due_)
        line.text.clear();
    return std::exchange(due_, {});
}

}  // namespace onggi::app
