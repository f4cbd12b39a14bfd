// A process that watches over another: it starts the program's work in a child and does nothing but wait.
// When the child dies on the spot - a crash, the kernel's out-of-memory killer - nobody is left in it to take
// a force away; the supervisor is, and does what it was given to do. It touches no device, draws nothing and
// holds no lock, so that what kills the child leaves it alone.
#pragma once

#include <functional>
#include <optional>

namespace onggi::jobs {

// Main thread, before any other thread is started and anything is printed: forks. The child gets nothing and
// goes on as the program. The supervisor stays in here until the child has ended, and gets the exit code to
// end with: the child's own, or 1 after a crash, once after_crash(signal) has returned. An end with exit code
// 1 counts as a crash without a signal (0): a library that loses its display ends the program on the spot in
// this way.
//
// SIGINT, SIGTERM, SIGHUP and SIGABRT, a service manager's watchdog, sent to the supervisor are handed on; a
// terminal's Ctrl-C reaches the child by itself. SIGCHLD is as usual afterwards, in both. A child whose
// supervisor is killed gets SIGTERM. Where no process can be made the program runs unsupervised.
[[nodiscard]] std::optional<int> supervise(const std::function<void(int signal)>& after_crash);

}  // namespace onggi::jobs
