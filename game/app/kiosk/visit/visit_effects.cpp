#include "game/app/kiosk/visit/visit_effects.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "game/app/kiosk/keeping/kiosk_share.h"
#include "game/clay/studio/studio_clay.h"
#include "game/heritage/jar.h"
#include "game/pot/set_aside.h"
#include "game/visit/flow/step.h"

namespace onggi::app {

namespace effect = kiosk::effect;
namespace event = kiosk::event;

namespace {

constexpr std::size_t kMostOnShelf = 6;

}  // namespace

void VisitEffects::apply(const kiosk::Effect& effect, const VisitMoment& moment) {
    const auto apply_it = [&](const auto& what) {
        if constexpr (requires { apply_one(what, moment); }) {
            apply_one(what, moment);
        } else {
            apply_one(what);
        }
    };
    std::visit(apply_it, effect);
}

void VisitEffects::apply_one(const effect::VisitBegan& /*effect*/) {
    thrown_ = false;
    kept_ = 0;
    parts_.keeper.note_attract_break();
}

void VisitEffects::apply_one(const effect::VisitEnded& ended) {
    parts_.keeper.note({.dwell_s = ended.dwell_s, .last = ended.last, .thrown = thrown_, .kept = kept_});
}

void VisitEffects::apply_one(const effect::MoveHand& move) {
    if (visit::step_of(flow_.state().screen).finger == visit::Finger::kBrush) {
        input_.lead_by_keys();
        drawing_.nudge(move.direction);
    } else {
        input_.nudge(move.direction);
    }
}

void VisitEffects::apply_one(const effect::FreshClay& /*effect*/) {
    wheel_.end_shows();
    thrown_ = true;
    wheel_.put_fresh_clay();
    wheel_.rearm_force();
    parts_.keeper.journal(wheel_.run());
}

void VisitEffects::apply_one(const effect::BeforeCollapse& /*effect*/, const VisitMoment& moment) {
    const std::uint64_t tick = wheel_.clay().began_to_fail_tick();
    wheel_.clay().expect_state(moment.snapshot);  // first, because the state may arrive at once
    parts_.keeper.go_before(tick);
}

void VisitEffects::apply_one(const effect::ShowStep& show, const VisitMoment& moment) {
    wheel_.finger().show(show.step, *moment.snapshot.pot, side_of(flow_.state()));
}

void VisitEffects::apply_one(const effect::PutBrush& brush) {
    input_.lead_by_keys();
    drawing_.put_brush(brush.down);
}

// From here on the decoration belongs to the fired pot.
void VisitEffects::apply_one(const effect::EndDrawing& /*effect*/) {
    if (!pot_) return;
    screens::FiredPot drawn_on = *pot_;
    drawn_on.shape.marks = drawing_.marks();
    drawn_on.drawn_with = drawing_.drawn_with();
    pot_ = std::make_shared<const screens::FiredPot>(std::move(drawn_on));
}

void VisitEffects::apply_one(const effect::SetAside& /*effect*/) {
    wheel_.finger().release();
    parts_.keeper.set_aside();
}

void VisitEffects::apply_one(const effect::HoldTogether& /*effect*/) {
    wheel_.finger().release();
    parts_.keeper.hold_together(jar_.mouth_mm());
}

void VisitEffects::apply_one(const effect::JoinBowls& /*effect*/, const VisitMoment& moment) {
    wheel_.clay().expect_state(moment.snapshot);
    parts_.keeper.join_bowls(
        {.shift_mm = jar_.shift_mm(moment.snapshot.wheel_direction), .mouth_mm = jar_.mouth_mm()});
}

void VisitEffects::apply_one(const effect::TakeBack& back, const VisitMoment& moment) {
    wheel_.finger().release();
    wheel_.clay().expect_state(moment.snapshot);
    parts_.keeper.take_back(back.bowl);
}

void VisitEffects::apply_one(const effect::CutOff& /*effect*/) {
    may_be_trimmed_ = true;
    wheel_.finger().release();
    parts_.keeper.cut_off();
}

void VisitEffects::apply_one(const effect::BeginTrim& /*effect*/, const VisitMoment& moment) {
    wheel_.finger().leave_clay();
    trim_.begin(moment.snapshot);
    parts_.keeper.begin_trim();
}

void VisitEffects::apply_one(const effect::EndTrim& trimmed) {
    wheel_.finger().leave_clay();
    if (trimmed.took_clay) {
        drawing_.forget_pot();
        parts_.keeper.cut_off();
    } else {
        write_session();
    }
}

void VisitEffects::apply_one(const effect::Save& /*effect*/) {
    if (!pot_) return flow_.dispatch(event::SaveFailed{});
    const int glaze = flow_.state().glaze;
    parts_.keeper.save(std::shared_ptr<const pot::Section>(pot_, &pot_->shape), glaze,
                       pot_story(*pot_, glaze, parts_.settings));
}

void VisitEffects::apply_one(const effect::Share& /*effect*/) {
    phone_way_.reset();
    const kiosk::State& state = flow_.state();
    if (!pot_ || parts_.phone == nullptr)
        return flow_.dispatch(event::Shared{state.keeping.number, kiosk::ShareOutcome::kFailed});
    parts_.phone->share(
        {.gallery_name = kept_name_, .pot = pot_, .glaze = state.glaze, .language = state.comfort.language});
}

void VisitEffects::apply_one(const effect::Wall& wall, const VisitMoment& moment) {
    if (!pot_) return;
    put_on_wall_s_ = wall.up ? moment.now_s : kLongAgoS;
    if (wall.up) {
        parts_.keeper.put_on_wall(
            {.gallery_name = kept_name_, .glaze = flow_.state().glaze, .shape = pot_->shape});
    } else {
        parts_.keeper.take_off_wall(kept_name_);
    }
}

void VisitEffects::apply_one(const effect::ForgetPot& /*effect*/) {
    pot_.reset();
    kept_place_ = {};
    drawing_.forget();
    jar_.forget();
    phone_way_.reset();
    parts_.keeper.forget();
    if (parts_.phone != nullptr) parts_.phone->forget();
}

void VisitEffects::apply_one(const effect::Resume& /*effect*/, const VisitMoment& moment) {
    wheel_.end_shows();
    thrown_ = true;
    kept_place_ = {};
    left_over_.reset();
    wheel_.rearm_force();
    wheel_.clay().expect_state(moment.snapshot);
    parts_.keeper.resume(wheel_.run());
    drawing_.remember(std::exchange(interrupted_drawing_, nullptr));
    if (interrupted_bowl_) jar_.set_aside(std::exchange(interrupted_bowl_, nullptr));
}

void VisitEffects::apply_one(const effect::KeepHouse& /*effect*/) {
    const auto language = static_cast<std::size_t>(flow_.state().house_language);
    parts_.keeper.keep(
        HouseDefaults{flow_.state().house_volume, (*parts_.settings.languages)[language].code()});
}

std::optional<std::size_t> VisitEffects::thrown_after() const {
    const std::optional<int> target = flow_.state().throwing.target;
    const std::vector<std::size_t>& places = parts_.settings.exhibit_places;
    if (!target || static_cast<std::size_t>(*target) >= places.size()) return std::nullopt;
    return places[static_cast<std::size_t>(*target)];
}

std::optional<int> VisitEffects::place_of(const std::string& target_id) const {
    const std::vector<std::size_t>& places = parts_.settings.exhibit_places;
    const auto place = std::find_if(places.begin(), places.end(), [&](std::size_t row) {
        return parts_.settings.targets[row].id == target_id;
    });
    return place != places.end() ? std::optional(static_cast<int>(place - places.begin())) : std::nullopt;
}

VisitPlace VisitEffects::place() const {
    const std::optional<std::size_t> target = thrown_after();
    return {.target = target ? parts_.settings.targets[*target].id : std::string(),
            .glaze = flow_.state().glaze,
            .is_cut_off = pot_ != nullptr || flow_.state().was_cut_off};
}

// The answer comes once after throwing, and again after trimming.
void VisitEffects::take(const KeeperAnswer::CutOff& cut) {
    const clay::StudioClay& clay = *cut.clay;
    screens::FiredPot pot =
        fired_pot(clay, parts_.settings.targets, parts_.settings.relatives, thrown_after());
    if (flow_.state().throwing.jar.step == kiosk::JarStep::kSeam)
        pot.off_round_mm = heritage::off_round_mm(clay);
    pot_ = std::make_shared<const screens::FiredPot>(std::move(pot));
    drawing_.take(cut.pot);
    // A force device cannot hold the trimmer: visitors who throw with one go on to decorating.
    const bool can_trim =
        clay::studio::foot_wall_mm(clay.rings()) > visit::kThickFootMm && parts_.devices.holder().empty();
    if (std::exchange(may_be_trimmed_, false) && can_trim) flow_.dispatch(event::ThickFoot{});
    // The film begins with the final pot.
    if (!flow_.state().trimming.is_offered) write_session();
}

void VisitEffects::write_session() {
    if (parts_.phone != nullptr) parts_.keeper.write_session(parts_.phone->session_place());
}

void VisitEffects::take(const KeeperAnswer::Interrupted& found) {
    constexpr std::array kSteps{kiosk::JarStep::kNone, kiosk::JarStep::kFirstBowl,
                                kiosk::JarStep::kSecondBowl, kiosk::JarStep::kSeam};
    interrupted_bowl_ = found.bowl;
    interrupted_drawing_ = found.drawn;
    const kiosk::JarStep step = kSteps[static_cast<std::size_t>(found.jar)];
    left_over_ = std::make_shared<const pot::Section>(pot::section_of(*found.pot));
    event::InterruptedSession session{.pot = {.target = place_of(found.place.target),
                                              .glaze = found.place.glaze,
                                              .is_cut_off = found.place.is_cut_off}};
    const std::optional<int> jar = place_of(found.jar_target);
    if (step != kiosk::JarStep::kNone && jar) session.jar = {step, *jar};
    flow_.dispatch(session);
}

void VisitEffects::take(const KeeperAnswer::SetAside& aside) {
    jar_.set_aside(aside.bowl);
    flow_.dispatch(event::SetAside{});
}

void VisitEffects::take(const KeeperAnswer::Saved& saved) {
    if (pot_) day_.insert(day_.begin(), {pot_->shape, flow_.state().glaze});
    if (day_.size() > kMostOnShelf) day_.pop_back();
    ++kept_;
    ++pots_kept_;
    kept_name_ = saved.gallery_name;
    flow_.dispatch(event::Saved{saved.number});
}

void VisitEffects::take(const kiosk::Event& event) {
    if (std::holds_alternative<event::JarStays>(event)) wheel_.clay().expect_nothing();
    flow_.dispatch(event);
}

// Ignores answers for a pot whose visitor has left.
void VisitEffects::take(const PhoneAnswer::OfPot& shared) {
    if (shared.gallery_name != kept_name_ || pot_ == nullptr) return;
    if (shared.outcome == kiosk::ShareOutcome::kReady) phone_way_ = shared.way;
    flow_.dispatch(event::Shared{flow_.state().keeping.number, shared.outcome});
}

void VisitEffects::take_answers() {
    if (wall_ && !wall_->empty() && !kiosk::is_open(parts_.settings.config, parts_.minute_of_day())) {
        wall_.reset();  // until the keeper's answer
        parts_.keeper.clear_wall();
    }
    const auto take_it = [this](const auto& what) { take(what); };
    while (const auto answer = parts_.phone != nullptr ? parts_.phone->next_answer() : nullptr) {
        if (!answer->words.empty()) flow_.say(answer->words);
        std::visit(take_it, answer->what);
    }
    if (auto drawn = drawing_.take_to_keep()) parts_.keeper.keep_drawing(std::move(*drawn));
    if (VisitPlace now = place(); now != kept_place_) {
        kept_place_ = now;
        parts_.keeper.keep_place(std::move(now));
    }
    while (const auto answer = parts_.keeper.next_answer()) {
        if (!answer->words.empty()) answer->is_trouble ? flow_.warn(answer->words) : flow_.say(answer->words);
        std::visit(take_it, answer->what);
    }
}

}  // namespace onggi::app
