// Where the calm cue lies: round what of the clay the hands hold, what a touch would take hold of, or where
// the lesson wants the next one; when it is to be seen; and how far the hands lag behind a finger. Pure
// state, the caller's clock. Main thread, once a frame. mm, s.
#pragma once

#include <optional>

#include "game/clay/studio/grip.h"
#include "game/pot/pot.h"
#include "game/screens/page/cue.h"

namespace onggi::app {

// A stretch of the wall's outer face; or the middle of the top, where a touch opens.
struct CueHold {
    double low_mm = 0.0;
    double high_mm = 0.0;
    double opening_mm = 0.0;  // radius of what is opened, at the height high_mm; 0: a stretch of the wall
};

// What a finger at that place of the upright plane would take hold of; nothing where it is off the clay.
[[nodiscard]] std::optional<CueHold> hold_of_touch(const pot::Pot& shape, const dvec2& finger_mm,
                                                   bool with_tool = false);
// Where a step of the lesson, counted from 0, begins.
[[nodiscard]] CueHold hold_of_step(const pot::Pot& shape, int step);

// From a finger to the hands that lag behind it.
struct CueThread {
    dvec2 finger_mm{0.0};
    dvec2 hand_mm{0.0};
    double strength = 0.0;  // 0 where they are nearly together, to 1
};
// Nothing where no hand is at work.
[[nodiscard]] std::optional<CueThread> thread_of(const clay::studio::GripReport& grip);

struct CueMoment {
    double now_s = 0.0;
    const pot::Pot& shape;
    const clay::studio::GripReport& grip;  // of hands that press, the visitor's or the wheel's own
    bool is_shown = false;                 // they are the wheel's own
    std::optional<int> wanted_step{};      // of the lesson, while its cue is to be seen
    std::optional<dvec2> hovers_mm{};      // a mouse, over the upright plane
    std::optional<dvec2> marker_mm{};      // where keys work, which nobody could see otherwise
    bool with_tool = false;                // a rib or a sponge is held, which lies on the wall
    bool still = false;                    // less motion
};

struct CuePlace {
    std::optional<CueHold> hold{};
    std::optional<CueThread> thread{};
    std::optional<int> step{};  // whose way the arrow shows, beside where that step begins
    screens::CueGuard guard = screens::CueGuard::kNone;
    double hand_side = 0.0;  // on which side of the axis a hand is at work: +1 right; 0: none is
};

class KioskCue {
  public:
    // Nothing: no cue.
    [[nodiscard]] std::optional<CuePlace> look(const CueMoment& moment);
    // New clay.
    void begin() { *this = {}; }

  private:
    void follow_progress(const CueMoment& moment, double dt_s);
    void follow_guard(const CueMoment& moment, double dt_s);
    [[nodiscard]] CueHold eased(const CueHold& hold, const CueMoment& moment, double dt_s);

    double last_s_ = 0.0;
    dvec2 hand_mm_{0.0};
    double came_on_s_ = 0.0;  // how long the clay has followed since the cue came
    double stood_s_ = 0.0;    // and how long it has not
    bool is_known_ = false;   // the visitor has got on without
    clay::studio::GripGuard guard_ = clay::studio::GripGuard::kNone;
    double guard_s_ = 0.0;
    std::optional<CueHold> shown_;
};

}  // namespace onggi::app
