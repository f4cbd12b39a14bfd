// Converts pointer, gamepad, keys, buttons and the ledge's settings to the request for the tool: a finger on
// the upright plane through the axis. While it presses, the skilled hands follow it in the clay. Pure state,
// no window and no clock, so that tests can play the visitor. Main thread. mm, s.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "engine/math/math.h"
#include "game/app/kiosk/finger/kiosk_marker.h"
#include "game/app/kiosk/finger/kiosk_touch.h"
#include "game/kiosk/state.h"
#include "game/pot/pot.h"
#include "game/tool/tool_state.h"

namespace onggi::app {

// Helps a finger along a shown outline: it pulls a nearby finger a little towards the outline, so that a
// trembling hand still throws the shown pot. Pure state, main thread. mm, s.

// Strength of the help, 0 to 1. It decreases with the steps of the lesson that are done.
[[nodiscard]] double outline_help_after(int steps_done);

class OutlineHelp {
  public:
    // Radius and height from below, as heritage::wet_outline(); empty: no help. strength: 0 (no help) to 1.
    void set(std::span<const vec2> radius_height, double strength);
    // Fades the help in and out, so that the change is not felt.
    void pass_time(double dt_s);
    // Returns the corrected finger, which is never farther from the outline than the finger, nor on its other
    // side.
    [[nodiscard]] dvec2 drawn(const dvec2& finger_mm) const;

  private:
    std::vector<vec2> outline_mm_;
    double strength_ = 0.0;  // target of the fade
    double now_ = 0.0;
};

// The hand's tool, in the steps of the ledge.
struct HeldTool {
    tool::Tool tool = tool::Tool::kHand;
    int size = 2;   // 1 to 3
    int water = 3;  // 1 to 5
    int speed = 3;  // of the wheel, 1 to 5
};

// An idle finger away from the clay.
[[nodiscard]] tool::ToolState resting_finger();

class KioskFinger {
  public:
    // A finger or a pressed mouse at a place on that plane. It takes over from any other input. A place that
    // is not a number, or jumps farther than a hand moves, releases the finger. The first request after a
    // press is for its place, however far the finger has come since: the clay judges a touch by its start.
    void press(const dvec2& place_mm);
    void drag(const dvec2& place_mm);
    // The finger has left. A touch that began since the last request still gets its requests, at its start
    // and at its end.
    void lift();
    // A second finger: the other hand while the first presses. If either lifts, the other goes on. It ends
    // with a place that is no number, or with a jump, and the first goes on.
    void press_second(const dvec2& place_mm);
    void drag_second(const dvec2& place_mm);
    void lift_second();
    // How hard a pen pushes, 0 to 1 of its range; empty: a finger or a mouse, whose push is fixed. A pen that
    // only rests does not press.
    void push(std::optional<double> pressure);
    // Ends the touch of any input at once.
    void release();
    // A hovering mouse.
    void hover(const dvec2& place_mm);
    // A gamepad, once a frame: moves the finger by `step_mm`, and presses or not. The first step on new clay
    // puts the finger beside the clay, low on `side`: +1 right, -1 left.
    void steer(const dvec2& step_mm, bool presses, const pot::Pot& shape, double side);
    // An arrow key, and a button of the pad on the screen.
    void key(FingerKey key, double side) { ask_for({key, false, side}); }
    void button(FingerKey key, double side) { ask_for({key, true, side}); }

    // Plays a step of the lesson on the current clay. Any finger, key, button or gamepad takes over.
    void show(kiosk::ShownStep step, const pot::Pot& shape, double side);
    void stop_showing();
    [[nodiscard]] bool shows() const { return shows_ && touch_.runs(); }

    // Height of the wire's line round the wall; empty if the wire is not held.
    [[nodiscard]] std::optional<double> wire_mm() const { return wire_mm_; }
    // Pulls the wire through the clay, once.
    void cut_rim() { cuts_ = wire_mm_.has_value(); }

    // The marker of keys and buttons; empty until the first of them.
    [[nodiscard]] std::optional<dvec2> marker_mm() const { return marker_mm_; }
    // Pulls the finger to a nearby outline; see OutlineHelp::set().
    void set_outline(std::span<const vec2> radius_height, double strength) {
        help_.set(radius_height, strength);
    }
    // New clay: resets finger, touch and marker.
    void leave_clay();

    // Returns the request for the tool now, dt_s after the last call.
    [[nodiscard]] tool::ToolState request(const HeldTool& held, const pot::Pot& shape, double dt_s);

    [[nodiscard]] bool works() const { return presser_ != Presser::kNobody || touch_.runs(); }

  private:
    enum class Presser { kNobody, kFinger, kGamepad };

    struct WaitingKey {
        FingerKey key = FingerKey::kUp;
        bool is_button = false;
        double side = 1.0;
    };

    void take_over();
    void begin(const dvec2& place_mm);
    void follow(const dvec2& place_mm);
    // The leading finger has gone. passes_on(): whether the other one leads now.
    void end();
    [[nodiscard]] bool passes_on();
    void follow_other(const dvec2& place_mm);
    [[nodiscard]] bool finger_presses() const { return presser_ == Presser::kFinger && !is_lifted_; }
    void drop_leap(double dt_s);
    [[nodiscard]] dvec2 take_place();
    void ask_for(const WaitingKey& key);
    void work_off_keys(const pot::Pot& shape);
    [[nodiscard]] dvec2 finger_now(const pot::Pot& shape, double dt_s);
    [[nodiscard]] bool presses_now();
    void hold_wire(const pot::Pot& shape);

    Presser presser_ = Presser::kNobody;
    dvec2 finger_mm_{0.0};
    dvec2 shown_before_mm_{0.0};     // the finger in the last frame
    std::optional<dvec2> began_mm_;  // of a touch that no request has shown yet
    bool is_lifted_ = false;         // the touch ends when its last place was requested
    // Of two fingers, the one that came first leads, and the other one is the other hand.
    std::optional<dvec2> other_mm_;
    bool second_leads_ = false;
    double push_ = 1.0;          // of a finger's; 0: a pen that rests
    double idle_s_ = 1e9;        // since the finger last moved
    bool pad_held_ = false;      // the gamepad's button; a new press needs a release first
    bool pad_has_come_ = false;  // the gamepad's finger is at the clay on the wheel
    KioskTouch touch_;
    std::deque<WaitingKey> waiting_;         // keys that arrived during a touch
    std::uint64_t touches_ = 0;              // touches begun so far, by any input
    std::optional<std::uint64_t> pressing_;  // the touch that pressed in the last frame
    bool shows_ = false;                     // the touch is a step of the lesson
    KioskMarker marker_;
    std::optional<dvec2> marker_mm_;
    std::optional<double> wire_mm_;
    bool cuts_ = false;
    OutlineHelp help_;
};

}  // namespace onggi::app
