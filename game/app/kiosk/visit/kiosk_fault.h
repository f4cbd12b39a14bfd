// What a latched fault of the safety chain means to a visitor. The force is off; the clay goes on. So whoever
// throws, by mouse, touch or anything else, goes on too, and is told; only a clay that has lost its senses
// ends a visit. Pure state, no clock. Main thread, once a frame. s.
#pragma once

#include "engine/haptics/safety_chain.h"

namespace onggi::app {

class KioskFault {
  public:
    // How long the wheel waits before it takes a fault back by itself: what passed by needs no staff.
    static constexpr double kRestS = 5.0;

    struct Advice {
        bool force_rests = false;  // say so, and let the visitor go on
        bool wheel_rests = false;  // the clay itself is at fault: nobody can throw
        bool take_back = false;    // try again now
    };
    // now_s ascends. A person's stop is never taken back by a clock, but by whoever takes new clay.
    [[nodiscard]] Advice look(haptics::Fault fault, double now_s);

  private:
    haptics::Fault last_ = haptics::Fault::kNone;
    double tried_s_ = 0.0;  // or since when there is one
};

}  // namespace onggi::app
