// The signals that request the program's end (Ctrl-C of a terminal, `kill`, a closing session), as a flag for
// a loop to poll. The loop then ends normally: the haptic thread stops, and every device is silenced. Main
// thread.
#pragma once

namespace onggi::app {

// From now on SIGINT, SIGTERM and SIGHUP set a flag instead of ending the program. A second Ctrl-C ends it,
// because the loop may hang. A second SIGTERM has no further effect: a service manager sends one to every
// process, and the supervisor forwards its own. A locked kiosk ignores SIGINT, which a keyboard can send.
void note_end_signals(bool locked = false);

// Whether a signal has arrived.
[[nodiscard]] bool end_was_asked();

}  // namespace onggi::app
