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

// By one write, so that lines of two threads or processes do not mix; and one line whatever is in it.
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

}  // namespace onggi::app
