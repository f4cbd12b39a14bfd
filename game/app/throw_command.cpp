#include "game/app/throw_command.h"

#include <chrono>
#include <memory>

#include "game/app/command_line.h"
#include "game/app/performance.h"
#include "game/app/progress.h"
#include "game/app/throw_outputs.h"

namespace onggi::app {
namespace {

struct ThrowOptions {
    InputOptions input;
    ThrowOutputs outputs;
};

Result<void> throw_pot(const ThrowOptions& options) {
    if (auto outputs = check_outputs(options.outputs); !outputs) return outputs;
    auto performance = load_performance(options.input);
    if (!performance) return performance.error();
    if (performance->remark) remark(*performance->remark);
    auto writer = OutputWriter::create(options.outputs, performance->start);
    if (!writer) return writer.error();

    haptic::HapticState& state = performance->start.state;
    const haptic::HapticParameters& parameters = performance->start.parameters;
    haptics::HapticDevice& hand = *performance->hand;
    if (auto opened = hand.open(); !opened) return opened;
    jobs::Histogram tick_ns;
    haptic::TickResult last;
    {
        Progress progress("throwing", performance->tick_count);
        for (std::uint64_t tick = 0; tick < performance->tick_count; ++tick) {
            const haptics::ToolState tool = hand.read(tick, parameters.dt_s());
            const auto before = std::chrono::steady_clock::now();
            last = haptic::tick(state, tool, parameters);
            const std::chrono::nanoseconds took = std::chrono::steady_clock::now() - before;
            tick_ns.record(took.count());
            hand.write(last.limited_force_n);
            if (auto added = writer->add_tick(state, last); !added) return added;
            progress.reached(tick);
        }
    }
    hand.close();
    return writer->finish(state, last, tick_ns);
}

}  // namespace

void add_throw_command(CLI::App& program, int& exit_status) {
    CLI::App* command =
        program.add_subcommand("throw", "Throw a gesture or session in simulated time, without a window");
    const auto options = std::make_shared<ThrowOptions>();
    add_input_file(*command, options->input);
    add_clay_options(*command, options->input);
    add_rate_option(*command, options->input);
    const auto add_output = [&](const char* name, std::optional<std::string>& place, const char* kind,
                                const char* description) {
        return command->add_option(name, place, description)->type_name(kind);
    };
    ThrowOutputs& outputs = options->outputs;
    add_output("--profile", outputs.profile, "F.csv", "the pot's outline, one row an element");
    add_output("--forces", outputs.forces, "F.csv", "the forces, one row a tick");
    add_output("--export", outputs.model, "F.glb|F.stl", "the pot as a solid");
    CLI::Option* screenshot =
        add_output("--screenshot", outputs.screenshot, "F.png", "a picture; needs Vulkan");
    add_size_option(*command, outputs.size)->needs(screenshot);
    add_output("--save", outputs.session, "F.onggi", "the session, for replay");
    add_output("--stats", outputs.stats, "F.json", "what the ticks cost");
    command->callback([options, &exit_status] {
        const auto done = throw_pot(*options);
        exit_status = done ? 0 : report(done.error());
    });
}

}  // namespace onggi::app
