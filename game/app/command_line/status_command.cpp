#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/options.h"
#include "game/app/kiosk/health/house_status.h"
#include "game/app/system/report.h"
#include "game/app/system/wall_clock.h"

namespace onggi::app {
namespace {

struct StatusOptions {
    GalleryChoice gallery;
    bool json = false;
};

Result<bool> tell(const StatusOptions& options) {
    const auto config = settings_of(options.gallery);
    if (!config) return config.error();
    const auto status = look_at_house(*config, wall_clock_s());
    if (!status) return status.error();
    const std::string text = options.json ? json_of(*status) : lines_of(*status);
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
        return system_lacks("standard output cannot be written");
    return status->is_well();
}

}  // namespace

void add_status_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand(
        "status", "Report a kiosk's state to monitoring: health, today's visits, last faults");
    const auto options = std::make_shared<StatusOptions>();
    command->add_flag("--json", options->json, "as one JSON object");
    add_gallery_options(*command, options->gallery);
    command->footer(
        "It reads the status file that the kiosk writes once a minute and sends no request to the kiosk, so "
        "it\n"
        "also works while the kiosk is down. Run it as root or as a user of the kiosk's group.\n"
        "Exit codes: 0 the kiosk runs and is well; 1 it does not run or is not well; 2 wrong settings or a "
        "damaged\nfile; 3 its files may not be read.");
    command->callback([options, &exit_status] {
        const auto well = tell(*options);
        exit_status = well ? (*well ? 0 : 1) : report(well.error());
    });
}

}  // namespace onggi::app
