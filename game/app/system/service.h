// Notifies the machine's service manager (sd_notify) that the program is ready, well or ending, and of its
// status in a line. Without a manager ($NOTIFY_SOCKET) it does nothing. Main thread.
#pragma once

#include <cstdint>
#include <string>

#include "engine/core/result.h"

namespace onggi::app {

// The counters that advance while the program is well.
struct SignsOfLife {
    std::uint64_t frames_shown = 0;
    std::uint64_t haptic_ticks = 0;  // any number that changes with a tick

    friend bool operator==(const SignsOfLife&, const SignsOfLife&) = default;
};

// Decides whether the watchdog may be notified: it must watch the picture, not only the process. Pure.
class Pulse {
  public:
    // `watchdog_s`: the manager's timeout, 0 for none. It is notified four times as often.
    explicit Pulse(double watchdog_s) : every_s_(watchdog_s / 4.0) {}

    // True when the interval is over and, since the last time, a frame was shown and a tick was done.
    [[nodiscard]] bool is_due(double now_s, const SignsOfLife& signs);

  private:
    double every_s_;
    double last_s_ = -1e9;
    SignsOfLife last_{};
};

class Service {
  public:
    // Reads systemd's $WATCHDOG_USEC. Ignores $WATCHDOG_PID, which names the compositor, the parent of this
    // process.
    Service();

    // Call it once a frame: sends READY=1 with the first sign of life, then WATCHDOG=1 while there are more.
    void live(double now_s, const SignsOfLife& signs);
    // STATUS=, when the line has changed.
    void say(const std::string& line);
    // STOPPING=1.
    void ends();

  private:
    Pulse pulse_;
    bool is_watched_ = false;
    bool is_ready_ = false;
    std::string said_;
};

// Restarts the program on request of the staff's panel: the same program with the same arguments in the same
// process, so that its parent, a shell or systemd, does not see it end. Main thread.

// The exit code of a supervised program that asks its supervisor for a restart, and of a kiosk that cannot
// restart itself: "try again" (EX_TEMPFAIL of sysexits.h). A unit with Restart=always or on-failure then
// starts it again.
constexpr int kRestartExitCode = 75;

// Replaces the process; returns only on failure. No thread may run and no device be open.
[[nodiscard]] Error start_anew();

}  // namespace onggi::app
