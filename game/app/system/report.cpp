#include "game/app/system/report.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace onggi::app {
namespace {

// Uses one write, so that lines of two threads or processes do not mix, and replaces line breaks.
void say(std::string_view priority, std::string_view words) {
    static const bool is_journal = stderr_is_journal();
    std::string line = fmt::format("{}onggi: {}", is_journal ? priority : std::string_view(), words);
    std::replace(line.begin(), line.end(), '\n', ' ');
    line += '\n';
    std::cerr.write(line.data(), static_cast<std::streamsize>(line.size()));
}

}  // namespace

bool stderr_is_journal() {
    // "DEVICE:INODE" of the stream that systemd made for the service (systemd.exec(5)).
    const char* named = std::getenv("JOURNAL_STREAM");
    struct stat status {};
    if (named == nullptr || ::fstat(STDERR_FILENO, &status) != 0) return false;
    return fmt::format("{}:{}", status.st_dev, status.st_ino) == named;
}

int report(const Error& error) {
    say("<3>", error.message);
    return exit_code(error.kind);
}

void warn(std::string_view line) {
    say("<4>", line);
}

int exit_code(const Result<void>& done) {
    return done ? 0 : report(done.error());
}

void remark(std::string_view line) {
    say("<5>", line);
}

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
