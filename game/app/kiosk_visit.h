// A kiosk at work: one visitor after another, until the staff or a free window's cross ends it. It carries
// the state machine's effects out and hands the screens what they show. Main thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/haptics/gesture.h"
#include "engine/haptics/simulated_device.h"
#include "game/app/gamepad_hand.h"
#include "game/app/hand_devices.h"
#include "game/app/kiosk_hand.h"
#include "game/app/kiosk_keeper.h"
#include "game/app/kiosk_pointer.h"
#include "game/app/kiosk_pot.h"
#include "game/app/kiosk_settings.h"
#include "game/haptic/job.h"
#include "game/screens/stage.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// What a visit needs; all of it outlives the visit.
struct VisitParts {
    wheel::LiveView& view;
    haptic::HapticJob& job;
    haptics::SimulatedDevice& hand;
    HandDevices& devices;
    KioskKeeper& keeper;
    const KioskSettings& settings;
    const std::optional<haptics::Gesture>& demonstration;
    double rate_hz;  // of the haptic job
};

class KioskVisit {
  public:
    explicit KioskVisit(const VisitParts& parts);
    ~KioskVisit();

    Result<void> start() { return composer_.start(); }
    // Draws one frame and does what is due. now_s: of the monotonic clock.
    Result<void> frame(double now_s);
    [[nodiscard]] bool quits() const { return quits_; }
    [[nodiscard]] const kiosk::State& state() const { return state_; }

  private:
    void take_input(const haptic::Snapshot& snapshot);
    void take_news(const PointerNews& news, const haptic::Snapshot& snapshot);
    void take_clay(const haptic::Snapshot& snapshot);
    void take_fault(const haptic::Snapshot& snapshot);
    void take_answers();
    void take_gamepads(const haptic::Snapshot& snapshot);
    void tell(const kiosk::Event& event);
    void carry_out(const kiosk::Effect& effect);
    void move_hand(const haptic::Snapshot& snapshot, double dt_s);
    void add_staff(screens::View& view, const haptic::Snapshot& snapshot);
    void compose(const haptic::Snapshot& snapshot);
    void add_scene(screens::View& view, const haptic::Snapshot& snapshot);
    [[nodiscard]] std::optional<screens::Band> warning_band(const haptic::Snapshot& snapshot) const;
    [[nodiscard]] std::optional<dvec3> place_at(vec2 px) const;
    void fresh_clay();
    void name_window(const kiosk::State& shown);

    VisitParts parts_;
    kiosk::State state_;
    screens::Composer composer_;
    screens::Stage stage_;
    KioskPointer pointer_;
    KioskHand hand_;
    GamepadHand gamepads_;
    Lesson lesson_;
    std::shared_ptr<const screens::FiredPot> pot_;
    std::vector<screens::ShelfPot> day_;  // the last few pots that were kept
    std::shared_ptr<const screens::View> asked_;
    double now_s_ = 0.0;
    double demo_since_s_ = 0.0;
    bool demo_runs_ = true;
    std::uint64_t collapse_tick_ = 0;
    double standing_mm_ = 0.0;  // the pot's height before it gave way
    std::string title_;
    double tried_s_ = 0.0;                          // when a fault was last looked after
    kiosk::Screen left_ = kiosk::Screen::kAttract;  // before the step that is carried out
    bool kept_ = false;                             // this visit has kept a pot
    std::vector<std::string> kept_pots_;            // as of the last survey, newest first
    double free_mb_ = 0.0;
    double surveyed_s_ = -1e9;
    double frame_ms_ = 0.0;  // between two frames, smoothed
    bool had_device_ = false;
    bool full_screen_ = false;
    bool quits_ = false;
};

}  // namespace onggi::app
