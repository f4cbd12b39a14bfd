#include "game/app/kiosk_visit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "game/app/command_line.h"
#include "game/app/snapshot_view.h"

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Effect;
using kiosk::Event;
using kiosk::Panel;
using kiosk::Screen;

constexpr double kNudgeMm = 5.0;
constexpr std::size_t kMostOnShelf = 6;
constexpr double kSunkShare = 0.8;  // of the height at which it still stood
constexpr double kFrameS = 1.0 / 60.0;

int screen_key(const kiosk::State& state) {
    return static_cast<int>(state.screen) * kiosk::kPanelCount + static_cast<int>(state.panel);
}

dvec3 nudge_of(Button button) {
    switch (button) {
        case Button::kHandUp:
            return {0.0, kNudgeMm, 0.0};
        case Button::kHandDown:
            return {0.0, -kNudgeMm, 0.0};
        case Button::kHandIn:
            return {-kNudgeMm, 0.0, 0.0};
        case Button::kHandOut:
            return {kNudgeMm, 0.0, 0.0};
        default:
            return dvec3(0.0);
    }
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
    static_cast<void>(parts_.job.send(haptic::Command::kRearmForce));
    lesson_.begin();
    collapse_tick_ = 0;
}

std::optional<dvec3> KioskVisit::place_at(vec2 px) const {
    return parts_.view.tool_target_mm(double{px.x}, double{px.y});
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
            demo_since_s_ = now_s_;
            fresh_clay();
            break;
        case Effect::Kind::kFreshClay:
            demo_runs_ = false;
            thrown_ = true;
            fresh_clay();
            parts_.keeper.journal(run_);
            break;
        case Effect::Kind::kUndo:
            parts_.keeper.undo();
            break;
        case Effect::Kind::kBeforeCollapse:
            parts_.keeper.go_before(collapse_tick_);
            collapse_tick_ = 0;
            break;
        case Effect::Kind::kMoveHand:
            hand_.nudge(nudge_of(static_cast<Button>(effect.value)), *parts_.job.newest_snapshot().shape);
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
            static_cast<void>(parts_.job.send(haptic::Command::kRearmForce));
            lesson_.begin();
            collapse_tick_ = 0;
            parts_.keeper.resume(run_);
            break;
        case Effect::Kind::kDropLeftOver:
            parts_.keeper.drop_left_over();
            break;
        case Effect::Kind::kSetVolume:
            set_volume(effect.value);
            break;
        case Effect::Kind::kKeepVolume:
            parts_.keeper.keep_volume(effect.value);
            break;
        case Effect::Kind::kVisitBegan:
            thrown_ = kept_ = false;
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

void KioskVisit::take_news(const PointerNews& news, const haptic::Snapshot& snapshot) {
    const bool scene_is_open =
        state_.panel == Panel::kNone && (state_.screen == Screen::kThrow || state_.screen == Screen::kChoose);
    switch (news.kind) {
        case PointerNews::Kind::kNone:
            break;
        case PointerNews::Kind::kLife:
            tell({Event::Kind::kInput});
            break;
        case PointerNews::Kind::kPressed:
            tell(Event::pressed(news.button, news.value));
            break;
        case PointerNews::Kind::kHandDown:
            if (state_.panel == Panel::kNone && state_.screen == Screen::kThrow) {
                tell({Event::Kind::kClayTouched});
                if (const auto place = place_at(news.at_px)) hand_.press(*place, *snapshot.shape);
            } else {
                tell({Event::Kind::kInput});
            }
            break;
        case PointerNews::Kind::kHandMoved:
            if (!scene_is_open) break;
            tell({Event::Kind::kInput});
            if (const auto place = place_at(news.at_px)) hand_.drag(*place);
            break;
        case PointerNews::Kind::kHandUp:
            hand_.release();
            break;
        case PointerNews::Kind::kHovered:
            if (const auto place = place_at(news.at_px)) hand_.hover(*place, parts_.view.towards_eye(*place));
            break;
        case PointerNews::Kind::kNudged:
            if (state_.panel == Panel::kNone && state_.screen == Screen::kThrow) {
                tell({Event::Kind::kClayTouched});
                hand_.nudge(nudge_of(news.button), *snapshot.shape);
            }
            break;
        case PointerNews::Kind::kCornerHeld:
            tell({Event::Kind::kCornerHeld});
            break;
        case PointerNews::Kind::kCloseAsked:
            tell({Event::Kind::kCloseAsked});
            break;
        case PointerNews::Kind::kFullScreen:
            if (parts_.settings.rules.locked) break;
            full_screen_ = !full_screen_;
            parts_.view.set_full_screen(full_screen_);
            break;
    }
}

void KioskVisit::take_input(const haptic::Snapshot& snapshot) {
    std::vector<PointerNews> all;
    for (const window::Event& event : parts_.view.poll_events())
        pointer_.handle(event, now_s_, all);
    pointer_.pass_time(now_s_, all);
    for (const PointerNews& news : all)
        take_news(news, snapshot);
    for (const std::string& line : parts_.devices.news())
        say(line);
    const bool has_device = parts_.devices.has_hand();
    if (has_device != had_device_) tell({has_device ? Event::Kind::kDeviceBack : Event::Kind::kDeviceLost});
    had_device_ = has_device;
    if (parts_.devices.somebody_moved()) tell({Event::Kind::kInput});
    take_gamepads(snapshot);
}

void KioskVisit::take_gamepads(const haptic::Snapshot& snapshot) {
    std::vector<window::Gamepad> pads = parts_.view.gamepads();
    std::erase_if(pads,
                  [&](const auto& pad) { return parts_.devices.drives(pad.vendor_id, pad.product_id); });
    const GamepadWish wish = gamepads_.wish(pads, kFrameS);
    if (!wish.is_used) return;
    tell({Event::Kind::kInput});
    if (state_.screen != Screen::kThrow || state_.panel != Panel::kNone) return;
    tell({Event::Kind::kClayTouched});
    hand_.nudge(wish.step_mm, *snapshot.shape);
    if (wish.radius_steps > 0.5) tell(Event::pressed(Button::kToolMore));
    if (wish.radius_steps < -0.5) tell(Event::pressed(Button::kToolLess));
    if (wish.fresh_lump) tell(Event::pressed(Button::kNewClay));
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
    if (touches && (hand_.works() || !parts_.devices.holder().empty())) tell({Event::Kind::kClayTouched});
    tell({Event::Kind::kProgress, Button::kNone, lesson_.steps_done(*snapshot.shape)});
    const kiosk::Warning warning = warning_of(snapshot.load, state_.throwing.warning);
    tell({Event::Kind::kWarned, Button::kNone, static_cast<int>(warning)});
    // Clay that gives way a little is no failure yet: the pot has to have sunk, or a piece come off.
    const clay::studio::Failure& failure = snapshot.load.failure;
    const double height_mm = snapshot.shape->height_mm;
    if (failure.cause == clay::studio::Cause::kNone) standing_mm_ = height_mm;
    const bool gave_way = failure.cause != clay::studio::Cause::kNone &&
                          (failure.torn || height_mm < kSunkShare * standing_mm_);
    if (gave_way && collapse_tick_ == 0) {
        collapse_tick_ = std::max<std::uint64_t>(1, snapshot.tick);
        hand_.release();
        tell({Event::Kind::kCollapsed, Button::kNone, static_cast<int>(warning_for(failure.cause))});
    }
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
    if (advice.take_back) static_cast<void>(parts_.job.send(haptic::Command::kRearmForce));
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
                    fired_pot(*answer->clay, parts_.settings.targets, parts_.settings.exhibit_places));
                break;
            case KeeperAnswer::Kind::kSaved:
                if (pot_) day_.insert(day_.begin(), {pot_->shape, state_.glaze});
                if (day_.size() > kMostOnShelf) day_.pop_back();
                kept_ = true;
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
            case KeeperAnswer::Kind::kRemark:
                break;
        }
    }
}

void KioskVisit::move_hand(const haptic::Snapshot& snapshot, double dt_s) {
    // Under the staff's panel nothing moves by itself, so that a hand can be tested.
    if (state_.panel == Panel::kPin || state_.panel == Panel::kStaff) {
        parts_.hand.set_target({.position_mm = kRestingMm});
        return;
    }
    if (demo_runs_ && parts_.demonstration) {
        const haptics::Gesture& gesture = *parts_.demonstration;
        const double at_s = now_s_ - demo_since_s_;
        constexpr double kRestS = 3.0;
        if (at_s > gesture.duration_s() + kRestS) {
            demo_since_s_ = now_s_;
            fresh_clay();
        }
        parts_.hand.set_target(gesture.at(std::min(at_s, gesture.duration_s())));
        return;
    }
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
    const haptic::Snapshot& snapshot = parts_.job.newest_snapshot();
    desk_.see_frame(now_s, since_last_ms, snapshot);
    tell({Event::Kind::kTick});
    take_input(snapshot);
    take_clay(snapshot);
    take_fault(snapshot);
    take_answers();
    move_hand(snapshot, dt_s);
    aim_camera(snapshot);
    compose(snapshot);
    stage_.take(composer_.latest(), now_s_);
    composer_.hold(pointer_.rests_on_scene());
    stage_.turn(composer_.turned());

    forces_.look(snapshot, now_s_);
    const std::optional<screens::Band> band = warning_band(snapshot);
    wheel::PotView pot = pot_view(snapshot);
    const std::optional<screens::ForceFrame> forces = force_frame(snapshot, pot);
    const screens::StageFrame stage_frame{.now_s = now_s_,
                                          .hint = kiosk::shows_hint(state_, now_s_, parts_.settings.rules),
                                          .pressed = pointer_.pressed(),
                                          .band = band ? &*band : nullptr,
                                          .forces = forces ? &*forces : nullptr};
    const ui::DrawList& list = stage_.draw(stage_frame);
    const render::Overlay overlay{.list = &list,
                                  .uploads = stage_.uploads(),
                                  .atlas_side_px = stage_.atlas_side_px(),
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
        name_window(shown->view->state);
        const auto& languages = *shown->view->languages;
        const auto language = static_cast<std::size_t>(shown->view->state.comfort.language);
        pointer_.look_at(&shown->composition, screen_key(shown->view->state),
                         languages[language].right_to_left());
    }
    return {};
}

// Nobody sees the title of a full screen; scripts that play a visitor read it.
void KioskVisit::name_window(const kiosk::State& shown) {
    std::string title = "Onggi - " + std::string(kiosk::name_of(shown.screen));
    if (shown.panel != Panel::kNone) title += " - " + std::string(kiosk::name_of(shown.panel));
    if (pointer_.focus() >= 0) title += " [" + std::to_string(pointer_.focus()) + "]";
    if (title == title_) return;
    title_ = title;
    parts_.view.set_title(title);
}

}  // namespace onggi::app
