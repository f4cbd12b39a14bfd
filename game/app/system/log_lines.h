// Keeps a log readable: a line that comes again within a minute is counted and not said, so that a loose
// cable, or a fault that comes back as often as it is taken back, does not bury what matters. Any one thread
// at a time; time comes from the caller.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace onggi::app {

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
