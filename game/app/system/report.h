// What the program says of itself, a line an event, on stderr. Where that is the journal of systemd each line
// has its priority: 3 for what ended a command, 4 for what went wrong and was borne, 5 for the rest.
#pragma once

#include <string_view>

#include "engine/core/result.h"

namespace onggi::app {

// Before a line in the journal (sd-daemon(3)), a crash's.
constexpr const char* kCritical = "<2>";

// The exit code that belongs to the error, after saying it.
int report(const Error& error);
// That of a command which has come to this: 0, or what report() says.
int exit_code(const Result<void>& done);
// What is no failure.
void remark(std::string_view line);
// What went wrong and the program goes on.
void warn(std::string_view line);

// Whether what is written to stderr is read by systemd's journal, which takes priorities.
[[nodiscard]] bool stderr_is_journal();

}  // namespace onggi::app
