#include "game/app/kiosk_visit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
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

KioskVisit::KioskVisit(const VisitParts& parts) : parts_(parts) {
    state_ = kiosk::first_state(parts.settings.rules, 0.0);
}

KioskVisit::~KioskVisit() {
    composer_.stop();
}

void KioskVisit::fresh_clay() {
    // A full ring means that the haptic thread stands still; then the window says nothing new either.
    static_cast<void>(parts_.job.send(haptic::Command::kFreshLump));
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
            fresh_clay();
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
            break;
        case Effect::Kind::kSetTool:
        case Effect::Kind::kSetWater:
        case Effect::Kind::kSetSpeed:
        case Effect::Kind::kSetGlaze:
            break;  // the state has them
        case Effect::Kind::kResume:
        case Effect::Kind::kDropLeftOver:
        case Effect::Kind::kSetVolume:
        case Effect::Kind::kVisitBegan:
            kept_ = false;
            break;
        case Effect::Kind::kVisitEnded:
            parts_.keeper.note({.dwell_s = effect.value, .last = left_, .kept = kept_});
            kept_ = false;
            break;
        case Effect::Kind::kDeletePot:
            if (effect.value >= 0 && static_cast<std::size_t>(effect.value) < kept_pots_.size())
                parts_.keeper.remove(kept_pots_[static_cast<std::size_t>(effect.value)]);
            break;
        case Effect::Kind::kTestForce:
        case Effect::Kind::kTestSound:
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
        remark(line);
    const bool has_device = parts_.devices.has_hand();
    if (has_device != had_device_) tell({has_device ? Event::Kind::kDeviceBack : Event::Kind::kDeviceLost});
    had_device_ = has_device;
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
    if (state_.screen != Screen::kThrow) return;
    if (snapshot.result.forces.contacts > 0 && hand_.works()) tell({Event::Kind::kClayTouched});
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

// A latched fault leaves the hand without force: nobody is asked to throw until it has been taken back. The
// wheel tries again after each rest, so that what passed by needs no staff.
void KioskVisit::take_fault(const haptic::Snapshot& snapshot) {
    constexpr double kRestS = 5.0;
    const bool is_faulty = snapshot.fault != haptics::Fault::kNone;
    if (state_.screen != Screen::kFault) {
        if (is_faulty) {
            remark("kiosk: the hand's safety chain has a fault latched; the wheel rests");
            tell({Event::Kind::kFault});
            tried_s_ = now_s_;
        }
        return;
    }
    if (now_s_ - tried_s_ < kRestS) return;
    tried_s_ = now_s_;
    if (is_faulty) {
        static_cast<void>(parts_.job.send(haptic::Command::kRearmForce));
    } else if (state_.panel == Panel::kNone) {
        tell({Event::Kind::kFaultOver});  // not under the staff's eyes
    }
}

void KioskVisit::take_answers() {
    while (const auto answer = parts_.keeper.next_answer()) {
        if (!answer->words.empty()) remark(answer->words);
        switch (answer->kind) {
            case KeeperAnswer::Kind::kCutOff:
                pot_ = std::make_shared<const screens::FiredPot>(
                    fired_pot(*answer->clay, parts_.settings.targets, parts_.settings.exhibit_places));
                break;
            case KeeperAnswer::Kind::kSaved:
                if (pot_) day_.insert(day_.begin(), {pot_->shape, state_.glaze});
                if (day_.size() > kMostOnShelf) day_.pop_back();
                kept_ = true;
                tell({Event::Kind::kSaved, Button::kNone, answer->number});
                break;
            case KeeperAnswer::Kind::kSaveFailed:
                tell({Event::Kind::kSaveFailed});
                break;
            case KeeperAnswer::Kind::kSurvey:
                kept_pots_ = answer->pots;
                free_mb_ = answer->free_mb;
                break;
            case KeeperAnswer::Kind::kRemark:
                break;
        }
    }
}

void KioskVisit::move_hand(const haptic::Snapshot& snapshot, double dt_s) {
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
    const double dt_s = std::clamp(now_s - now_s_, 0.0, 0.1);
    now_s_ = now_s;
    frame_ms_ += 0.05 * (1000.0 * dt_s - frame_ms_);
    const haptic::Snapshot& snapshot = parts_.job.newest_snapshot();
    tell({Event::Kind::kTick});
    take_input(snapshot);
    take_clay(snapshot);
    take_fault(snapshot);
    take_answers();
    move_hand(snapshot, dt_s);
    compose(snapshot);
    stage_.take(composer_.latest(), now_s_);

    const std::optional<screens::Band> band = warning_band(snapshot);
    const screens::StageFrame stage_frame{.now_s = now_s_,
                                          .hint = kiosk::shows_hint(state_, now_s_, parts_.settings.rules),
                                          .pressed = pointer_.pressed(),
                                          .band = band ? &*band : nullptr};
    const ui::DrawList& list = stage_.draw(stage_frame);
    const render::Overlay overlay{.list = &list,
                                  .uploads = stage_.uploads(),
                                  .atlas_side_px = stage_.atlas_side_px(),
                                  .covers = stage_.covers()};
    wheel::PotView pot = pot_view(snapshot);
    if (!demo_runs_ && (state_.panel != Panel::kNone || state_.screen != Screen::kThrow))
        pot.hand.shown = pot.second_hand.shown = false;
    auto drawn = parts_.view.draw(pot, dt_s, &overlay);
    if (!drawn) return drawn.error();
    for (const std::string& line : parts_.view.take_remarks())
        remark(line);
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

// The clay where it carries most, from its left edge to its right as the camera sees it.
std::optional<screens::Band> KioskVisit::warning_band(const haptic::Snapshot& snapshot) const {
    if (state_.screen != Screen::kThrow || state_.throwing.warning == kiosk::Warning::kNone)
        return std::nullopt;
    constexpr double kHalfHeightMm = 11.0;
    constexpr int kPoints = 24;
    const double middle_mm = std::clamp(snapshot.load.height_mm, kHalfHeightMm,
                                        std::max(kHalfHeightMm, snapshot.shape->height_mm - kHalfHeightMm));
    screens::Band band;
    for (const auto& [edge, y_mm] : {std::pair(&band.upper, middle_mm + kHalfHeightMm),
                                     std::pair(&band.lower, middle_mm - kHalfHeightMm)}) {
        const double radius_mm =
            wall_at(*snapshot.shape, std::min(y_mm, snapshot.shape->height_mm - 0.5)).outer_mm;
        if (radius_mm <= 0.0) return std::nullopt;
        for (int i = 0; i <= kPoints; ++i) {
            const double angle = std::numbers::pi * (1.0 - static_cast<double>(i) / kPoints);
            const dvec3 place(radius_mm * std::cos(angle), y_mm, radius_mm * std::sin(angle));
            const auto px = parts_.view.project(place);
            if (!px) return std::nullopt;
            edge->push_back(vec2(*px));
        }
    }
    return band;
}

}  // namespace onggi::app
