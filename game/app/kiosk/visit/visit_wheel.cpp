#include "game/app/kiosk/visit/visit_wheel.h"

#include <algorithm>
#include <string>

#include "game/tool/tool.h"
#include "game/visit/flow/step.h"

namespace onggi::app {

namespace event = kiosk::event;

namespace {

constexpr double kSunkFraction = 0.8;     // of the height before the failure
constexpr double kSpreadFraction = 1.12;  // of the width, because a bowl that spins apart hardly sinks
constexpr double kFirmly = 0.7;           // of the clay's strength: below it the clay stands again

double widest_mm(const pot::Pot& shape) {
    const auto& outer = shape.outer_mm;
    return outer.empty() ? 0.0 : 2.0 * double{*std::max_element(outer.begin(), outer.end())};
}

using kiosk::Panel;
using visit::Finger;
using visit::open_finger;
using visit::step_of;

}  // namespace

void KioskClay::expect_lump(std::uint64_t run) {
    *this = {};
    run_ = run;
}

void KioskClay::expect_state(const haptic::Snapshot& now) {
    expect_lump(run_);
    puts_before_ = now.states_put;
}

bool KioskClay::is_there(const haptic::Snapshot& snapshot) {
    // The rings and the numbers of a snapshot may belong to different ticks.
    if (snapshot.run != run_ || snapshot.pot_stamp.run != run_) return false;
    if (puts_before_ &&
        (snapshot.states_put == *puts_before_ || snapshot.pot_stamp.states_put == *puts_before_))
        return false;
    puts_before_.reset();
    return true;
}

std::optional<ClayNews> KioskClay::look(const haptic::Snapshot& snapshot, kiosk::Warning before) {
    if (!is_there(snapshot)) return std::nullopt;
    ClayNews news{.steps_done = lesson_.steps_done(*snapshot.pot),
                  .is_solid = is_solid(*snapshot.pot),
                  .thick_mm = thick_wall_mm(*snapshot.pot),
                  .warning = warning_of(snapshot.load, before)};
    const clay::studio::Failure& failure = snapshot.load.failure;
    const double height_mm = snapshot.pot->height_mm;
    const double width_mm = widest_mm(*snapshot.pot);
    const bool ever_failed = failure.cause != clay::studio::Cause::kNone;
    // If the clay gave way a little and recovered, it may be pressed and raised as usual. A restored earlier
    // state is judged by its own height.
    const bool is_new = standing_height_mm_ == 0.0;
    if (!ever_failed || is_new || (snapshot.load.index < kFirmly && !failure.torn)) {
        standing_height_mm_ = height_mm;
        standing_width_mm_ = width_mm;
        failing_tick_ = 0;
        if (!ever_failed) has_said_ = false;
        return news;
    }
    if (failing_tick_ == 0) failing_tick_ = std::max<std::uint64_t>(1, snapshot.tick);
    // Giving way a little is no failure yet: the pot must have sunk, spun apart or lost a piece.
    const bool is_sunk = height_mm < kSunkFraction * standing_height_mm_;
    const bool is_spread = snapshot.load.index >= 1.0 && width_mm > kSpreadFraction * standing_width_mm_;
    const bool gave_way = failure.torn || is_sunk || is_spread;
    if (gave_way && !has_said_) {
        has_said_ = true;
        news.gave_way = warning_for(failure.cause, failure.strength_kpa);
    }
    return news;
}

KioskFault::Advice KioskFault::look(haptics::Fault fault, double now_s) {
    using haptics::Fault;
    if (fault != last_) {
        last_ = fault;
        tried_s_ = now_s;
    }
    if (fault == Fault::kNone) return {};
    Advice advice;
    advice.wheel_rests = fault == Fault::kForceNotFinite;
    advice.force_rests = !advice.wheel_rests;
    if (fault == Fault::kStopped || now_s - tried_s_ < kRestS) return advice;
    tried_s_ = now_s;
    advice.take_back = true;
    return advice;
}

void VisitWheel::put_fresh_clay() {
    // If the ring is full, the haptic thread has stopped, and the window's picture stops too.
    if (parts_.job.send(haptic::Command::kFreshLump)) ++run_;
    clay_.expect_lump(run_);
    finger_.leave_clay();
    ++lumps_asked_;
    shown_.reset();
}

void VisitWheel::begin_show(double now_s) {
    demo_runs_ = true;
    put_fresh_clay();
    demo_since_s_ = now_s;
    const std::vector<Recording>& recordings = parts_.show.recordings;
    shown_ = recordings.empty() ? 0 : shows_begun_++ % recordings.size();
    // A full queue of states refuses it; it is tried again after this recording's duration.
    if (!recordings.empty())
        static_cast<void>(parts_.job.put(first_state_of(recordings[*shown_], *shown_), run_));
}

bool VisitWheel::play_show(const VisitMoment& moment) {
    constexpr double kRestS = 3.0;
    const Show& show = parts_.show;
    if (show.recordings.empty() && !show.gesture) return false;
    const double length_s =
        show.recordings.empty() ? show.gesture->duration_s() : show.recordings[shown_.value_or(0)].seconds();
    // A recording's time is counted in ticks of its clay, which may be late.
    const double since_s = moment.now_s - demo_since_s_;
    const auto played = moment.snapshot.run == run_
                            ? played_s(moment.snapshot.tick, shown_.value_or(0), parts_.rate_hz)
                            : std::nullopt;
    if (!shown_ || played.value_or(since_s) > length_s + kRestS) begin_show(moment.now_s);
    if (show.gesture)
        parts_.pointer.set_target(show.gesture->at(std::min(moment.now_s - demo_since_s_, length_s)));
    return true;
}

void VisitWheel::rearm_force() {
    static_cast<void>(parts_.job.send(haptic::Command::kRearmForce));
}

void VisitWheel::take_clay(const haptic::Snapshot& snapshot, bool holder_lives) {
    const bool touches = snapshot.result.forces.contacts > 0;
    // A visitor with a device chooses free throwing by touching the clay, without the screen.
    if (open_finger(flow_.state()) == Finger::kLooks && touches && holder_lives &&
        !parts_.devices.holder().empty()) {
        flow_.dispatch(event::ClayTouched{});
        return;
    }
    if (step_of(flow_.state().screen).finger != Finger::kClay) return;
    // Demonstrating hands are not the visitor's touch.
    const bool holds = parts_.devices.holder().empty() ? finger_.works() && !finger_.shows() : touches;
    const bool held = flow_.state().pace.held;
    if (touches && holds && holder_lives) flow_.dispatch(event::ClayTouched{.goes_on = held});
    if (holds != held) flow_.dispatch(event::Held{holds});
    if (flow_.state().throwing.shown && !finger_.shows()) flow_.dispatch(event::ShowOver{});
    const std::optional<ClayNews> news = clay_.look(snapshot, flow_.state().throwing.warning);
    clay_is_there_ = news.has_value();
    if (!news) return;
    flow_.dispatch(event::Progress{news->steps_done, news->is_solid, news->thick_mm});
    flow_.dispatch(event::Warned{news->warning});
    if (!news->gave_way) return;
    finger_.release();
    flow_.dispatch(event::Collapsed{*news->gave_way});
}

void VisitWheel::take_fault(const VisitMoment& moment) {
    const KioskFault::Advice advice = fault_.look(moment.snapshot.fault, moment.now_s);
    if (advice.force_rests != flow_.state().force_rests) {
        if (advice.force_rests) {
            flow_.warn("kiosk: no force for the hand (" +
                       std::string(haptics::words_for(moment.snapshot.fault)) + "); the clay goes on");
        } else {
            flow_.say("kiosk: the hand has its force again");
        }
        flow_.dispatch(event::Force{.rests = advice.force_rests});
    }
    const bool is_fault = step_of(flow_.state().screen).whose == visit::Whose::kStaff;
    if (advice.wheel_rests && !is_fault) {
        flow_.warn("kiosk: the clay's force is no number; the wheel rests");
        flow_.dispatch(event::Fault{});
    }
    if (advice.take_back && advice.wheel_rests) put_fresh_clay();
    if (advice.take_back) rearm_force();
    // Not while the staff uses the panel.
    if (!advice.wheel_rests && is_fault && flow_.state().panel == Panel::kNone)
        flow_.dispatch(event::FaultOver{});
}

void VisitWheel::move_hand(const VisitMoment& moment) {
    // Under the staff's panel nothing moves automatically, so that a device can be tested.
    if (visit::overlay_of(flow_.state().panel).is_staffs) {
        parts_.pointer.set_target(resting_finger());
        if (demo_runs_ && shown_) put_fresh_clay();
        return;
    }
    if (demo_runs_ && play_show(moment)) return;
    const kiosk::Throwing& throwing = flow_.state().throwing;
    const visit::Step& step = step_of(flow_.state().screen);
    const bool trims = step.finger == Finger::kFoot;
    tool::ToolState tool = finger_.request({.tool = trims ? tool::Tool::kTrimmer : throwing.held,
                                            .size = trims ? flow_.state().trimming.loop : throwing.tool,
                                            .water = throwing.water,
                                            .speed = throwing.speed},
                                           *moment.snapshot.pot, moment.clay_s);
    // A ball alone presses a wall in, but does not thin it. For a visitor by ear the other hand is opposite.
    constexpr double kAssistGapMm = 4.0;
    const bool by_ear = flow_.state().comfort.speech;
    if (by_ear && !parts_.devices.holder().empty() && !trims) tool.assist_gap_mm = kAssistGapMm;
    tool.wheel_button = step.turns_wheel && flow_.state().panel != Panel::kIdle;
    parts_.pointer.set_target(tool);
    soak(moment);
}

// Each turn of the wall under the sponge takes water from the hands.
void VisitWheel::soak(const VisitMoment& moment) {
    const haptic::Snapshot& snapshot = moment.snapshot;
    const bool soaks = snapshot.tool.tool == tool::Tool::kSponge && snapshot.tool.guided &&
                       snapshot.result.grip.grip != clay::studio::Grip::kNone && !finger_.shows();
    soaked_rad_ = soaks ? soaked_rad_ + snapshot.wheel_speed_rad_s * moment.clay_s : 0.0;
    if (soaked_rad_ < kTurn) return;
    soaked_rad_ = 0.0;
    flow_.dispatch(event::Soaked{});
}

}  // namespace onggi::app
