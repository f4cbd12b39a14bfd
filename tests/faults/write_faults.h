// A disk that fails where a test wants it to: every call by which this process, its libraries among them,
// would change something below a folder is counted, and one of them, or all from there on, fails or is the
// last thing the process does. The program's own code is as it is shipped: the test's program answers to the
// C library's names (write, rename, ...) in its place. One thread.
#pragma once

#include <filesystem>
#include <string>

namespace onggi::faults {

enum class Kind {
    kNone,    // count alone
    kKilled,  // SIGKILL before that call
    kTorn,  // half of what that call would write is written, then SIGKILL; before it where it writes nothing
    kPowerCut,  // as kKilled, and what was not synced yet is gone
    kFullOnce,  // ENOSPC, once
    kFull,      // ENOSPC from there on, but for what takes no room: names that go away
    kBroken,    // EIO from there on
    kReadOnly,  // EROFS from there on
};
[[nodiscard]] const char* name_of(Kind kind);

// From now on, in this process. `at` counts from 1.
void arm(const std::filesystem::path& folder, Kind kind, long at);
void disarm();
// Calls since arm(), and what the one was that failed: "write 120 bytes to /.../wall.json".
[[nodiscard]] long calls();
[[nodiscard]] const std::string& failed_call();

}  // namespace onggi::faults
