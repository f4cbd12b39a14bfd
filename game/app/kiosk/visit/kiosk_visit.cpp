#include "game/app/kiosk/visit/kiosk_visit.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "game/app/kiosk/visit/bench_tools.h"
#include "game/app/system/report.h"
#include "game/visit/finish/finish.h"
#include "game/visit/flow/flow.h"

namespace onggi::app {
namespace {

using kiosk::Panel;

int screen_key(const kiosk::ScreenState& state) {
    return static_cast<int>(state.screen) * kiosk::kPanelCount + static_cast<int>(state.panel);
}

}  // namespace

KioskVisit::KioskVisit(const VisitParts& parts)
    : parts_(parts),
      state_(visit::first_state(parts.settings.rules, 0.0)),
      desk_({.view = parts.view,
             .job = parts.job,
             .devices = parts.devices,
             .keeper = parts.keeper,
             .phone = parts.phone,
             .sound = parts.sound,
             .config = parts.settings.config,
             .start = parts.start,
             .rate_hz = parts.rate_hz}),
      wheel_(parts_, *this),
      drawing_(parts_.view, *this),
      jar_(parts_.settings.targets, parts_.settings.exhibit_places, *this),
      trim_(*this),
      input_(parts_, wheel_.finger(), drawing_, jar_, trim_, *this),
      effects_(parts_, wheel_, input_, drawing_, jar_, trim_, desk_, *this),
      scene_(parts_, wheel_, input_, drawing_, trim_),
      screens_(parts_, effects_, jar_, input_.pointer(), desk_) {}

KioskVisit::~KioskVisit() {
    screens_.stop();
}

void KioskVisit::say(const std::string& line) {
    if (const auto words = log_.say(line, now_s_)) remark(*words);
}

void KioskVisit::warn(const std::string& line) {
    if (const auto words = log_.say(line, now_s_)) app::warn(*words);
}

void KioskVisit::dispatch(const kiosk::Event& event) {
    assert(moment_ != nullptr);
    const bool was_idle = is_idle();
    for (const kiosk::Effect& effect : visit::advance(state_, event, now_s_, parts_.settings.rules))
        effects_.apply(effect, *moment_);
    if (is_idle() == was_idle) return;
    tell_whether_idle();
    if (is_idle()) input_.pointer().forget();
}

bool KioskVisit::is_idle() const {
    return visit::step_of(state_.screen).whose == visit::Whose::kNobody;
}

void KioskVisit::tell_whether_idle() {
    static_cast<void>(parts_.job.send(is_idle() ? haptic::Command::kLetGo : haptic::Command::kTakeHold));
}

Result<void> KioskVisit::frame(double now_s) {
    constexpr double kMsPerS = 1e3;
    constexpr double kLongestFrameS = 0.1;
    const double since_last_s = std::exchange(now_s_, now_s);
    const double frame_s = now_s - since_last_s;
    if (!std::exchange(has_begun_, true)) {
        state_ = visit::first_state(parts_.settings.rules, now_s);
        began_s_ = now_s;
        tell_whether_idle();
    }
    const haptic::Snapshot& snapshot = parts_.job.newest_snapshot();
    const auto periods = static_cast<double>(snapshot.periods - std::exchange(periods_, snapshot.periods));
    const VisitMoment moment{.now_s = now_s,
                             .dt_s = std::clamp(frame_s, 0.0, kLongestFrameS),
                             .clay_s = std::min(periods / parts_.rate_hz, kLongestFrameS),
                             .snapshot = snapshot};
    moment_ = &moment;
    desk_.see_frame(now_s, kMsPerS * frame_s, moment.snapshot);
    desk_.see_restless(input_.restless());
    dispatch(kiosk::event::Tick{});
    input_.take(moment);
    wheel_.take_clay(moment.snapshot, input_.holder_lives(now_s));
    trim_.look(moment.snapshot);
    if (wheel_.clay_is_there()) jar_.look(moment.snapshot);
    wheel_.take_fault(moment);
    effects_.take_answers();
    wheel_.move_hand(moment);
    drawing_.pass(moment.dt_s);
    parts_.sound.hear(moment.snapshot, is_closed(), visit::kiln_burns(state_));
    scene_.aim_camera(state_, jar_.height_mm(moment.snapshot), screens_.asked(), stage_.covers());
    screens_.update(state_, moment, scene_.edges(), wheel_.finger().wire_mm());
    const double last_drawn_s = drawn_s_;
    const Result<void> drawn =
        is_worth_drawing() ? draw(moment, std::min(now_s_ - last_drawn_s, kLongestFrameS)) : Result<void>{};
    speak(moment);
    moment_ = nullptr;
    return drawn;
}

// The room without words would tell nobody at the start that it can be touched.
bool KioskVisit::is_worth_drawing() {
    constexpr double kWordsWithinS = 5.0;
    if (stage_.shown() == nullptr && screens_.composer().latest() == nullptr &&
        now_s_ - began_s_ < kWordsWithinS)
        return false;
    const double every_s = picture_every_s();
    if (now_s_ - drawn_s_ >= every_s) drawn_s_ = now_s_;
    return drawn_s_ == now_s_;
}

// Nobody looks at the dim screen of a closed museum, so it shows ten pictures a second once it has faded.
// While nobody is there, every second picture of a display of 60 Hz shows the demonstration; the frames
// between take input.
double KioskVisit::picture_every_s() {
    constexpr double kFadedS = 5.0;
    constexpr double kDimS = 0.1;
    constexpr double kUnattendedS = 0.025;
    if (!is_closed()) open_until_s_ = now_s_;
    if (now_s_ - open_until_s_ >= kFadedS) return kDimS;
    const bool somebody = !is_idle() || state_.panel != kiosk::Panel::kNone || input_.hovers(now_s_) ||
                          input_.pointer().rests_on_scene() || input_.pointer().pressed() >= 0;
    return somebody ? 0.0 : kUnattendedS;
}

KioskPulse KioskVisit::pulse() const {
    KioskPulse pulse = desk_.pulse(parts_.job.newest_snapshot());
    pulse.screen = visit::step_of(state_.screen).name;
    pulse.is_closed = is_closed();
    pulse.frames_shown = frames_shown_;
    return pulse;
}

Result<void> KioskVisit::draw(const VisitMoment& moment, double since_drawn_s) {
    screens::Composer& composer = screens_.composer();
    stage_.take(composer.latest(), now_s_);
    composer.hold(input_.pointer().rests_on_scene());
    stage_.turn(composer.turned());
    wheel::WheelScene& wheel_scene = parts_.view.scene();
    wheel_scene.hold_wire(wheel_.finger().wire_mm());
    wheel_scene.lay_on_bench(tool::Tool::kRib, rib_lies_there(parts_, state_));
    wheel_scene.show_hands(wheel_.shows() || visit::finger_is_hand(state_));
    drawing_.show(wheel_scene);
    jar_.show(wheel_scene, moment.snapshot);
    trim_.show(wheel_scene, moment.snapshot);
    const SceneMarks marks = scene_.marks(state_, moment, stage_);
    guard_ = marks.cue ? marks.cue->guard : screens::CueGuard::kNone;
    const screens::StageFrame stage_frame{.now_s = now_s_,
                                          .pressed = input_.pointer().pressed(),
                                          .band = marks.band ? &*marks.band : nullptr,
                                          .cue = marks.cue ? &*marks.cue : nullptr,
                                          .forces = marks.forces ? &*marks.forces : nullptr};
    const ui::DrawList& list = stage_.draw(stage_frame);
    const render::Overlay overlay{.list = &list,
                                  .uploads = stage_.uploads(),
                                  .atlas_side_px = stage_.atlas_side_px(),
                                  .scene_rests = stage_.scene_rests(),
                                  .covers = stage_.covers()};
    auto drawn = parts_.view.draw(moment.snapshot, since_drawn_s, &overlay);
    if (!drawn) return drawn.error();
    if (*drawn) ++frames_shown_;
    for (const std::string& line : parts_.view.take_remarks())
        say(line);
    look_at_shown(moment.snapshot);
    return {};
}

// From here on, input is interpreted by the screen that is visible.
void KioskVisit::look_at_shown(const haptic::Snapshot& snapshot) {
    const screens::Composed* shown = stage_.shown();
    if (shown == nullptr) return;
    const kiosk::ScreenState& state = shown->view->state;
    name_window(state, snapshot.pot->height_mm);
    const auto language = static_cast<std::size_t>(state.comfort.language);
    const bool right_to_left = (*shown->view->languages)[language].right_to_left();
    input_.pointer().look_at(&shown->composition, screen_key(state), right_to_left,
                             visit::finger_is_hand(state_));
}

void KioskVisit::speak(const VisitMoment& moment) {
    if (parts_.voice == nullptr) return;
    KioskVoice& voice = *parts_.voice;
    const bool by_device = !parts_.devices.holder().empty();
    const bool asks_where = input_.take_question();
    if (voice.headphones_are_in() != state_.headphones)
        dispatch(kiosk::event::Headphones{!state_.headphones});
    const screens::Composed* shown = stage_.shown();
    const bool speaks = state_.comfort.speech && voice.can_synthesise();
    std::vector<SaidLine> lines;
    if (is_closed() || shown == nullptr || !(speaks || voice.has_recordings())) {
        narrator_.forget();
        voice.hush();
    } else if (speaks) {
        lines = narrator_.look(
            {.shown = *shown,
             .focus = input_.pointer().focus(),
             .marker = marker_place(wheel_.finger().marker_mm(), *moment.snapshot.pot),
             .device_is_at_buttons = by_device ? std::optional(input_.device_is_at_buttons()) : std::nullopt,
             .guard = guard_,
             .snapshot = moment.snapshot,
             .now_s = moment.now_s,
             .is_quiet = !voice.speaks(),
             .is_private = voice.headphones_are_in(),
             .has_device = parts_.devices.has_device(),
             .asks_where = asks_where});
    } else {
        lines = narrator_.look_for_recordings(*shown->view);
    }
    for (SaidLine& line : lines)
        voice.say(std::move(line));
    voice.pass_time(moment.now_s);
    parts_.sound.say(voice.line());
    input_.pointer().hold_scan(speaks && voice.speaks());
    if (voice.speaks() != state_.speaks) dispatch(kiosk::event::Spoken{voice.speaks()});
    if (const std::string line = voice.news(); !line.empty()) warn("voice: " + line);
}

// The window's title tells scripted visitors the state of the clay, which they cannot see. In full screen it
// is invisible.
void KioskVisit::name_window(const kiosk::ScreenState& shown, double clay_mm) {
    const visit::Step& step = visit::step_of(shown.screen);
    std::string title = "Onggi - " + std::string(step.name);
    if (shown.panel != Panel::kNone) title += " - " + std::string(visit::overlay_of(shown.panel).name);
    if (shown.panel == Panel::kLanguage) {
        title += " " + (*parts_.settings.languages)[static_cast<std::size_t>(shown.comfort.language)].code();
        if (shown.comfort.reach) title += " low";
    }
    if (shown.panel == Panel::kNone && step.title != nullptr)
        title += step.title({.shown = shown, .now = state_, .clay_mm = clay_mm});
    if (input_.pointer().focus() >= 0) title += " [" + std::to_string(input_.pointer().focus()) + "]";
    if (title == title_) return;
    title_ = title;
    parts_.view.set_title(title);
}

}  // namespace onggi::app
