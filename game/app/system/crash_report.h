// Reports a crash: writes a backtrace to stderr, the journal of a service, and keeps the session that led to
// the crash, for `onggi replay`. It needs no core file, no second program and no disk access: glibc's
// backtrace() writes its lines to a descriptor, whereas boost.stacktrace leaves raw addresses for a later
// process to decode.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/core/result.h"

namespace onggi::app {

// From now on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT are reported before they end the program, one line
// per event, with async-signal-safe functions. An existing handler, such as a sanitizer's, stays. An
// allocation failure that nothing catches ends the program with one line and exit code 3. Main thread, before
// other threads start and before a supervisor's fork.
void report_crashes();

// From now on a crash belongs to the session that is being written at `session`; keep_crash_session() will
// keep it in `keep_in`. Empty paths mean that no visitor is throwing. Paths longer than the system's limit
// count as empty. One thread at a time.
void crash_leads_to(const std::filesystem::path& session, const std::filesystem::path& keep_in) noexcept;

// For a supervisor, after the death of its child: keeps the session of the crash as a hard link
// crash-N.onggi, which replaces the oldest of kMostCrashes. Returns its path, or nothing if no visitor was
// throwing. System lacks: the disk refuses it.
constexpr int kMostCrashes = 20;
[[nodiscard]] Result<std::optional<std::filesystem::path>> keep_crash_session();

}  // namespace onggi::app
