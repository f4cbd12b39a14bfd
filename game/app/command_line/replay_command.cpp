#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <utility>

#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/options.h"
#include "game/app/command_line/progress.h"
#include "game/app/command_line/throw_outputs.h"
#include "game/app/replay/replay.h"
#include "game/app/replay/stored_session.h"
#include "game/app/system/report.h"

namespace onggi::app {
namespace {

struct ReplayOptions {
    std::string file;
    bool validate = false;
    clay::Firing stage = clay::Firing::kWet;
    DrawingOptions drawing;
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

Result<void> draw(const ReplayOptions& options) {
    auto loaded = load_session(options.file);
    if (!loaded) return loaded.error();
    if (const auto cut = remark_on_cut(loaded->session, options.file); cut && !options.validate) remark(*cut);
    Replay replay(loaded->session, std::move(loaded->start));
    std::optional<Difference> difference = replay.compare_start();
    {
        Progress progress("replaying", loaded->session.tick_count());
        for (; !difference && !replay.is_over(); progress.reached(replay.ticks()))
            difference = replay.step();
    }
    if (difference) return failed(fmt::format("{}: {}", shown_path(options.file), sentence_for(*difference)));
    const auto drawn = drawn_files(replay.state(), options.stage, options.drawing);
    if (!drawn) return drawn.error();
    return write_all(*drawn);
}

Result<void> replay(const ReplayOptions& options) {
    const bool draws = !options.drawing.drawings.empty() || options.drawing.measures;
    if (!options.validate && !draws)
        return bad_input("replay: expected --validate, --drawing or --measures, found none");
    if (auto checked = check_drawings(options.drawing); !checked) return checked;
    if (options.validate)
        if (auto valid = validate(options.file); !valid) return valid;
    return draws ? draw(options) : Result<void>();
}

}  // namespace

void add_replay_command(CLI::App& program, int& exit_status) {
    CLI::App* command =
        program.add_subcommand("replay", "Simulate a session again and compare it with its recording");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("file", options->file, "a recorded session")->type_name("SESSION.onggi")->required();
    command->add_flag("--validate", options->validate, "compare every stored hash; exit 1 where one differs");
    add_firing_option(*command, options->stage, "the stage that --drawing shows");
    add_drawing_options(*command, options->drawing);
    command->callback([options, &exit_status] { exit_status = exit_code(replay(*options)); });
}

}  // namespace onggi::app
