// `onggi film`: the making of a session's pot as a short film. Main thread.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

void add_film_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
