#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

#include "engine/files/atomic_file.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/manual_page.h"
#include "game/app/system/report.h"
#include "game/app/system/version.h"

namespace onggi::app {
namespace {

Result<void> write(const CLI::App& program, const std::filesystem::path& folder) {
    const std::string named = program.get_name() + " " + version();
    const auto page =
        files::write_file_atomically(folder / "onggi.1", manual_page(program, named, commit_day()));
    if (!page) return page;
    return files::write_file_atomically(folder / "onggi.bash", bash_completion(program));
}

}  // namespace

void add_manual_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand("manual", "Write onggi.1 and onggi.bash into a folder");
    command->group("");
    const auto folder = std::make_shared<std::string>();
    command->add_option("folder", *folder, "an existing folder")->required()->type_name("FOLDER");
    command->callback([folder, &program, &exit_status] { exit_status = exit_code(write(program, *folder)); });
}

}  // namespace onggi::app
