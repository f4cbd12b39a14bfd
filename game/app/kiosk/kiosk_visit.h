// A kiosk at work: one visitor after another, until the staff or a free window's cross ends it. It carries
// the state machine's effects out and hands the screens what they show. Main thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/haptics/simulated_device.h"
#include "game/app/devices/gamepad_hand.h"
#include "game/app/devices/hand_devices.h"
#include "game/app/kiosk/demonstrations.h"
#include "game/app/kiosk/force_view.h"
#include "game/app/kiosk/kiosk_camera.h"
#include "game/app/kiosk/kiosk_clay.h"
#include "game/app/kiosk/kiosk_cue.h"
#include "game/app/kiosk/kiosk_fault.h"
#include "game/app/kiosk/kiosk_hand.h"
#include "game/app/kiosk/kiosk_keeper.h"
#include "game/app/kiosk/kiosk_pointer.h"
#include "game/app/kiosk/kiosk_pot.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/kiosk_sound.h"
#include "game/app/kiosk/kiosk_staff.h"
#include "game/app/kiosk/staff_desk.h"
#include "game/app/system/log_lines.h"
#include "game/app/system/start_log.h"
#include "game/haptic/job.h"
#include "game/screens/stage.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// Volume goes in steps.
constexpr double kLoudestStep = kiosk::kMostVolume;

// What a visit needs; all of it outlives the visit.
struct VisitParts {
    wheel::LiveView& view;
    haptic::HapticJob& job;
    haptics::SimulatedDevice& hand;
    HandDevices& devices;
    KioskKeeper& keeper;
    KioskSound& sound;
    const KioskSettings& settings;
    const Show& show;
    StartReport start{};                                      // what the staff is told of falls before
    double rate_hz;                                           // of the haptic job
    std::function<int()> minute_of_day = app::minute_of_day;  // local time, for the opening hours
};

class KioskVisit {
  public:
    explicit KioskVisit(const VisitParts& parts);
    ~KioskVisit();

    Result<void> start() { return composer_.start(); }
    // Draws one frame and does what is due. now_s: of the monotonic clock.
    Result<void> frame(double now_s);
    [[nodiscard]] bool quits() const { return quits_; }
    // And the program shall start anew.
    [[nodiscard]] bool restarts() const { return restarts_; }
    [[nodiscard]] const kiosk::State& state() const { return state_; }
    // Nobody is there and the museum is closed: the screen is dim and the wheel silent.
    [[nodiscard]] bool is_closed() const;
    // What the visitor sees; null before the first. For scripted visitors, who look for the button they want.
    [[nodiscard]] const screens::Composed* shown() const { return stage_.shown(); }
    [[nodiscard]] std::uint64_t frames_shown() const { return frames_shown_; }
    [[nodiscard]] std::uint64_t pots_kept() const { return pots_kept_; }  // since the start

  private:
    void take_input(const haptic::Snapshot& snapshot, double dt_s);
    void take_news(const PointerNews& news);
    void take_clay(const haptic::Snapshot& snapshot);
    void take_fault(const haptic::Snapshot& snapshot);
    void take_answers();
    void take_gamepads(const haptic::Snapshot& snapshot, double dt_s);
    [[nodiscard]] double side() const;      // on which the hand comes to the clay: +1 right, -1 left
    void nudge_hand(kiosk::Button button);  // one press of the pad's buttons
    void help_along();                      // draws a finger to the outline that is shown
    [[nodiscard]] bool clay_is_open() const;
    void tell(const kiosk::Event& event);
    void carry_out(const kiosk::Effect& effect);
    void set_volume(int volume) { parts_.sound.set_volume(volume / kLoudestStep); }
    void move_hand(const haptic::Snapshot& snapshot, double dt_s);
    void compose(const haptic::Snapshot& snapshot);
    const std::string& caption(const haptic::Snapshot& snapshot);  // key of what is heard
    void add_scene(screens::View& view, const haptic::Snapshot& snapshot);
    // What the visitor asked to see, or is being taught by; none: nothing.
    [[nodiscard]] std::optional<screens::ForceFrame> force_frame(const haptic::Snapshot& snapshot,
                                                                 const wheel::PotView& pot) const;
    [[nodiscard]] bool kiln_burns() const;
    void aim_camera(const haptic::Snapshot& snapshot);
    [[nodiscard]] std::optional<screens::Band> warning_band(const haptic::Snapshot& snapshot) const;
    // A stretch of the clay from its left edge to its right, as the camera sees it; none where it sees none.
    [[nodiscard]] std::optional<screens::Band> band_round(const haptic::PotShape& shape, double low_mm,
                                                          double high_mm) const;
    // What of the clay the hands hold, or a touch would; none where nobody throws.
    std::optional<screens::Cue> cue(const haptic::Snapshot& snapshot);
    void add_way(screens::Cue& cue, const haptic::PotShape& shape, int step) const;
    [[nodiscard]] std::optional<dvec2> place_at(vec2 px) const;
    void fresh_clay();
    void begin_show();
    // False: there is nothing to show.
    bool play_show(const haptic::Snapshot& snapshot);
    void rearm_force();
    void say(const std::string& line);
    void name_window(const kiosk::State& shown, double clay_mm);

    VisitParts parts_;
    kiosk::State state_;
    screens::Composer composer_;
    screens::Stage stage_;
    KioskPointer pointer_;
    KioskCamera camera_;
    CameraWish aimed_;  // as the view was last told
    KioskHand hand_;
    GamepadHand gamepads_;
    KioskClay clay_;
    KioskCue cue_;
    double hovered_s_ = -1e9;  // when a mouse last moved with no button held
    bool keys_lead_ = false;   // no pointer has been moved since
    ForceView forces_;
    std::shared_ptr<const screens::FiredPot> pot_;
    std::vector<screens::ShelfPot> day_;  // the last few pots that were kept
    std::shared_ptr<const screens::View> asked_;
    double now_s_ = 0.0;
    bool demo_runs_ = true;
    double demo_since_s_ = 0.0;
    std::optional<std::size_t> shown_;  // the recording, or 0 for the gesture, that is on the wheel
    std::size_t shows_begun_ = 0;
    std::uint64_t run_ = 0;  // of the lump that was asked for last, as Snapshot::run counts
    std::string title_;
    std::string caption_;
    double caption_s_ = 0.0;  // since when
    KioskFault fault_;
    LogLines log_;
    kiosk::Screen left_ = kiosk::Screen::kAttract;  // before the step that is carried out
    bool thrown_ = false;                           // clay was put on in this visit
    int kept_ = 0;                                  // pots of it
    StaffDesk desk_;
    std::uint64_t frames_shown_ = 0;
    std::uint64_t pots_kept_ = 0;
    bool has_begun_ = false;  // the clock is known from the first frame on
    bool had_device_ = false;
    std::optional<int> helped_;  // along the outline of which target, and how far the lesson had come
    int helped_steps_ = 0;
    std::string holder_;  // the device that has the tool
    bool full_screen_ = false;
    bool quits_ = false;
    bool restarts_ = false;
};

}  // namespace onggi::app
