#include "game/app/kiosk/visit/visit_effects.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "game/clay/studio/studio_clay.h"
#include "game/heritage/jar.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Effect;
using kiosk::Event;

constexpr std::size_t kMostOnShelf = 6;

}  // namespace

void VisitEffects::apply(const Effect& effect, const VisitMoment& moment, kiosk::Screen left) {
    switch (effect.kind) {
        case Effect::Kind::kVisitBegan:
            thrown_ = false;
            kept_ = 0;
            parts_.keeper.note_attract_break();
            break;
        case Effect::Kind::kVisitEnded:
            parts_.keeper.note({.dwell_s = effect.value, .last = left, .thrown = thrown_, .kept = kept_});
            break;
        case Effect::Kind::kMoveHand:
            move_hand(static_cast<Button>(effect.value));
            break;
        case Effect::Kind::kStartDemo:
        case Effect::Kind::kFreshClay:
        case Effect::Kind::kUndo:
        case Effect::Kind::kBeforeCollapse:
        case Effect::Kind::kCutRim:
        case Effect::Kind::kShowStep:
        case Effect::Kind::kStopShow:
            apply_to_clay(effect, moment);
            break;
        case Effect::Kind::kBeginDrawing:
        case Effect::Kind::kUndoStroke:
        case Effect::Kind::kClearDrawing:
        case Effect::Kind::kPutBrush:
        case Effect::Kind::kEndDrawing:
            apply_to_drawing(effect, moment);
            break;
        case Effect::Kind::kBeginJar:
        case Effect::Kind::kSetAside:
        case Effect::Kind::kHoldTogether:
        case Effect::Kind::kJoinBowls:
        case Effect::Kind::kTakeBack:
            apply_to_jar(effect, moment);
            break;
        case Effect::Kind::kCutOff:
        case Effect::Kind::kBeginTrim:
        case Effect::Kind::kEndTrim:
        case Effect::Kind::kSave:
        case Effect::Kind::kShare:
        case Effect::Kind::kWall:
        case Effect::Kind::kForgetPot:
            apply_to_done_pot(effect, moment);
            break;
        case Effect::Kind::kResume:
            resume(moment);
            break;
        case Effect::Kind::kDropInterrupted:
            parts_.keeper.drop_interrupted_session();
            break;
        case Effect::Kind::kSetVolume:
        case Effect::Kind::kKeepHouse:
        case Effect::Kind::kDeletePot:
        case Effect::Kind::kWithdrawCode:
        case Effect::Kind::kTestForce:
        case Effect::Kind::kTestSound:
        case Effect::Kind::kRestart:
        case Effect::Kind::kQuit:
            apply_to_kiosk(effect);
            break;
    }
}

void VisitEffects::move_hand(Button direction) {
    if (flow_.state().screen == kiosk::Screen::kDecorate) {
        input_.lead_by_keys();
        drawing_.nudge(direction);
    } else {
        input_.nudge(direction);
    }
}

void VisitEffects::apply_to_clay(const Effect& effect, const VisitMoment& moment) {
    switch (effect.kind) {
        case Effect::Kind::kStartDemo:
            wheel_.begin_show(moment.now_s);
            break;
        case Effect::Kind::kFreshClay:
            wheel_.end_shows();
            thrown_ = true;
            wheel_.put_fresh_clay();
            wheel_.rearm_force();
            parts_.keeper.journal(wheel_.run());
            break;
        case Effect::Kind::kUndo:
            parts_.keeper.undo();
            break;
        case Effect::Kind::kBeforeCollapse: {
            const std::uint64_t tick = wheel_.clay().began_to_fail_tick();
            wheel_.clay().expect_state(moment.snapshot);  // first: it may be there in no time
            parts_.keeper.go_before(tick);
            break;
        }
        case Effect::Kind::kCutRim:
            wheel_.finger().cut_rim();
            break;
        case Effect::Kind::kShowStep:
            wheel_.finger().show(static_cast<ShownStep>(effect.value), *moment.snapshot.pot,
                                 side_of(flow_.state()));
            break;
        case Effect::Kind::kStopShow:
            wheel_.finger().stop_showing();
            break;
        default:
            break;
    }
}

void VisitEffects::apply_to_drawing(const Effect& effect, const VisitMoment& moment) {
    switch (effect.kind) {
        case Effect::Kind::kBeginDrawing:
            drawing_.begin(moment.snapshot.wheel_direction);
            break;
        case Effect::Kind::kUndoStroke:
            drawing_.undo();
            break;
        case Effect::Kind::kClearDrawing:
            drawing_.clear();
            break;
        case Effect::Kind::kPutBrush:
            input_.lead_by_keys();
            drawing_.put_brush(effect.value != 0);
            break;
        case Effect::Kind::kEndDrawing:
            fire_drawing();
            break;
        default:
            break;
    }
}

void VisitEffects::apply_to_jar(const Effect& effect, const VisitMoment& moment) {
    switch (effect.kind) {
        case Effect::Kind::kBeginJar:
            parts_.keeper.begin_jar(jar_.target_id());
            break;
        case Effect::Kind::kSetAside:
            wheel_.finger().release();
            parts_.keeper.set_aside();
            break;
        case Effect::Kind::kHoldTogether:
            wheel_.finger().release();
            parts_.keeper.hold_together(jar_.join(moment.snapshot.wheel_direction).mouth_mm);
            break;
        case Effect::Kind::kJoinBowls:
            wheel_.clay().expect_state(moment.snapshot);
            parts_.keeper.join_bowls(jar_.join(moment.snapshot.wheel_direction));
            break;
        case Effect::Kind::kTakeBack:
            wheel_.finger().release();
            wheel_.clay().expect_state(moment.snapshot);
            parts_.keeper.take_back(effect.value);
            break;
        default:
            break;
    }
}

void VisitEffects::apply_to_done_pot(const Effect& effect, const VisitMoment& moment) {
    switch (effect.kind) {
        case Effect::Kind::kCutOff:
            may_be_trimmed_ = true;
            wheel_.finger().release();
            parts_.keeper.cut_off();
            break;
        case Effect::Kind::kBeginTrim:
            wheel_.finger().leave_clay();
            trim_.begin(moment.snapshot);
            parts_.keeper.begin_trim();
            break;
        case Effect::Kind::kEndTrim:
            wheel_.finger().leave_clay();
            if (effect.value == 1) {
                drawing_.forget_pot();
                parts_.keeper.cut_off();
            } else {
                write_session();
            }
            break;
        case Effect::Kind::kSave:
            save();
            break;
        case Effect::Kind::kShare:
            share();
            break;
        case Effect::Kind::kWall:
            move_on_wall(effect.value != 0, moment.now_s);
            break;
        case Effect::Kind::kForgetPot:
            pot_.reset();
            drawing_.forget();
            jar_.forget();
            phone_way_.reset();
            parts_.keeper.forget();
            if (parts_.phone != nullptr) parts_.phone->forget();
            break;
        default:
            break;
    }
}

void VisitEffects::resume(const VisitMoment& moment) {
    wheel_.end_shows();
    thrown_ = true;
    wheel_.rearm_force();
    wheel_.clay().expect_state(moment.snapshot);
    parts_.keeper.resume(wheel_.run());
    drawing_.remember(std::exchange(interrupted_drawing_, nullptr));
    if (interrupted_bowl_) jar_.set_aside(std::exchange(interrupted_bowl_, nullptr));
}

void VisitEffects::apply_to_kiosk(const Effect& effect) {
    switch (effect.kind) {
        case Effect::Kind::kSetVolume:
            parts_.sound.set_volume(effect.value / kLoudestStep);
            break;
        case Effect::Kind::kKeepHouse:
            keep_house();
            break;
        case Effect::Kind::kDeletePot:
            desk_.delete_pot(effect.value);
            break;
        case Effect::Kind::kWithdrawCode:
            desk_.withdraw_code(effect.value);
            break;
        case Effect::Kind::kTestForce:
            desk_.test_force();
            break;
        case Effect::Kind::kTestSound:
            desk_.test_sound();
            break;
        case Effect::Kind::kRestart:
        case Effect::Kind::kQuit:
            quits_ = true;
            restarts_ = effect.kind == Effect::Kind::kRestart;
            break;
        default:
            break;
    }
}

std::optional<std::size_t> VisitEffects::thrown_after() const {
    const std::optional<int> target = flow_.state().throwing.target;
    const std::vector<std::size_t>& places = parts_.settings.exhibit_places;
    if (!target || static_cast<std::size_t>(*target) >= places.size()) return std::nullopt;
    return places[static_cast<std::size_t>(*target)];
}

// Once when the throwing is over, and again where its foot was turned.
void VisitEffects::take(const KeeperAnswer::CutOff& cut) {
    const clay::StudioClay& clay = *cut.clay;
    screens::FiredPot pot =
        fired_pot(clay, parts_.settings.targets, parts_.settings.relatives, thrown_after());
    if (flow_.state().throwing.jar.step == kiosk::JarStep::kSeam)
        pot.off_round_mm = heritage::off_round_mm(clay);
    pot_ = std::make_shared<const screens::FiredPot>(std::move(pot));
    drawing_.take(cut.pot);
    // A hand control holds no trimmer: whoever throws with one goes on to decorate.
    const bool can_trim =
        clay::studio::foot_wall_mm(clay.rings()) > kThickFootMm && parts_.devices.holder().empty();
    if (std::exchange(may_be_trimmed_, false) && can_trim) flow_.dispatch({Event::Kind::kThickFoot});
    // Its film is made of what it is in the end.
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
    const std::vector<std::size_t>& places = parts_.settings.exhibit_places;
    const auto place = std::find_if(places.begin(), places.end(), [&](std::size_t row) {
        return parts_.settings.targets[row].id == found.jar_target;
    });
    const bool is_jar = step != kiosk::JarStep::kNone && place != places.end();
    flow_.dispatch({Event::Kind::kInterruptedSession, Button::kNone,
                    is_jar ? kiosk::interrupted_jar(step, static_cast<int>(place - places.begin())) : 0});
}

void VisitEffects::take(const KeeperAnswer::SetAside& aside) {
    jar_.set_aside(aside.bowl);
    flow_.dispatch({Event::Kind::kSetAside});
}

void VisitEffects::take(const KeeperAnswer::Saved& saved) {
    if (pot_) day_.insert(day_.begin(), {pot_->shape, flow_.state().glaze});
    if (day_.size() > kMostOnShelf) day_.pop_back();
    ++kept_;
    ++pots_kept_;
    kept_name_ = saved.gallery_name;
    flow_.dispatch({Event::Kind::kSaved, Button::kNone, saved.number});
}

void VisitEffects::take(const Event& event) {
    if (event.kind == Event::Kind::kJarStays) wheel_.clay().expect_nothing();
    flow_.dispatch(event);
}

// What was drawn goes with the pot from here on.
void VisitEffects::fire_drawing() {
    if (!pot_) return;
    screens::FiredPot drawn_on = *pot_;
    drawn_on.shape.marks = drawing_.marks();
    drawn_on.drawn_with = drawing_.drawn_with();
    pot_ = std::make_shared<const screens::FiredPot>(std::move(drawn_on));
}

void VisitEffects::save() {
    if (!pot_) return flow_.dispatch({Event::Kind::kSaveFailed});
    parts_.keeper.save(std::shared_ptr<const pot::Section>(pot_, &pot_->shape), flow_.state().glaze);
}

void VisitEffects::share() {
    phone_way_.reset();
    const kiosk::State& state = flow_.state();
    if (!pot_ || parts_.phone == nullptr)
        return flow_.dispatch({Event::Kind::kShareFailed, Button::kNone, state.keeping.number});
    parts_.phone->share(
        {.gallery_name = kept_name_, .pot = pot_, .glaze = state.glaze, .language = state.comfort.language});
}

void VisitEffects::move_on_wall(bool up, double now_s) {
    if (!pot_) return;
    put_on_wall_s_ = up ? now_s : kLongAgoS;
    if (up) {
        parts_.keeper.put_on_wall(
            {.gallery_name = kept_name_, .glaze = flow_.state().glaze, .shape = pot_->shape});
    } else {
        parts_.keeper.take_off_wall(kept_name_);
    }
}

// Of a pot whose visitor has gone, nobody here wants to know.
void VisitEffects::take(const PhoneAnswer::OfPot& shared) {
    if (shared.gallery_name != kept_name_ || pot_ == nullptr) return;
    if (shared.event == Event::Kind::kShared) phone_way_ = shared.way;
    flow_.dispatch({shared.event, Button::kNone, flow_.state().keeping.number});
}

void VisitEffects::keep_house() {
    const auto language = static_cast<std::size_t>(flow_.state().house_language);
    parts_.keeper.keep(
        HouseDefaults{flow_.state().house_volume, (*parts_.settings.languages)[language].code()});
}

void VisitEffects::take_answers() {
    if (wall_ && !wall_->empty() && !kiosk::is_open(parts_.settings.config, parts_.minute_of_day())) {
        wall_.reset();  // until the keeper says so too
        parts_.keeper.clear_wall();
    }
    const auto take_it = [this](const auto& what) { take(what); };
    while (const auto answer = parts_.phone != nullptr ? parts_.phone->next_answer() : nullptr) {
        if (!answer->words.empty()) flow_.say(answer->words);
        std::visit(take_it, answer->what);
    }
    if (auto drawn = drawing_.take_to_keep()) parts_.keeper.keep_drawing(std::move(*drawn));
    while (const auto answer = parts_.keeper.next_answer()) {
        if (!answer->words.empty()) answer->is_trouble ? flow_.warn(answer->words) : flow_.say(answer->words);
        std::visit(take_it, answer->what);
    }
}

}  // namespace onggi::app
