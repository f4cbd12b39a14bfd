#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include "engine/core/quote.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/progress.h"
#include "game/app/replay/replay.h"
#include "game/app/replay/stored_session.h"
#include "game/app/system/report.h"

namespace onggi::app {
namespace {

struct ReplayOptions {
    std::string file;
    bool validate = false;
};

Result<void> validate(const std::string& file) {
    auto loaded = load_session(file);
    if (!loaded) return loaded.error();
    if (const auto cut = remark_on_cut(loaded->session, file)) remark(*cut);

    std::optional<Difference> difference;
    {
        Progress progress("replaying", loaded->session.tick_count());
        difference = find_difference(loaded->session, std::move(loaded->start), loaded->decoration,
                                     [&](std::uint64_t tick) { progress.reached(tick); });
    }
    if (difference) return failed(fmt::format("{}: {}", shown_path(file), sentence_for(*difference)));
    std::cout << fmt::format("{}: {} ticks replayed: every force and every stored state ({}) is the same\n",
                             shown_path(file), loaded->session.tick_count(),
                             loaded->session.blocks().size() + 1);
    std::cout.flush();
    return std::cout ? Result<void>{} : system_lacks("standard output cannot be written");
}

}  // namespace

void add_replay_command(CLI::App& program, int& exit_status) {
    CLI::App* command =
        program.add_subcommand("replay", "Simulate a session again and compare it with its recording");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("file", options->file, "a recorded session")->type_name("SESSION.onggi")->required();
    command->add_flag("--validate", options->validate, "compare every stored hash; exit 1 where one differs")
        ->required();
    command->callback([options, &exit_status] { exit_status = exit_code(validate(options->file)); });
}

}  // namespace onggi::app
