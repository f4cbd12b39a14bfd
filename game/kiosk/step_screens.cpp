#include "game/kiosk/step_screens.h"

#include <algorithm>

namespace onggi::kiosk {
namespace {

void finish_throwing(Turn& turn) {
    turn.state.throwing.held = Held::kHand;
    turn.state.throwing.tray = false;
    // A bowl that is cut off before the bowls are joined is an ordinary pot.
    if (turn.state.throwing.jar.step != JarStep::kSeam) turn.state.throwing.jar = {};
    turn.add(effect::CutOff{});
    turn.state.firing = FiringStage::kCut;
    turn.state.trimming = {};
    turn.state.throwing.warning = Warning::kNone;
    turn.show(Screen::kFiring);
}

void show_glazes(Turn& turn) {
    turn.state.glaze = std::clamp(turn.state.glaze, 0, turn.rules.glaze_count - 1);
    turn.show(Screen::kGlaze);
}

bool is_pot(const Turn& turn, int place) {
    return place >= 0 && place < turn.rules.target_count;
}

bool is_jar(const Turn& turn, int place) {
    const std::vector<int>& jars = turn.rules.jars;
    return std::find(jars.begin(), jars.end(), place) != jars.end();
}

void press_choose(Turn& turn, const event::Pressed& event) {
    const bool is_target = event.button == Button::kTarget && is_pot(turn, event.value);
    if (event.button == Button::kShelfBefore || event.button == Button::kShelfNext) {
        turn.state.shelf_first = std::clamp(event.value, 0, turn.rules.target_count);
    } else if (event.button == Button::kCard && is_pot(turn, event.value)) {
        turn.state.card = event.value;
        turn.lay_over(Panel::kCard);
    } else if (event.button == Button::kBack) {
        turn.end_visit();
    } else if (is_target && is_jar(turn, event.value)) {
        begin_jar(turn, event.value);
    } else if (event.button == Button::kFree || is_target) {
        turn.show(Screen::kThrow);
        turn.put_on_clay(is_target ? std::optional<int>(event.value) : std::nullopt);
    }
}

void press_throw(Turn& turn, const event::Pressed& event) {
    Throwing& throwing = turn.state.throwing;
    const bool was_shown = throwing.shown.has_value();
    if (event.button != Button::kLookIn) end_show(turn);  // any other button ends the demonstration
    if (press_jar(turn, event)) return;
    switch (event.button) {
        case Button::kShowMe:
            if (!was_shown) begin_show(turn);
            break;
        case Button::kBack:
            turn.show(Screen::kChoose);
            break;
        case Button::kNewClay:
            put_on_new_clay(turn);
            break;
        case Button::kUndo:
            turn.add(effect::Undo{});
            break;
        case Button::kTools:
            throwing.tray = !throwing.tray;
            break;
        case Button::kTakeTool:
            if (event.value < 0 || event.value >= kHeldCount) break;
            throwing.held = static_cast<Held>(event.value);
            throwing.tray = false;
            break;
        case Button::kCut:
            if (throwing.held != Held::kWire) break;
            throwing.held = Held::kHand;  // the wire is laid back after one cut
            turn.add(effect::CutRim{});
            break;
        case Button::kToolLess:
        case Button::kToolMore:
            change(throwing.tool, event.button == Button::kToolMore ? 1 : -1, kMostTool);
            break;
        case Button::kWaterLess:
        case Button::kWaterMore:
            change(throwing.water, event.button == Button::kWaterMore ? 1 : -1, kMostWater);
            break;
        case Button::kSpeedLess:
        case Button::kSpeedMore:
            change(throwing.speed, event.button == Button::kSpeedMore ? 1 : -1, kMostSpeed);
            break;
        case Button::kLookIn:
            throwing.looks_in = !throwing.looks_in;
            break;
        case Button::kDone:
            finish_throwing(turn);
            break;
        default:
            if (moves_hand(event.button)) turn.add(effect::MoveHand{event.button});
            break;
    }
}

void press_failure(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kBeforeCollapse) {
        Throwing& throwing = turn.state.throwing;
        throwing.warning = Warning::kNone;
        turn.state.pace.progress_s = turn.now_s;
        // At the same speed the clay would fly apart again before the visitor could slow the wheel.
        if (throwing.collapse == Warning::kFast)
            throwing.speed = std::max(1, std::min(throwing.speed - 1, Throwing().speed));
        turn.add(effect::BeforeCollapse{});
        turn.show(Screen::kThrow);
    } else if (event.button == Button::kNewClay) {
        turn.show(Screen::kThrow);
        put_on_new_clay(turn);
    } else if (event.button == Button::kKeepSlump) {
        finish_throwing(turn);
    }
}

void press_glaze(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kGlaze && event.value >= 0 && event.value < turn.rules.glaze_count) {
        turn.state.glaze = event.value;
    } else if (event.button == Button::kTakeGlaze) {
        turn.show(Screen::kYourPot);
    } else if (event.button == Button::kDecorateAgain) {
        begin_decorating(turn);
    }
}

void press_your_pot(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kOtherGlaze) {
        show_glazes(turn);
    } else if (event.button == Button::kCard) {
        turn.state.card = kRelativesCard;
        turn.lay_over(Panel::kCard);
    } else if (event.button == Button::kKeep) {
        turn.state.keeping = {};
        turn.add(effect::Save{});
        turn.show(Screen::kKeep);
    }
}

void press_resume(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kResumeGo) {
        turn.state.interrupted_session = false;
        turn.state.throwing = {};
        turn.state.pace = {.progress_s = turn.now_s};
        turn.add(effect::Resume{});
        turn.show(Screen::kThrow);
        resume_jar(turn);
    } else if (event.button == Button::kResumeFresh) {
        turn.state.interrupted_session = false;
        turn.add(effect::DropInterrupted{});
        turn.show(Screen::kThrow);
        turn.put_on_clay(std::nullopt);
    }
}

}  // namespace

void Turn::change_volume(int by) {
    const int changed = std::clamp(state.comfort.volume + by, 0, kMostVolume);
    if (changed == state.comfort.volume) return;
    state.comfort.volume = changed;
    add(effect::SetVolume{changed});
}

void pass_firing(Turn& turn) {
    const double passed_s = turn.now_s - turn.state.screen_s;
    const Rules& rules = turn.rules;
    if (turn.state.firing == FiringStage::kFire) {
        if (passed_s >= rules.fire_s) show_glazes(turn);
    } else if (passed_s >= rules.cut_s + rules.dry_s) {
        end_drying(turn);
    } else if (passed_s >= rules.cut_s) {
        turn.state.firing = FiringStage::kDry;
    }
}

void press_screen(Turn& turn, const event::Pressed& event) {
    switch (turn.state.screen) {
        case Screen::kAttract:
            turn.begin_visit(turn.state.interrupted_session ? Screen::kResume : Screen::kChoose);
            break;
        case Screen::kChoose:
            press_choose(turn, event);
            break;
        case Screen::kJarStart:
            press_jar_start(turn, event);
            break;
        case Screen::kThrow:
            press_throw(turn, event);
            break;
        case Screen::kJoin:
            press_join(turn, event);
            break;
        case Screen::kFailure:
            press_failure(turn, event);
            break;
        case Screen::kFiring:
            if (event.button != Button::kSkip) break;
            if (turn.state.firing == FiringStage::kFire) {
                show_glazes(turn);
            } else {
                end_drying(turn);
            }
            break;
        case Screen::kTrim:
            press_trim(turn, event);
            break;
        case Screen::kDecorate:
            press_decorate(turn, event);
            break;
        case Screen::kGlaze:
            press_glaze(turn, event);
            break;
        case Screen::kYourPot:
            press_your_pot(turn, event);
            break;
        case Screen::kKeep:
            press_keep(turn, event);
            break;
        case Screen::kResume:
            press_resume(turn, event);
            break;
        case Screen::kFault:
            break;
    }
}

void press_card(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kCardClose) {
        turn.lay_over(Panel::kNone);
    } else if (event.button == Button::kCardThrow && turn.state.card != kRelativesCard) {
        const int place = turn.state.card;
        turn.lay_over(Panel::kNone);
        press_choose(turn, event::Pressed{Button::kTarget, place});
    }
}

void press_idle(Turn& turn, const event::Pressed& event) {
    turn.lay_over(Panel::kNone);
    if (event.button != Button::kFresh) return;
    if (turn.state.screen == Screen::kResume) return press_resume(turn, event::Pressed{Button::kResumeFresh});
    turn.show(Screen::kThrow);
    turn.put_on_clay(std::nullopt);
}

void press_language(Turn& turn, const event::Pressed& event) {
    Comfort& comfort = turn.state.comfort;
    switch (event.button) {
        case Button::kLanguage:
            if (event.value >= 0 && event.value < turn.rules.language_count) comfort.language = event.value;
            break;
        case Button::kTextLess:
        case Button::kTextMore:
            change(comfort.text_size, event.button == Button::kTextMore ? 1 : -1, kMostTextSize);
            break;
        case Button::kSoundLess:
        case Button::kSoundMore:
            turn.change_volume(event.button == Button::kSoundMore ? 1 : -1);
            break;
        case Button::kReach:
            comfort.reach = !comfort.reach;
            break;
        case Button::kLeftHand:
            comfort.left_hand = !comfort.left_hand;
            break;
        case Button::kStill:
            comfort.still = !comfort.still;
            break;
        case Button::kComfortDone:
        case Button::kLanguages:
            turn.lay_over(Panel::kNone);
            // Choosing a language begins a visit.
            if (turn.state.screen == Screen::kAttract) {
                turn.begin_visit(turn.state.interrupted_session ? Screen::kResume : Screen::kChoose);
            }
            break;
        default:
            break;
    }
}

}  // namespace onggi::kiosk
