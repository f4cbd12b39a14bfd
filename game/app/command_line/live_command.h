// `onggi live`: a gesture or session in real time, with its picture. Main thread.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "game/app/command_line/cli_names.h"
#include "game/app/command_line/live_loop.h"

namespace onggi::app {

void add_live_command(CLI::App& program, int& exit_status);

// What --stats writes of a live run.
[[nodiscard]] nlohmann::ordered_json live_stats(const LiveReport& report);

}  // namespace onggi::app
