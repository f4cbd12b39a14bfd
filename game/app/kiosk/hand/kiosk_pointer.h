// What pointer and keys mean on a screen: which target is held, which has the ring, and when a held token
// repeats. Pure state; tests play the visitor on a virtual clock. Main thread. Pixels, s.
#pragma once

#include <optional>
#include <vector>

#include "engine/window/events.h"
#include "game/kiosk/step.h"
#include "game/screens/page/composition.h"

namespace onggi::app {

// What came of an event.
struct PointerNews {
    enum class Kind {
        kNone,
        kLife,        // somebody is there; value 1: by a key
        kPressed,     // a target, on release or by repeating; `button` and `value`
        kHandDown,    // on the scene, not on a target
        kHandMoved,   // while it is down
        kHandUp,      // lifted, or taken for lifted: it cannot be a finger's any more
        kHovered,     // the mouse, with no button held
        kNudged,      // an arrow key where nothing has the ring; `button` is one of the pad's
        kPutDown,     // Enter, where nothing has the ring
        kCornerHeld,  // the staff's corner, long enough
        kCloseAsked,
        kFullScreen,
        kStopForce,
    };
    Kind kind = Kind::kNone;
    kiosk::Button button = kiosk::Button::kNone;
    int value = 0;
    vec2 at_px{0.0F};
};

class KioskPointer {
  public:
    // The composition that is shown and which screen it is of: a press counts only where it ends on the
    // screen on which it began.
    void look_at(const screens::Composition* composition, int screen_key, bool right_to_left);
    void handle(const window::Event& event, double now_s, std::vector<PointerNews>& news);
    // Once a frame: repeats, the corner, the scan.
    void pass_time(double now_s, std::vector<PointerNews>& news);

    [[nodiscard]] int pressed() const { return pressed_over_ ? pressed_ : -1; }
    // Target with the ring; -1: none.
    [[nodiscard]] int focus() const { return focus_; }
    // Who leads a dot with the arrow keys has left the ring; one that walks by itself stays.
    void leave_ring() {
        if (!scans_) focus_ = -1;
    }
    [[nodiscard]] bool scans() const { return scans_; }
    [[nodiscard]] vec2 at_px() const { return at_px_; }
    // A finger lies beside all targets. One that leaves the window, stays a minute where it is, comes with a
    // second button or loses the window's attention lies there no more.
    [[nodiscard]] bool rests_on_scene() const { return hand_down_; }
    // A new visit: no ring, no scan.
    void forget();

  private:
    [[nodiscard]] int target_at(vec2 px) const;
    [[nodiscard]] int target_count() const;
    // What a target is for, whatever else there is on the screen by then.
    struct Meaning {
        kiosk::Button button = kiosk::Button::kNone;
        int value = 0;

        friend bool operator==(const Meaning&, const Meaning&) = default;
    };
    [[nodiscard]] Meaning meaning_of(int target) const;
    // Where that is now, which was there; -1: it is gone.
    [[nodiscard]] int place_of(const Meaning& meaning, int was) const;
    [[nodiscard]] bool in_corner(vec2 px) const;
    [[nodiscard]] bool in_window(vec2 px) const;
    void handle_pointer(const window::PointerEvent& pointer, double now_s, std::vector<PointerNews>& news);
    void handle_button(const window::ButtonEvent& button, double now_s, std::vector<PointerNews>& news);
    void lift_hand(std::vector<PointerNews>& news);
    void handle_key(const window::KeyEvent& key, double now_s, std::vector<PointerNews>& news);
    void press_focus(std::vector<PointerNews>& news) const;
    void move_focus(int by);

    const screens::Composition* composition_ = nullptr;
    int screen_key_ = -1;
    bool right_to_left_ = false;
    vec2 at_px_{0.0F};
    vec2 still_px_{0.0F};           // where a mouse that only jitters counts as resting
    double leapt_s_ = -1e9;         // when it last left that place
    std::optional<double> life_s_;  // when it is told that it has moved
    bool pointer_came_ = false;
    unsigned buttons_down_ = 0;  // a bit each
    bool hand_down_ = false;
    vec2 hand_still_px_{0.0F};  // where the hand has rested on the scene, and since when
    double hand_still_s_ = 0.0;
    int pressed_ = -1;
    Meaning pressed_meaning_{};
    bool pressed_over_ = false;  // the pointer is still on it
    int pressed_key_ = -1;       // the screen on which it was pressed
    double repeat_s_ = 0.0;      // when a held token repeats next
    bool has_repeated_ = false;  // since it was pressed
    std::optional<double> corner_s_;
    int focus_ = -1;
    Meaning focus_meaning_{};
    bool scans_ = false;
    double scan_s_ = 0.0;
    bool scan_is_new_ = false;  // another screen: the ring begins anew
};

}  // namespace onggi::app
