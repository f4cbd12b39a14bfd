#include <CLI/CLI.hpp>
#include <cstdio>
#include <vector>

#include "game/app/command_line/commands.h"
#include "game/app/command_line/finding.h"

namespace onggi::app {

void add_devices_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand("devices", "List the devices that can hold the tool");
    command->callback([&exit_status] {
        const std::vector<Finding> findings = probe_haptic_devices();
        std::fputs(findings_as_text(findings).c_str(), stdout);
        exit_status = 0;  // a missing device does not make the command fail
    });
}

}  // namespace onggi::app
