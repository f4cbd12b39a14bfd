// The signals that ask a program to end - a terminal's Ctrl-C, `kill`, a closing session - as a question that
// a loop asks itself. The loop then ends as it always does: the haptic thread stops, and every device is told
// to let go. Main thread.
#pragma once

namespace onggi::app {

// From now on SIGINT, SIGTERM and SIGHUP are noted instead of ending the program on the spot. A second Ctrl-C
// does end it: nobody waits for a loop that hangs. A second SIGTERM is no more than the first: a service
// manager sends one to every process, and the supervisor hands its own on.
// A locked kiosk takes no notice of SIGINT, which a keyboard can send.
void note_end_signals(bool locked = false);

// Whether one has come.
[[nodiscard]] bool end_was_asked();

}  // namespace onggi::app
