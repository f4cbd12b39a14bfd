// Runs the kiosk: one visitor after another, until the staff ends it or a window is closed. Steps the state
// machine and runs its parts once a frame: input, wheel, effects, screens. Main thread.
#pragma once

#include <cstdint>
#include <string>

#include "game/app/kiosk/staff/staff_desk.h"
#include "game/app/kiosk/visit/narrator.h"
#include "game/app/kiosk/visit/visit_effects.h"
#include "game/app/kiosk/visit/visit_input.h"
#include "game/app/kiosk/visit/visit_parts.h"
#include "game/app/kiosk/visit/visit_scene.h"
#include "game/app/kiosk/visit/visit_screens.h"
#include "game/app/kiosk/visit/visit_wheel.h"
#include "game/app/system/report.h"
#include "game/screens/stage.h"
#include "game/visit/decorate/visit_drawing.h"
#include "game/visit/jar/visit_jar.h"
#include "game/visit/trim/visit_trim.h"

namespace onggi::app {

class KioskVisit final : private VisitFlow {
  public:
    explicit KioskVisit(const VisitParts& parts);
    ~KioskVisit();
    KioskVisit(const KioskVisit&) = delete;  // its parts point to it
    KioskVisit& operator=(const KioskVisit&) = delete;

    Result<void> start() { return screens_.start(); }
    // Runs and draws one frame. now_s is of the monotonic clock.
    Result<void> frame(double now_s);
    [[nodiscard]] bool quits() const { return effects_.quits(); }
    // Whether the program should then restart.
    [[nodiscard]] bool restarts() const { return effects_.restarts(); }
    [[nodiscard]] const kiosk::State& state() const override { return state_; }
    // Whether the museum is closed and there is no visitor: the screen is dim and the wheel silent.
    [[nodiscard]] bool is_closed() const { return screens_.is_closed(state_); }
    // The composition on the screen; null before the first. Scripted visitors search it for their buttons.
    [[nodiscard]] const screens::Composed* shown() const { return stage_.shown(); }
    [[nodiscard]] std::uint64_t frames_shown() const { return frames_shown_; }
    // For the museum's monitoring.
    [[nodiscard]] KioskPulse pulse() const;
    [[nodiscard]] std::uint64_t pots_kept() const { return effects_.pots_kept(); }  // since the start

  private:
    void dispatch(const kiosk::Event& event) override;
    [[nodiscard]] bool is_idle() const;
    // The loop gives no force while nobody is there, and may rest.
    void tell_whether_idle();
    void say(const std::string& line) override;
    void warn(const std::string& line) override;
    // since_drawn_s: since the last picture.
    Result<void> draw(const VisitMoment& moment, double since_drawn_s);
    [[nodiscard]] bool is_worth_drawing();
    [[nodiscard]] double picture_every_s();
    void look_at_shown(const haptic::Snapshot& snapshot);
    // What a visitor by ear is told of this frame.
    void speak(const VisitMoment& moment);
    void name_window(const kiosk::ScreenState& shown, double clay_mm);

    VisitParts parts_;
    kiosk::State state_;
    StaffDesk desk_;
    VisitWheel wheel_;
    visit::VisitDrawing drawing_;
    visit::VisitJar jar_;
    visit::VisitTrim trim_;
    VisitInput input_;
    VisitEffects effects_;
    VisitScene scene_;
    VisitScreens screens_;
    screens::Stage stage_;
    Narrator narrator_;
    screens::CueGuard guard_ = screens::CueGuard::kNone;  // whose words the picture shows
    LogLines log_;
    const VisitMoment* moment_ = nullptr;  // of the present frame; null outside frame()
    double now_s_ = 0.0;
    std::uint64_t periods_ = 0;  // of the haptic loop, up to the last frame
    double open_until_s_ = 0.0;  // the last moment at which the museum was open or somebody was there
    double drawn_s_ = 0.0;
    double began_s_ = 0.0;    // the first frame
    bool has_begun_ = false;  // set in the first frame, when the time is known
    std::string title_;
    std::uint64_t frames_shown_ = 0;
};

}  // namespace onggi::app
