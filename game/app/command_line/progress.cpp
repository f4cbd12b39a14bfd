#include "game/app/command_line/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <utility>

namespace onggi::app {
namespace {

// Shorter work needs no progress line, and more frequent updates are unreadable.
constexpr std::chrono::milliseconds kBetween{200};

}  // namespace

Progress::Progress(std::string doing, std::uint64_t of)
    : doing_(std::move(doing)),
      of_(of),
      shown_(::isatty(STDERR_FILENO) == 1),
      last_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
    if (width_ > 0) std::cerr << '\r' << std::string(width_, ' ') << '\r' << std::flush;
}

void Progress::show(std::uint64_t done) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < kBetween) return;
    last_ = now;
    const std::string line = fmt::format("{} {} %", doing_, of_ == 0 ? 100 : done * 100 / of_);
    width_ = line.size();
    std::cerr << '\r' << line << std::flush;
}

}  // namespace onggi::app
