// The program's version and commit, for bug reports. Any thread.
#pragma once

#include <string>

namespace onggi::app {

// "0.1.0 (72112cf1a2b3, 2026-11-24)": the commit it was built from and that commit's day, UTC. ".changed"
// behind the commit says that the checkout differed from it; "unknown" stands there for a build outside git.
[[nodiscard]] std::string version();
// That day, YYYY-MM-DD.
[[nodiscard]] std::string commit_day();

}  // namespace onggi::app
