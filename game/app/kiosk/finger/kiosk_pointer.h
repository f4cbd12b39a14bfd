// Maps pointer and keys to the targets of a screen: the pressed target, the focus ring, and the repeats of a
// held token. Pure state; tests play the visitor on a virtual clock. Main thread. Pixels, s.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/haptics/control_sense.h"
#include "engine/window/events.h"
#include "game/kiosk/screen.h"
#include "game/screens/page/composition.h"

namespace onggi::app {

// The outcome of an event.
struct PointerNews {
    enum class Kind {
        kNone,
        kLife,         // any input; value 1: a key
        kPressed,      // a target, on release or by a repeat; `button` and `value`
        kFingerDown,   // on the scene, not on a target
        kFingerMoved,  // while the finger is down
        kFingerUp,     // lifted, or ended because it cannot be a finger
        kSecondDown,   // a second finger, on the scene: the same three, whether or not the first is down
        kSecondMoved,
        kSecondUp,
        kHovered,     // the mouse moved with no button held
        kNudged,      // an arrow key; `button` is one of the pad's
        kPutDown,     // Enter without a focus ring
        kCornerHeld,  // the staff's corner was held long enough
        kCloseAsked,
        kFullScreen,
        kStopForce,
        kWhere,  // what the visitor by ear is at, and the state of the clay
    };
    Kind kind = Kind::kNone;
    kiosk::Button button = kiosk::Button::kNone;
    int value = 0;
    vec2 at_px{0.0F};
    bool lives = true;  // false: a held key repeats, or a finger trembles; nobody need be there for that
};

class KioskPointer {
  public:
    KioskPointer();

    // Sets the shown composition and the key of its screen. A press counts only if it ends on the screen on
    // which it began. at_clay: the arrow keys are a hand there.
    void look_at(const screens::Composition* composition, int screen_key, bool right_to_left,
                 bool at_clay = false);
    void handle(const window::Event& event, double now_s, std::vector<PointerNews>& news);
    // Once a frame: repeats, the corner, the scan.
    void pass_time(double now_s, std::vector<PointerNews>& news);

    [[nodiscard]] int pressed() const { return pressed_over_ ? pressed_ : -1; }
    // Index of the target with the focus ring, or -1.
    [[nodiscard]] int focus() const { return focus_; }
    // Arrow keys that move the drawing dot drop the focus ring, unless it scans by itself.
    void leave_ring() {
        if (!scans_) focus_ = -1;
    }
    // The arrow keys move the ring, from their first move of it or from Enter at the clay, until another key
    // or a press moves it. At the clay it ends beyond the first and the last target.
    [[nodiscard]] bool arrows_walk() const { return arrows_walk_ && focus_ >= 0; }
    void walk(kiosk::Button arrow);
    // Shows the ring, for arrow keys.
    void begin_walk();
    [[nodiscard]] bool scans() const { return scans_; }
    // The scan waits while a voice speaks, and from its end on for as long as on any target.
    void hold_scan(bool waits) { scan_waits_ = waits; }
    [[nodiscard]] vec2 at_px() const { return at_px_; }
    // Whether a finger is on the scene, beside all targets. It ends if the finger leaves the window, does not
    // move for a minute, a second button is pressed, or the window loses focus.
    [[nodiscard]] bool rests_on_scene() const { return finger_down_; }
    // A new visit: drops ring and scan.
    void forget();
    // What does not come to rest (control_sense.h), in words.
    [[nodiscard]] std::vector<std::string> restless() const;

  private:
    [[nodiscard]] int target_at(vec2 px) const;
    [[nodiscard]] int target_count() const;
    // Identifies a target across compositions.
    struct Meaning {
        kiosk::Button button = kiosk::Button::kNone;
        int value = 0;

        friend bool operator==(const Meaning&, const Meaning&) = default;
    };
    [[nodiscard]] Meaning meaning_of(int target) const;
    // Returns the current index of the target that had index `was`, or -1 if it is gone.
    [[nodiscard]] int place_of(const Meaning& meaning, int was) const;
    [[nodiscard]] bool in_corner(vec2 px) const;
    [[nodiscard]] bool in_window(vec2 px) const;
    void handle_pointer(const window::PointerEvent& pointer, double now_s, std::vector<PointerNews>& news);
    void handle_button(const window::ButtonEvent& button, double now_s, std::vector<PointerNews>& news);
    void lift_finger(std::vector<PointerNews>& news);
    void handle_second(const window::SecondFingerEvent& finger, std::vector<PointerNews>& news);
    void lift_second(std::vector<PointerNews>& news);
    void handle_key(const window::KeyEvent& key, double now_s, std::vector<PointerNews>& news);
    // False: it is released, or has been down for so long that it lies under an object.
    [[nodiscard]] bool is_pressed(const window::KeyEvent& key, double now_s);
    void press_focus(std::vector<PointerNews>& news) const;
    void advance(double now_s);
    void move_focus(int by);

    const screens::Composition* composition_ = nullptr;
    int screen_key_ = -1;
    bool right_to_left_ = false;
    bool at_clay_ = false;
    vec2 at_px_{0.0F};
    haptics::ControlSense mouse_;
    double leapt_s_ = -1e9;         // when the mouse last moved beyond its jitter
    std::optional<double> life_s_;  // when to report the motion as a sign of life
    unsigned buttons_down_ = 0;     // one bit per button
    bool finger_down_ = false;
    haptics::ControlSense finger_;  // that finger
    bool second_down_ = false;
    haptics::ControlSense second_;
    vec2 second_px_{0.0F};
    haptics::ControlSense presses_;  // where the screen is pressed
    haptics::ControlSense wheel_;
    std::optional<double> key_down_s_;  // since when a key is held
    std::optional<double> advanced_s_;
    int pressed_ = -1;
    Meaning pressed_meaning_{};
    bool pressed_over_ = false;  // the pointer is still on the pressed target
    int pressed_key_ = -1;       // the screen on which it was pressed
    double pressed_s_ = 0.0;
    double repeat_s_ = 0.0;      // when a held token repeats next
    bool has_repeated_ = false;  // since the press
    std::optional<double> corner_s_;
    int focus_ = -1;
    Meaning focus_meaning_{};
    bool arrows_walk_ = false;
    bool scans_ = false;
    double scan_s_ = 0.0;
    bool scan_waits_ = false;
    bool scan_is_new_ = false;  // another screen: the scan restarts
};

}  // namespace onggi::app
