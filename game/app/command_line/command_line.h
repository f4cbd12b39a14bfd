// The program's words on the command line: how commands are found, and wrong usage is refused. Main thread.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

// A command's own file registers it with `void add_..._command(CLI::App& program, int& exit_status)`: it
// leaves its exit code there. main lists the commands; each has --help and --version.

// Runs the command that the words name; the words are those of main(). Without a command it is the kiosk,
// where the program has one. Gives the exit code: what the command left in `exit_status`, or 2 with one line
// on stderr for wrong usage.
int run_command_line(CLI::App& program, int argc, const char* const* argv, const int& exit_status);

}  // namespace onggi::app
