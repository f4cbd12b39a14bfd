// The program's log: one line per event on stderr. In the journal of systemd each line has a priority: 3 for
// an error that ended a command, 4 for an error after which the program goes on, 5 for the rest.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::app {

// The prefix of a crash's line in the journal (sd-daemon(3)).
constexpr const char* kCritical = "<2>";

// Reports the error and returns its exit code.
int report(const Error& error);
// The exit code of a command with this result: 0, or that of report().
int exit_code(const Result<void>& done);
// Logs an event that is no failure.
void remark(std::string_view line);
// Logs an error after which the program goes on.
void warn(std::string_view line);

// Whether stderr goes to systemd's journal, which reads priorities.
[[nodiscard]] bool stderr_is_journal();

// Keeps a log readable: a line repeated within a minute is counted and not written, so that a loose cable or
// a recurring fault does not bury other lines. Any one thread at a time; time comes from the caller.
class LogLines {
  public:
    static constexpr double kQuietS = 60.0;
    static constexpr std::size_t kMostRemembered = 32;

    // The line to write now, with the number of suppressed repetitions since the last time, or nothing while
    // it is suppressed.
    [[nodiscard]] std::optional<std::string> say(const std::string& line, double now_s);

  private:
    struct Said {
        std::string line;
        double at_s = 0.0;
        int held_back = 0;
    };
    std::vector<Said> said_;  // oldest first
};

}  // namespace onggi::app
