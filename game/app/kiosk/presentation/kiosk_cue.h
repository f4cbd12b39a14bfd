// The place of the cue: round the clay that the hands hold, that a touch would hold, or where the lesson
// expects the next touch. Also its visibility, and the lag of the hands behind a finger. Pure state, the
// caller's clock. Main thread, once a frame. mm, s.
#pragma once

#include <optional>

#include "game/clay/studio/grip.h"
#include "game/pot/pot.h"
#include "game/screens/page/cue.h"

namespace onggi::app {

// A height range of the wall's outer face, or the middle of the top, where a touch opens the clay.
struct CueHold {
    double low_mm = 0.0;
    double high_mm = 0.0;
    double opening_mm = 0.0;  // radius of the opening, at the height high_mm; 0: a range of the wall
};

// The hold of a finger at that place of the vertical plane; nothing off the clay.
[[nodiscard]] std::optional<CueHold> hold_of_touch(const pot::Pot& shape, const dvec2& finger_mm,
                                                   bool with_tool = false);
// The hold with which a step of the lesson, counted from 0, begins.
[[nodiscard]] CueHold hold_of_step(const pot::Pot& shape, int step);

// The line from a finger to the hands that lag behind it.
struct CueThread {
    dvec2 finger_mm{0.0};
    dvec2 hand_mm{0.0};
    double strength = 0.0;  // 0 when nearly together, to 1
};
// Returns nothing if no hand is working.
[[nodiscard]] std::optional<CueThread> thread_of(const clay::studio::GripReport& grip);

struct CueMoment {
    double now_s = 0.0;
    const pot::Pot& shape;
    const clay::studio::GripReport& grip;  // of pressing hands, a visitor's or a demonstration's
    bool is_shown = false;                 // the hands are a demonstration's
    std::optional<int> wanted_step{};      // of the lesson, while its cue is shown
    std::optional<dvec2> hovers_mm{};      // a mouse over the vertical plane
    std::optional<dvec2> marker_mm{};      // the place that keys act on, otherwise invisible
    bool with_tool = false;                // a rib or a sponge is held
    bool still = false;                    // less motion
};

struct CuePlace {
    std::optional<CueHold> hold{};
    std::optional<CueThread> thread{};
    std::optional<int> step{};         // the step whose direction the arrow shows, at its start
    std::optional<dvec2> marker_mm{};  // else the arrow points at this place
    screens::CueGuard guard = screens::CueGuard::kNone;
    double hand_side = 0.0;  // the side of the axis with a working hand: +1 right; 0: no hand
};

class KioskCue {
  public:
    // Returns nothing without a cue.
    [[nodiscard]] std::optional<CuePlace> look(const CueMoment& moment);
    // New clay.
    void begin() { *this = {}; }

  private:
    void follow_progress(const CueMoment& moment, double dt_s);
    void follow_guard(const CueMoment& moment, double dt_s);
    [[nodiscard]] CueHold eased(const CueHold& hold, const CueMoment& moment, double dt_s);

    double last_s_ = 0.0;
    dvec2 hand_mm_{0.0};
    double came_on_s_ = 0.0;  // time for which the clay has followed since the cue appeared
    double stood_s_ = 0.0;    // time for which it has not followed
    bool is_known_ = false;   // the visitor succeeds without the cue
    clay::studio::GripGuard guard_ = clay::studio::GripGuard::kNone;
    double guard_s_ = 0.0;
    std::optional<CueHold> shown_;
};

}  // namespace onggi::app
