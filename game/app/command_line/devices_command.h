// `onggi devices`: what there is to hold and feel the clay with.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

void add_devices_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
