// Starting the program anew, as the staff's panel asks for: the same program with the same words, in the same
// process, so that whoever started it - a shell, systemd - sees it go on. Main thread.
#pragma once

#include "engine/core/result.h"

namespace onggi::app {

// What a supervised program ends with when its supervisor shall begin anew, and what a kiosk ends with when
// it cannot: "try again" (EX_TEMPFAIL of sysexits.h). A unit with Restart=always or on-failure starts it
// then.
constexpr int kRestartExitCode = 75;

// Takes the process over; returns only where that failed. No thread may run, no device be open.
[[nodiscard]] Error start_anew();

}  // namespace onggi::app
