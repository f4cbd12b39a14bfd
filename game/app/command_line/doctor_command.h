// `onggi doctor`: what the machine offers, what each lack costs, and how to mend it.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

// Sets exit_status to 0 when it could look, to 3 with --strict where something is lacking.
void add_doctor_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
