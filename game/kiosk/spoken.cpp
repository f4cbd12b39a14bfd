#include "game/kiosk/spoken.h"

#include <array>

namespace onggi::kiosk {
namespace {

std::string_view warning_key(Warning warning) {
    switch (warning) {
        case Warning::kThin:
            return "warn.thin";
        case Warning::kWet:
            return "warn.wet";
        case Warning::kFast:
            return "warn.fast";
        case Warning::kNone:
            break;
    }
    return {};
}

std::string_view throwing_key(const State& state) {
    if (state.device_lost) return "dev.lost";
    if (state.throwing.warning != Warning::kNone) return warning_key(state.throwing.warning);
    if (state.throwing.shown) return "show.on";
    if (state.throwing.tray) return "tool.title";
    constexpr std::array<std::string_view, kTrayTools.size()> kHeld{"", "tool.rib.line", "tool.sponge.line",
                                                                    "wire.how"};
    if (state.throwing.jar.is_low) return "moon.low";
    if (state.throwing.jar.rims_apart) return "moon.more";
    if (state.throwing.jar.step == JarStep::kAside) return "moon.s2";
    if (state.throwing.jar.step == JarStep::kSeam) return "moon.s5";
    if (state.throwing.jar.step != JarStep::kNone && state.throwing.steps_done == 0)
        return state.throwing.jar.step == JarStep::kFirstBowl ? "moon.s1" : "moon.s3";
    if (state.throwing.held != tool::Tool::kHand) return kHeld[tray_place(state.throwing.held)];
    constexpr std::array<std::string_view, kTeachingSteps + 1> kSteps{"step.press", "step.open", "step.raise",
                                                                      "step.own"};
    return kSteps[static_cast<std::size_t>(state.throwing.steps_done)];
}

std::string_view phone_key(Phone phone) {
    switch (phone) {
        case Phone::kNone:
            break;
        case Phone::kPacking:
            return "home.making";
        case Phone::kWifi:
            return "home.w1";
        case Phone::kReady:
            return "home.title";
        case Phone::kResting:
            return "home.nonet";
        case Phone::kOver:
            return "home.expired";
    }
    return "keep.title";
}

std::string_view keeping_key(const Keeping& keeping) {
    switch (keeping.outcome) {
        case Keeping::Outcome::kKept:
            return phone_key(keeping.phone);
        case Keeping::Outcome::kFull:
            return "keep.fail";
        case Keeping::Outcome::kSaving:
            break;
    }
    return {};
}

std::string_view firing_key(FiringStage stage) {
    switch (stage) {
        case FiringStage::kCut:
            return "fin.cut";
        case FiringStage::kDry:
            return "fin.dry";
        case FiringStage::kFire:
            break;
    }
    return "fin.fire";
}

std::string_view decorating_key(const Decorating& decorating) {
    if (decorating.strokes == 0 && !decorating.touched && decorating.tool == 0) return "dec.title";
    constexpr std::array<std::string_view, kDrawingTools> kTools{
        "dec.finger.h", "dec.iron.h", "dec.cobalt.h", "dec.inlay.h", "dec.white.h", "dec.motif.how"};
    return kTools[static_cast<std::size_t>(decorating.tool)];
}

}  // namespace

std::string_view spoken_key(const State& state) {
    switch (state.panel) {
        case Panel::kIdle:
            return "idle.title";
        case Panel::kLanguage:
            return "lang.title";
        case Panel::kCard:
            return "card.about";
        case Panel::kPin:
        case Panel::kStaff:
            return {};
        case Panel::kNone:
            break;
    }
    switch (state.screen) {
        case Screen::kAttract:
            return "attract.touch";
        case Screen::kChoose:
            return "choose.title";
        case Screen::kJarStart:
            return "moon.title";
        case Screen::kThrow:
            return throwing_key(state);
        case Screen::kJoin:
            return "moon.s4";
        case Screen::kFailure:
            return "fail.title";
        case Screen::kFiring:
            return firing_key(state.firing);
        case Screen::kTrim:
            return "trim.title";
        case Screen::kDecorate:
            return decorating_key(state.decorating);
        case Screen::kGlaze:
            return "glz.title";
        case Screen::kYourPot:
            return "your.title";
        case Screen::kKeep:
            return keeping_key(state.keeping);
        case Screen::kResume:
            return "resume.title";
        case Screen::kFault:
            return "fault.title";
    }
    return {};
}

}  // namespace onggi::kiosk
