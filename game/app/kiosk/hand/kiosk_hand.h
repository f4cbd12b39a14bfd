// The visitor's hand as pointer, gamepad, keys and buttons make it: a finger on the upright plane through the
// axis, which skilled hands follow in the clay while it presses; and what the settings on the ledge make of
// it. Pure state, no window and no clock, so that tests play the visitor. Main thread. mm, s.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "engine/haptics/tool_state.h"
#include "engine/math/math.h"
#include "game/app/kiosk/hand/kiosk_marker.h"
#include "game/app/kiosk/hand/kiosk_touch.h"
#include "game/kiosk/state.h"
#include "game/pot/pot.h"

namespace onggi::app {

// Helps a finger along a drawn outline: near it the finger is drawn to it a little, so that a hand that
// trembles still throws the pot that it was shown. Pure state, main thread. mm, s.

// How much a visitor is helped who has done so many steps of the lesson: less, the more they can. 0 to 1.
[[nodiscard]] double outline_help_after(int steps_done);

class OutlineHelp {
  public:
    // Radius and height from below, as app::wet_outline(); empty: none. strength: 0 none to 1 all the help.
    void set(std::span<const vec2> radius_height, double strength);
    // So that help which comes or goes is not felt to.
    void pass_time(double dt_s);
    // Where the finger is taken to be. Never farther from the outline than it is, nor on its other side.
    [[nodiscard]] dvec2 drawn(const dvec2& finger_mm) const;

  private:
    std::vector<vec2> outline_mm_;
    double strength_ = 0.0;  // as wished
    double now_ = 0.0;
};

struct HandSettings {
    kiosk::Held held = kiosk::Held::kHand;
    int tool = 2;        // 1 to 3: how large
    int water = 3;       // 1 to 5
    int speed = 3;       // 1 to 5
    bool trims = false;  // with a trimmer, whose loop is `tool` large, instead of what is held
};

// A hand that does nothing, aside of any clay.
[[nodiscard]] haptics::ToolState resting_hand();

class KioskHand {
  public:
    // A finger or a pressed mouse at a place on that plane. It takes over from whatever pressed before. What
    // is no number, or leaps across the screen from one frame to the next, is no finger: it lets go.
    void press(const dvec2& place_mm);
    void drag(const dvec2& place_mm);
    // Nothing presses any more, whoever did.
    void release();
    // A mouse that only hovers.
    void hover(const dvec2& place_mm);
    // A gamepad, once a frame: the finger goes on by so much, and presses or not. The first step on new clay
    // brings it beside the clay, low on that side: +1 right, -1 left.
    void steer(const dvec2& step_mm, bool presses, const pot::Pot& shape, double side);
    // An arrow key, and a button of the pad on the screen.
    void key(HandKey key, double side) { ask_for({key, false, side}); }
    void button(HandKey key, double side) { ask_for({key, true, side}); }

    // Plays a step of the lesson on the clay that is there. Any finger, key, button or gamepad takes over.
    void show(ShownStep step, const pot::Pot& shape, double side);
    void stop_showing();
    [[nodiscard]] bool shows() const { return shows_ && touch_.runs(); }

    // The wire that is held, as high as the line round the wall; none: another thing is held.
    [[nodiscard]] std::optional<double> wire_mm() const { return wire_mm_; }
    // Pulls it through, once.
    void cut_rim() { cuts_ = wire_mm_.has_value(); }

    // Where keys and buttons work; none until the first of them.
    [[nodiscard]] std::optional<dvec2> marker_mm() const { return marker_mm_; }
    // Draws the finger to an outline when it is near; see OutlineHelp::set().
    void set_outline(std::span<const vec2> radius_height, double strength) {
        help_.set(radius_height, strength);
    }
    // New clay: nothing has come to it yet.
    void leave_clay();

    // What the tool should do now, dt_s after the last call.
    [[nodiscard]] haptics::ToolState request(const HandSettings& settings, const pot::Pot& shape,
                                             double dt_s);

    [[nodiscard]] bool works() const { return presser_ != Presser::kNobody || touch_.runs(); }

  private:
    enum class Presser { kNobody, kFinger, kGamepad };

    struct WaitingKey {
        HandKey key = HandKey::kUp;
        bool is_button = false;
        double side = 1.0;
    };

    void take_over();
    void ask_for(const WaitingKey& key);
    void work_off_keys(const pot::Pot& shape);
    [[nodiscard]] dvec2 finger_now(const pot::Pot& shape, double dt_s);
    [[nodiscard]] bool presses_now();
    void hold_wire(const pot::Pot& shape);

    Presser presser_ = Presser::kNobody;
    dvec2 finger_mm_{0.0};
    dvec2 shown_before_mm_{0.0};  // where it was in the last frame
    double idle_s_ = 1e9;         // since somebody moved it
    bool pad_held_ = false;       // the gamepad's button: it presses anew only when it was let go
    bool pad_has_come_ = false;   // to the clay that is on the wheel
    KioskTouch touch_;
    std::deque<WaitingKey> waiting_;         // keys that came while a touch was made
    std::uint64_t touches_ = 0;              // begun so far, whoever made them
    std::optional<std::uint64_t> pressing_;  // the one that pressed in the last frame
    bool shows_ = false;                     // the touch is a step of the lesson
    KioskMarker marker_;
    std::optional<dvec2> marker_mm_;
    std::optional<double> wire_mm_;
    bool cuts_ = false;
    OutlineHelp help_;
};

}  // namespace onggi::app
