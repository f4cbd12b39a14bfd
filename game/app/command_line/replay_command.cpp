#include "game/app/command_line/replay_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include "engine/core/quote.h"
#include "game/app/command_line/performance.h"
#include "game/app/command_line/progress.h"
#include "game/app/system/report.h"

namespace onggi::app {
namespace {

struct ReplayOptions {
    std::string file;
    bool validate = false;
};

std::string sentence_for(const Difference& difference) {
    if (difference.first_tick == difference.last_tick) {
        return fmt::format("tick {} is the first that differs: {}", difference.first_tick, difference.what);
    }
    return fmt::format("the first tick that differs is one of {} to {}: {}", difference.first_tick,
                       difference.last_tick, difference.what);
}

Result<void> validate(const std::string& file) {
    auto loaded = load_session(file);
    if (!loaded) return loaded.error();
    if (const auto cut = remark_on_cut(loaded->session, file)) remark(*cut);

    std::optional<Difference> difference;
    {
        Progress progress("replaying", loaded->session.tick_count());
        difference = find_difference(loaded->session, std::move(loaded->start),
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

std::optional<Difference> find_difference(const record::Session& session, haptic::Start start,
                                          const std::function<void(std::uint64_t)>& reached) {
    if (start.state.hash() != session.header().start_state_hash) {
        return Difference{0, 0, "the start state is not the one that was recorded"};
    }
    record::SessionCursor cursor(session);
    for (const record::Session::Block& block : session.blocks()) {
        const std::uint64_t end = block.first_tick + block.tick_count;
        for (std::uint64_t tick = block.first_tick; tick < end; ++tick) {
            const auto result = haptic::tick(start.state, cursor.at(tick), start.parameters);
            if (record::force_check(result.forces.total_n()) != session.force_check_at(tick)) {
                return Difference{tick, tick, "its force is not the one that was recorded"};
            }
            if (reached) reached(tick);
        }
        if (start.state.hash() != block.state_hash) {
            return Difference{block.first_tick, end - 1,
                              "every force is as recorded, but the state after them is not"};
        }
    }
    return std::nullopt;
}

void add_replay_command(CLI::App& program, int& exit_status) {
    CLI::App* command =
        program.add_subcommand("replay", "Simulate a session again and compare it with its recording");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("file", options->file, "a recorded session")->type_name("SESSION.onggi")->required();
    command->add_flag("--validate", options->validate, "compare every stored hash; exit 1 where one differs")
        ->required();
    command->callback([options, &exit_status] {
        const auto same = validate(options->file);
        exit_status = same ? 0 : report(same.error());
    });
}

}  // namespace onggi::app
