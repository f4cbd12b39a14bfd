// Injects disk faults: counts every call by which this process, including its libraries, changes something
// below a folder, and lets the chosen call, or all calls from it on, fail or kill the process. The program's
// code is unchanged: the test program interposes the C library's functions (write, rename, ...). One thread.
#pragma once

#include <filesystem>
#include <string>

namespace onggi::faults {

enum class Kind {
    kNone,      // only counts
    kKilled,    // SIGKILL before that call
    kTorn,      // writes half of that call's data, then SIGKILL; before the call if it writes nothing
    kPowerCut,  // as kKilled, and unsynced data is lost
    kFullOnce,  // ENOSPC, once
    kFull,      // ENOSPC from there on, except for removals, which need no space
    kBroken,    // EIO from there on
    kReadOnly,  // EROFS from there on
};
[[nodiscard]] const char* name_of(Kind kind);

// Arms the fault in this process. `at` counts from 1.
void arm(const std::filesystem::path& folder, Kind kind, long at);
void disarm();
// Calls since arm(), and a description of the failed one: "write 120 bytes to /.../wall.json".
[[nodiscard]] long calls();
[[nodiscard]] const std::string& failed_call();

}  // namespace onggi::faults
