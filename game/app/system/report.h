// What the program says of itself, a line an event, on stderr. Where that is the journal of systemd each line
// has its priority: 3 for what ended a command, 4 for what went wrong and was borne, 5 for the rest.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::app {

// Before a line in the journal (sd-daemon(3)), a crash's.
constexpr const char* kCritical = "<2>";

// The exit code that belongs to the error, after saying it.
int report(const Error& error);
// That of a command which has come to this: 0, or what report() says.
int exit_code(const Result<void>& done);
// What is no failure.
void remark(std::string_view line);
// What went wrong and the program goes on.
void warn(std::string_view line);

// Whether what is written to stderr is read by systemd's journal, which takes priorities.
[[nodiscard]] bool stderr_is_journal();

// Keeps a log readable: a line that comes again within a minute is counted and not said, so that a loose
// cable, or a fault that comes back as often as it is taken back, does not bury what matters. Any one thread
// at a time; time comes from the caller.
class LogLines {
  public:
    static constexpr double kQuietS = 60.0;
    static constexpr std::size_t kMostRemembered = 32;

    // The line as it is to be said now, with how often it was held back since the last time; none: not now.
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
