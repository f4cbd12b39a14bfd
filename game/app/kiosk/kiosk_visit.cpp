#include "game/app/kiosk/kiosk_visit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "game/app/kiosk/snapshot_view.h"
#include "game/app/system/report.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Effect;
using kiosk::Event;
using kiosk::Panel;
using kiosk::Screen;

constexpr std::size_t kMostOnShelf = 6;

int screen_key(const kiosk::State& state) {
    return static_cast<int>(state.screen) * kiosk::kPanelCount + static_cast<int>(state.panel);
}

}  // namespace

KioskVisit::KioskVisit(const VisitParts& parts)
    : parts_(parts),
      desk_({.view = parts.view,
             .job = parts.job,
             .devices = parts.devices,
             .keeper = parts.keeper,
             .sound = parts.sound,
             .config = parts.settings.config,
             .start = parts.start,
             .rate_hz = parts.rate_hz}) {
    state_ = kiosk::first_state(parts.settings.rules, 0.0);
}

KioskVisit::~KioskVisit() {
    composer_.stop();
}

void KioskVisit::say(const std::string& line) {
    if (const auto words = log_.say(line, now_s_)) remark(*words);
}

void KioskVisit::fresh_clay() {
    // A full ring means that the haptic thread stands still; then the window says nothing new either.
    if (parts_.job.send(haptic::Command::kFreshLump)) ++run_;
    clay_.expect_lump(run_);
    hand_.leave_clay();
    cue_.begin();
    shown_.reset();
}

void KioskVisit::begin_show() {
    fresh_clay();
    demo_since_s_ = now_s_;
    const std::vector<Recording>& recordings = parts_.show.recordings;
    shown_ = recordings.empty() ? 0 : shows_begun_++ % recordings.size();
    // Refused where many states are on their way: then it is tried again when this one should be over.
    if (!recordings.empty())
        static_cast<void>(parts_.job.put(first_state_of(recordings[*shown_], *shown_), run_));
}

bool KioskVisit::play_show(const haptic::Snapshot& snapshot) {
    constexpr double kRestS = 3.0;
    const Show& show = parts_.show;
    if (show.recordings.empty() && !show.gesture) return false;
    const double length_s =
        show.recordings.empty() ? show.gesture->duration_s() : show.recordings[shown_.value_or(0)].seconds();
    // A recording goes by the ticks of its clay, which may be late.
    const double since_s = now_s_ - demo_since_s_;
    const auto played =
        snapshot.run == run_ ? played_s(snapshot.tick, shown_.value_or(0), parts_.rate_hz) : std::nullopt;
    if (!shown_ || played.value_or(since_s) > length_s + kRestS) begin_show();
    if (show.gesture) parts_.hand.set_target(show.gesture->at(std::min(now_s_ - demo_since_s_, length_s)));
    return true;
}

void KioskVisit::rearm_force() {
    static_cast<void>(parts_.job.send(haptic::Command::kRearmForce));
}

void KioskVisit::tell(const Event& event) {
    const Screen before = state_.screen;
    left_ = before;
    for (const Effect& effect : kiosk::step(state_, event, now_s_, parts_.settings.rules))
        carry_out(effect);
    const bool is_idle = state_.screen == Screen::kAttract;
    if (is_idle != (before == Screen::kAttract))
        static_cast<void>(parts_.job.send(is_idle ? haptic::Command::kLetGo : haptic::Command::kTakeHold));
    if (state_.screen == Screen::kAttract && before != Screen::kAttract) pointer_.forget();
}

void KioskVisit::carry_out(const Effect& effect) {
    switch (effect.kind) {
        case Effect::Kind::kStartDemo:
            demo_runs_ = true;
            begin_show();
            break;
        case Effect::Kind::kFreshClay:
            demo_runs_ = false;
            thrown_ = true;
            fresh_clay();
            rearm_force();  // a person's wish, so it takes a person's stop back too
            parts_.keeper.journal(run_);
            break;
        case Effect::Kind::kUndo:
            parts_.keeper.undo();
            break;
        case Effect::Kind::kBeforeCollapse: {
            const std::uint64_t tick = clay_.began_to_fail_tick();
            clay_.expect_state(parts_.job.newest_snapshot());  // first: it may be there in no time
            parts_.keeper.go_before(tick);
            break;
        }
        case Effect::Kind::kMoveHand:
            nudge_hand(static_cast<Button>(effect.value));
            break;
        case Effect::Kind::kShowStep:
            hand_.show(static_cast<ShownStep>(effect.value), *parts_.job.newest_snapshot().shape, side());
            break;
        case Effect::Kind::kStopShow:
            hand_.stop_showing();
            break;
        case Effect::Kind::kCutOff:
            hand_.release();
            parts_.keeper.cut_off();
            break;
        case Effect::Kind::kSave:
            if (pot_) {
                parts_.keeper.save(std::shared_ptr<const screens::PotShape>(pot_, &pot_->shape),
                                   state_.glaze);
            } else {
                tell({Event::Kind::kSaveFailed});
            }
            break;
        case Effect::Kind::kForgetPot:
            pot_.reset();
            parts_.keeper.forget();
            break;
        case Effect::Kind::kRestart:
        case Effect::Kind::kQuit:
            quits_ = true;
            restarts_ = effect.kind == Effect::Kind::kRestart;
            break;
        case Effect::Kind::kResume:
            demo_runs_ = false;
            thrown_ = true;
            rearm_force();
            clay_.expect_state(parts_.job.newest_snapshot());
            parts_.keeper.resume(run_);
            break;
        case Effect::Kind::kDropLeftOver:
            parts_.keeper.drop_left_over();
            break;
        case Effect::Kind::kSetVolume:
            set_volume(effect.value);
            break;
        case Effect::Kind::kKeepHouse:
            parts_.keeper.keep(HouseWish{
                state_.house_volume,
                (*parts_.settings.languages)[static_cast<std::size_t>(state_.house_language)].code()});
            break;
        case Effect::Kind::kVisitBegan:
            thrown_ = false;
            kept_ = 0;
            parts_.keeper.note_attract_break();
            break;
        case Effect::Kind::kVisitEnded:
            parts_.keeper.note({.dwell_s = effect.value, .last = left_, .thrown = thrown_, .kept = kept_});
            break;
        case Effect::Kind::kDeletePot:
            desk_.delete_pot(effect.value);
            break;
        case Effect::Kind::kTestForce:
            desk_.test_force();
            break;
        case Effect::Kind::kTestSound:
            desk_.test_sound();
            break;
    }
}

void KioskVisit::take_clay(const haptic::Snapshot& snapshot) {
    const bool touches = snapshot.result.forces.contacts > 0;
    // Who has a hand control in the hand need not find the screen: touching the clay is choosing.
    if (state_.screen == Screen::kChoose && state_.panel == Panel::kNone && touches &&
        !parts_.devices.holder().empty()) {
        tell({Event::Kind::kClayTouched});
        return;
    }
    if (state_.screen != Screen::kThrow) return;
    // What the wheel's own hands do is not the visitor's touch.
    const bool holds = parts_.devices.holder().empty() ? hand_.works() && !hand_.shows() : touches;
    if (touches && holds) tell({Event::Kind::kClayTouched});
    if (holds != state_.throwing.held) tell({Event::Kind::kHeld, Button::kNone, holds ? 1 : 0});
    if (state_.throwing.shown && !hand_.shows()) tell({Event::Kind::kShowOver});
    const std::optional<ClayNews> news = clay_.look(snapshot, state_.throwing.warning);
    if (!news) return;
    tell({Event::Kind::kProgress, Button::kNone, news->steps_done});
    tell({Event::Kind::kWarned, Button::kNone, static_cast<int>(news->warning)});
    if (!news->gave_way) return;
    hand_.release();
    tell({Event::Kind::kCollapsed, Button::kNone, static_cast<int>(*news->gave_way)});
}

void KioskVisit::take_fault(const haptic::Snapshot& snapshot) {
    const KioskFault::Advice advice = fault_.look(snapshot.fault, now_s_);
    if (advice.force_rests != state_.force_rests) {
        say(advice.force_rests ? "kiosk: no force for the hand (" +
                                     std::string(haptics::words_for(snapshot.fault)) + "); the clay goes on"
                               : std::string("kiosk: the hand has its force again"));
        tell({advice.force_rests ? Event::Kind::kForceRests : Event::Kind::kForceBack});
    }
    if (advice.wheel_rests && state_.screen != Screen::kFault) {
        say("kiosk: the clay's force is no number; the wheel rests");
        tell({Event::Kind::kFault});
    }
    if (advice.take_back && advice.wheel_rests) fresh_clay();
    if (advice.take_back) rearm_force();
    // Not under the staff's eyes.
    if (!advice.wheel_rests && state_.screen == Screen::kFault && state_.panel == Panel::kNone)
        tell({Event::Kind::kFaultOver});
}

void KioskVisit::take_answers() {
    while (const auto answer = parts_.keeper.next_answer()) {
        if (!answer->words.empty()) say(answer->words);
        switch (answer->kind) {
            case KeeperAnswer::Kind::kCutOff:
                pot_ = std::make_shared<const screens::FiredPot>(
                    fired_pot(*answer->clay, parts_.settings.targets, parts_.settings.relatives));
                break;
            case KeeperAnswer::Kind::kSaved:
                if (pot_) day_.insert(day_.begin(), {pot_->shape, state_.glaze});
                if (day_.size() > kMostOnShelf) day_.pop_back();
                ++kept_;
                ++pots_kept_;
                tell({Event::Kind::kSaved, Button::kNone, answer->number});
                break;
            case KeeperAnswer::Kind::kSaveFailed:
                tell({Event::Kind::kSaveFailed});
                break;
            case KeeperAnswer::Kind::kSurvey:
                desk_.take(*answer);
                break;
            case KeeperAnswer::Kind::kLeftOver:
                tell({Event::Kind::kLeftOver});
                break;
            case KeeperAnswer::Kind::kNotPut:
                clay_.expect_nothing();
                break;
            case KeeperAnswer::Kind::kRemark:
                break;
        }
    }
}

void KioskVisit::move_hand(const haptic::Snapshot& snapshot, double dt_s) {
    // Under the staff's panel nothing moves by itself, so that a hand can be tested.
    if (state_.panel == Panel::kPin || state_.panel == Panel::kStaff) {
        parts_.hand.set_target(resting_hand());
        if (demo_runs_ && shown_) fresh_clay();
        return;
    }
    if (demo_runs_ && play_show(snapshot)) return;
    const kiosk::Throwing& throwing = state_.throwing;
    haptics::ToolState tool =
        hand_.wish({throwing.tool, throwing.water, throwing.speed}, *snapshot.shape, dt_s);
    const bool throws = state_.screen == Screen::kThrow || state_.screen == Screen::kFailure ||
                        state_.screen == Screen::kChoose || state_.screen == Screen::kAttract;
    tool.wheel_button = throws && state_.panel != Panel::kIdle;
    parts_.hand.set_target(tool);
}

Result<void> KioskVisit::frame(double now_s) {
    constexpr double kMsPerS = 1e3;
    const double since_last_ms = kMsPerS * (now_s - now_s_);
    const double dt_s = std::clamp(now_s - now_s_, 0.0, 0.1);
    now_s_ = now_s;
    if (!std::exchange(has_begun_, true)) state_ = kiosk::first_state(parts_.settings.rules, now_s);
    const haptic::Snapshot& snapshot = parts_.job.newest_snapshot();
    desk_.see_frame(now_s, since_last_ms, snapshot);
    tell({Event::Kind::kTick});
    take_input(snapshot, dt_s);
    take_clay(snapshot);
    take_fault(snapshot);
    take_answers();
    move_hand(snapshot, dt_s);
    parts_.sound.hear(snapshot, is_closed(), kiln_burns());
    aim_camera(snapshot);
    compose(snapshot);
    stage_.take(composer_.latest(), now_s_);
    composer_.hold(pointer_.rests_on_scene());
    stage_.turn(composer_.turned());

    forces_.look(snapshot, now_s_);
    const std::optional<screens::Band> band = warning_band(snapshot);
    const std::optional<screens::Cue> cue = this->cue(snapshot);
    wheel::PotView pot = pot_view(snapshot);
    const std::optional<screens::ForceFrame> forces = force_frame(snapshot, pot);
    const screens::StageFrame stage_frame{.now_s = now_s_,
                                          .pressed = pointer_.pressed(),
                                          .band = band ? &*band : nullptr,
                                          .cue = cue ? &*cue : nullptr,
                                          .forces = forces ? &*forces : nullptr};
    const ui::DrawList& list = stage_.draw(stage_frame);
    const render::Overlay overlay{.list = &list,
                                  .uploads = stage_.uploads(),
                                  .atlas_side_px = stage_.atlas_side_px(),
                                  .scene_rests = stage_.scene_rests(),
                                  .covers = stage_.covers()};
    if (!demo_runs_ && (state_.panel != Panel::kNone || state_.screen != Screen::kThrow))
        pot.hand.shown = pot.second_hand.shown = false;
    auto drawn = parts_.view.draw(pot, dt_s, &overlay);
    if (!drawn) return drawn.error();
    if (*drawn) ++frames_shown_;
    for (const std::string& line : parts_.view.take_remarks())
        say(line);
    const screens::Composed* shown = stage_.shown();
    if (shown != nullptr) {
        name_window(shown->view->state, snapshot.shape->height_mm);
        const auto& languages = *shown->view->languages;
        const auto language = static_cast<std::size_t>(shown->view->state.comfort.language);
        pointer_.look_at(&shown->composition, screen_key(shown->view->state),
                         languages[language].right_to_left());
    }
    return {};
}

// Nobody sees the title of a full screen; scripts that play a visitor read it, who have no eyes for the clay.
void KioskVisit::name_window(const kiosk::State& shown, double clay_mm) {
    std::string title = "Onggi - " + std::string(kiosk::name_of(shown.screen));
    if (shown.panel != Panel::kNone) title += " - " + std::string(kiosk::name_of(shown.panel));
    if (shown.panel == Panel::kLanguage) {
        title += " " + (*parts_.settings.languages)[static_cast<std::size_t>(shown.comfort.language)].code();
        if (shown.comfort.reach) title += " low";
    }
    if (shown.screen == Screen::kThrow && shown.panel == Panel::kNone)
        title += fmt::format(" - {} of {}, {:.0f} mm{}", shown.throwing.steps_done, kiosk::kTeachingSteps,
                             clay_mm, shown.throwing.shown ? ", shown" : "");
    if (pointer_.focus() >= 0) title += " [" + std::to_string(pointer_.focus()) + "]";
    if (title == title_) return;
    title_ = title;
    parts_.view.set_title(title);
}

}  // namespace onggi::app
