// A kiosk at work: one visitor after another, until the staff or a free window's cross ends it. It steps the
// state machine and leads its parts through a frame: what visitors do, the wheel, the effects, the screens.
// Main thread.
#pragma once

#include <cstdint>
#include <string>

#include "game/app/kiosk/staff/staff_desk.h"
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
    KioskVisit(const KioskVisit&) = delete;  // its parts know where it is
    KioskVisit& operator=(const KioskVisit&) = delete;

    Result<void> start() { return screens_.start(); }
    // Draws one frame and does what is due. now_s: of the monotonic clock.
    Result<void> frame(double now_s);
    [[nodiscard]] bool quits() const { return effects_.quits(); }
    // And the program shall start anew.
    [[nodiscard]] bool restarts() const { return effects_.restarts(); }
    [[nodiscard]] const kiosk::State& state() const override { return state_; }
    // Nobody is there and the museum is closed: the screen is dim and the wheel silent.
    [[nodiscard]] bool is_closed() const { return screens_.is_closed(state_); }
    // What the visitor sees; null before the first. For scripted visitors, who look for the button they want.
    [[nodiscard]] const screens::Composed* shown() const { return stage_.shown(); }
    [[nodiscard]] std::uint64_t frames_shown() const { return frames_shown_; }
    // For the house's monitoring.
    [[nodiscard]] KioskPulse pulse() const;
    [[nodiscard]] std::uint64_t pots_kept() const { return effects_.pots_kept(); }  // since the start

  private:
    void dispatch(const kiosk::Event& event) override;
    void say(const std::string& line) override;
    void warn(const std::string& line) override;
    Result<void> draw(const VisitMoment& moment);
    void look_at_shown(const haptic::Snapshot& snapshot);
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
    LogLines log_;
    const VisitMoment* moment_ = nullptr;  // of the frame that is being made; null outside frame()
    double now_s_ = 0.0;
    bool has_begun_ = false;  // the clock is known from the first frame on
    std::string title_;
    std::uint64_t frames_shown_ = 0;
};

}  // namespace onggi::app
