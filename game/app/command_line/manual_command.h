// onggi manual: writes the program's own manual page and completion, for whoever installs it. Not listed in
// --help. Main thread.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

void add_manual_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
