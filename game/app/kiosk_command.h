// `onggi kiosk`, or `onggi` alone: the wheel in a window. The mouse is the hand, the left button or the space
// bar turns the wheel, the scroll wheel or [ ] changes the tool, R puts on a fresh lump, E saves the pot, S
// its picture, F fills the screen, Esc ends. Main thread.
#pragma once

#include <CLI/CLI.hpp>

namespace onggi::app {

void add_kiosk_command(CLI::App& program, int& exit_status);

}  // namespace onggi::app
