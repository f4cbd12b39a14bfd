// `onggi status`: how a wheel fares, by what it leaves on the disk.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

// Sets exit_status to 0 where the wheel is well, to 1 where it is not, to 2 where its settings are wrong, to
// 3 where they or its files may not be read.
void add_status_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
