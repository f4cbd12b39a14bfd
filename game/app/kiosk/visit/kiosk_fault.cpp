#include "game/app/kiosk/visit/kiosk_fault.h"

namespace onggi::app {

KioskFault::Advice KioskFault::look(haptics::Fault fault, double now_s) {
    using haptics::Fault;
    if (fault != last_) {
        last_ = fault;
        tried_s_ = now_s;
    }
    if (fault == Fault::kNone) return {};
    Advice advice;
    advice.wheel_rests = fault == Fault::kForceNotFinite;
    advice.force_rests = !advice.wheel_rests;
    if (fault == Fault::kStopped || now_s - tried_s_ < kRestS) return advice;
    tried_s_ = now_s;
    advice.take_back = true;
    return advice;
}

}  // namespace onggi::app
