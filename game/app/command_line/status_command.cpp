#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/finding.h"
#include "game/app/kiosk/health/house_status.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/system/report.h"
#include "game/app/system/wall_clock.h"
#include "game/kiosk/config.h"

namespace onggi::app {
namespace {

struct StatusOptions {
    std::string config;
    std::string gallery;
    bool json = false;
};

Result<kiosk::Config> settings_of(const StatusOptions& options) {
    std::error_code error;
    kiosk::Config config;
    const std::string file = options.config.empty() ? kUsualSettings : options.config;
    if (!options.config.empty() || std::filesystem::exists(file, error)) {
        auto read = read_config_file(file);
        if (!read) return read;
        config = std::move(*read);
    }
    if (!options.gallery.empty()) config.gallery.folder = options.gallery;
    return config;
}

Result<bool> tell(const StatusOptions& options) {
    const auto config = settings_of(options);
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
    command
        ->add_option("--config", options->config,
                     fmt::format("settings of the kiosk; default: those in {}, if present", kUsualSettings))
        ->type_name("FILE.toml");
    command->add_option("--gallery", options->gallery, "the folder of its pots, overriding the settings")
        ->type_name("FOLDER");
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
