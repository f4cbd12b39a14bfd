#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>

#include "game/app/command_line/commands.h"
#include "game/app/command_line/performance.h"
#include "game/app/command_line/progress.h"
#include "game/app/command_line/throw_outputs.h"
#include "game/app/system/report.h"

namespace onggi::app {
namespace {

struct ThrowOptions {
    InputOptions input;
    ThrowOutputs outputs;
    std::optional<std::string> target;
};

Result<std::string> throw_pot(ThrowOptions options) {
    auto target = find_target_choice(options.target);
    if (!target) return target.error();
    options.outputs.target = std::move(target).value();
    if (auto outputs = check_outputs(options.outputs); !outputs) return outputs.error();
    auto performance = load_performance(options.input);
    if (!performance) return performance.error();
    if (performance->remark) remark(*performance->remark);
    if (performance->start.state.studio() == nullptr) {
        if (options.target) return bad_input("--target: expected the studio clay, found the paper's");
        if (options.outputs.stage != clay::Firing::kWet)
            return bad_input("--fired: expected the studio clay, found the paper's, which is never fired");
    }
    auto writer = OutputWriter::create(options.outputs, performance->start);
    if (!writer) return writer.error();

    haptic::HapticState& state = performance->start.state;
    const haptic::HapticParameters& parameters = performance->start.parameters;
    haptic::ToolDevice& player = *performance->player;
    if (auto opened = player.open(); !opened) return opened.error();
    jobs::Histogram tick_ns;
    haptic::TickResult last;
    {
        Progress progress("throwing", performance->tick_count);
        for (std::uint64_t tick = 0; tick < performance->tick_count; ++tick) {
            const tool::ToolState tool = player.read_tool(tick, parameters.dt_s());
            const auto before = std::chrono::steady_clock::now();
            last = haptic::tick(state, tool, parameters);
            const std::chrono::nanoseconds took = std::chrono::steady_clock::now() - before;
            tick_ns.record(took.count());
            player.write(last.limited_force_n);
            if (auto added = writer->add_tick(state, last); !added) return added.error();
            progress.reached(tick);
        }
    }
    player.close();
    return writer->finish(state, last, tick_ns);
}

void add_target_option(CLI::App& command, std::optional<std::string>& id) {
    command
        .add_option("--target", id,
                    "score the fired pot against a museum's, or against the one nearest in shape; an unknown "
                    "name lists all")
        ->type_name("ID|nearest");
}

}  // namespace

void add_throw_command(CLI::App& program, int& exit_status) {
    CLI::App* command =
        program.add_subcommand("throw", "Throw a gesture or session in simulated time, without a window");
    const auto options = std::make_shared<ThrowOptions>();
    add_input_file(*command, options->input);
    add_clay_options(*command, options->input);
    add_rate_option(*command, options->input);
    add_start_pot_options(*command, options->input.start);
    const auto add_output = [&](const char* name, std::optional<std::string>& place, const char* kind,
                                const char* description) {
        return command->add_option(name, place, description)->type_name(kind);
    };
    ThrowOutputs& outputs = options->outputs;
    add_output("--profile", outputs.profile, "F.csv", "the pot's outline, one row per element");
    add_output("--forces", outputs.forces, "F.csv", "the forces, one row per tick");
    add_output("--export", outputs.model, "F.glb|F.stl|F.3mf|F.usdz", "the pot as a solid");
    CLI::Option* screenshot =
        add_output("--screenshot", outputs.screenshot, "F.png", "a picture; needs Vulkan");
    add_size_option(*command, outputs.size)->needs(screenshot);
    command
        ->add_flag("--beauty", outputs.beauty, "the picture as the mean of many samples: finer, and slower")
        ->needs(screenshot);
    add_view_option(*command, outputs.view, screenshot);
    add_backend_option(*command, outputs.backend,
                       "what draws the picture: the GPU, or software in its place (gpu, auto); or the "
                       "processor, as in the live window without a GPU: faster, and coarser")
        ->needs(screenshot);
    add_firing_option(*command, outputs.stage, "the stage that --export, --drawing and --screenshot show");
    add_target_option(*command, options->target);
    add_output("--save", outputs.session, "F.onggi", "the session, for replay");
    add_drawing_options(*command, outputs.drawing);
    add_output("--stats", outputs.stats, "F.json", "what the ticks cost");
    command->callback([options, &exit_status] {
        const auto said = throw_pot(*options);
        if (said) std::fputs(said->c_str(), stdout);
        exit_status = said ? 0 : report(said.error());
    });
}

}  // namespace onggi::app
