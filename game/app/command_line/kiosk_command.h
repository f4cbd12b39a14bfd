// `onggi kiosk`, or `onggi` alone: the experience a visitor walks up to, from attract to a kept pot. Main
// thread.
#pragma once

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

void add_kiosk_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
