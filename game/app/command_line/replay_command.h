// `onggi replay`: simulates a session again and compares it with what was recorded. Main thread.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

void add_replay_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
