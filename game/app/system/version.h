// The program's version and commit, for bug reports. Any thread.
#pragma once

#include <string>

namespace onggi::app {

// "0.1.0 (72112cf1a2b3, 2026-11-24)": the version, the commit that was built, and the commit's day, UTC.
// ".changed" after the commit means that the checkout differed from it; outside git, "unknown" replaces the
// commit.
[[nodiscard]] std::string version();
// The commit's day, YYYY-MM-DD.
[[nodiscard]] std::string commit_day();

}  // namespace onggi::app
