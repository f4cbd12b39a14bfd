// What the machine's service manager is told of the program (sd_notify): that it is ready, that it is well,
// in a line what it does, that it ends. Where no manager listens ($NOTIFY_SOCKET), nothing happens. Main
// thread.
#pragma once

#include <cstdint>
#include <string>

#include "engine/core/result.h"

namespace onggi::app {

// What has to go on for the program to be well.
struct SignsOfLife {
    std::uint64_t frames_shown = 0;
    std::uint64_t haptic_ticks = 0;  // any number that is another one after a tick

    friend bool operator==(const SignsOfLife&, const SignsOfLife&) = default;
};

// Whether the manager may be told that all is well: a watchdog must see the picture, not the process. Pure.
class Pulse {
  public:
    // `watchdog_s`: how long the manager waits, 0 for ever. It is told four times as often.
    explicit Pulse(double watchdog_s) : every_s_(watchdog_s / 4.0) {}

    // True when it is time, and since the last time a frame was shown and a tick was done.
    [[nodiscard]] bool is_due(double now_s, const SignsOfLife& signs);

  private:
    double every_s_;
    double last_s_ = -1e9;
    SignsOfLife last_{};
};

class Service {
  public:
    // Of the environment that systemd sets: $WATCHDOG_USEC. $WATCHDOG_PID names the compositor, whose child
    // this is, and is not asked.
    Service();

    // Once a frame that may have been shown: READY=1 with the first sign of life, WATCHDOG=1 while there are
    // more.
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

// Starting the program anew, as the staff's panel asks for: the same program with the same words, in the same
// process, so that whoever started it - a shell, systemd - sees it go on. Main thread.

// What a supervised program ends with when its supervisor shall begin anew, and what a kiosk ends with when
// it cannot: "try again" (EX_TEMPFAIL of sysexits.h). A unit with Restart=always or on-failure starts it
// then.
constexpr int kRestartExitCode = 75;

// Takes the process over; returns only where that failed. No thread may run, no device be open.
[[nodiscard]] Error start_anew();

}  // namespace onggi::app
