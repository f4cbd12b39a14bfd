// `onggi throw`: a gesture or session in simulated time, as fast as it can, without a window. Main thread.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

void add_throw_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
