// `onggi share`: serves the outbox to phones, in a process of its own that can do nothing else. Main thread.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

void add_share_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
