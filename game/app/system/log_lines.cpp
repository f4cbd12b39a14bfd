#include "game/app/system/log_lines.h"

#include <fmt/format.h>

#include <algorithm>

namespace onggi::app {

std::optional<std::string> LogLines::say(const std::string& line, double now_s) {
    const auto before =
        std::find_if(said_.begin(), said_.end(), [&](const Said& one) { return one.line == line; });
    int held_back = 0;
    if (before != said_.end()) {
        if (now_s - before->at_s < kQuietS) {
            ++before->held_back;
            return std::nullopt;
        }
        held_back = before->held_back;
        said_.erase(before);
    }
    if (said_.size() == kMostRemembered) said_.erase(said_.begin());
    said_.push_back({.line = line, .at_s = now_s});
    return held_back == 0 ? line : fmt::format("{} (and {} times in between)", line, held_back);
}

}  // namespace onggi::app
