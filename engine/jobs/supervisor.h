// A supervisor process: it starts the program in a child process and only waits. When the child crashes or
// the kernel's out-of-memory killer ends it, the child can no longer remove a force; the supervisor then
// calls after_crash. It uses no device, draws nothing and holds no lock, so it survives what kills the child.
#pragma once

#include <functional>
#include <optional>

namespace onggi::jobs {

// Forks. Main thread, before any other thread starts and before anything is printed. In the child it returns
// empty at once, and the child continues as the program. In the supervisor it returns after the child has
// ended, with the exit code to use: the child's own, or 1 after a crash, once after_crash(signal) has
// returned. Exit code 1 counts as a crash without a signal (0), because a library that loses its display
// exits like this.
//
// The supervisor forwards SIGINT, SIGTERM, SIGHUP and SIGABRT (a service manager's watchdog) to the child; a
// terminal's Ctrl-C reaches the child by itself. SIGCHLD has its default action afterwards, in both. The
// child gets SIGTERM if its supervisor is killed. If fork() fails the program runs unsupervised.
[[nodiscard]] std::optional<int> supervise(const std::function<void(int signal)>& after_crash);

}  // namespace onggi::jobs
