// What is left behind when the program dies on the spot: a backtrace on stderr, which is the journal of a
// service, and the session that led there, for `onggi replay`. Without a core file, a second program or a
// question to the disk: by glibc's backtrace(), whose lines are written straight to a descriptor, where
// boost.stacktrace leaves raw addresses for a program that starts again to make words of.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/core/result.h"

namespace onggi::app {

// From now on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT are reported before they end the program, each as a
// line an event, by what may be called in a signal handler. A handler that is there already, a sanitizer's,
// stays. An allocation that fails where nobody catches it ends the program with one line and exit code 3 instead. Main
// thread, before others and before a supervisor's fork.
void report_crashes();

// Any one thread at a time: a crash from now on was led to by the session that grows there, and it is to be
// kept in that folder. Empty: nobody throws. Paths longer than the system's own limit are taken for none.
void crash_leads_to(const std::filesystem::path& session, const std::filesystem::path& keep_in) noexcept;

// For a supervisor, after the death of its child: keeps the session that led there, by a second name for the
// same bytes, as crash-N.onggi, the oldest of kMostCrashes giving way. Gives where it is; nothing: nobody
// threw. System lacks: the disk does not take it.
constexpr int kMostCrashes = 20;
[[nodiscard]] Result<std::optional<std::filesystem::path>> keep_crash_session();

}  // namespace onggi::app
