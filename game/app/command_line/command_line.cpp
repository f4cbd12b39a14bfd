#include "game/app/command_line/commands.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <new>
#include <vector>

#include "engine/core/quote.h"
#include "game/app/system/report.h"
#include "game/app/system/version.h"

namespace onggi::app {
namespace {

constexpr std::string_view kDefaultCommand = "kiosk";

CLI::App* command_named(CLI::App& program, std::string_view name) {
    const auto commands =
        program.get_subcommands([&](CLI::App* command) { return command->get_name() == name; });
    return commands.empty() ? nullptr : commands.front();
}

// Prints the requested help or version, and reports a failed write.
int print(CLI::App& program, const CLI::Success& asked) {
    program.exit(asked, std::cout, std::cerr);
    std::cout.flush();
    return std::cout ? 0 : report(system_lacks("standard output cannot be written"));
}

// "onggi throw: --rate: ... (see onggi throw --help)", always on one line.
int refuse_usage(const CLI::App& program, const CLI::ParseError& error) {
    std::string words = program.get_name();
    for (const CLI::App* command : program.get_subcommands())
        words += " " + command->get_name();
    std::cerr << fmt::format("{}: {} (see {} --help)\n", words, shown_path(error.what()), words);
    return exit_code(ErrorKind::kBadInput);
}

std::string known_commands(CLI::App& program) {
    std::string names;
    for (const CLI::App* command :
         program.get_subcommands([](CLI::App* one) { return !one->get_group().empty(); })) {
        names += (names.empty() ? "" : ", ") + command->get_name();
    }
    return names;
}

}  // namespace

int run_command_line(CLI::App& program, int argc, const char* const* argv, const int& exit_status) {
    const std::string named = program.get_name() + " " + version();
    program.set_version_flag("--version", named);
    for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
        command->set_version_flag("--version", named);
    }
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    const bool asks_program =
        !words.empty() && (words[0] == "--help" || words[0] == "-h" || words[0] == "--version");
    const bool has_default = command_named(program, kDefaultCommand) != nullptr;
    if (has_default && !asks_program && (words.empty() || words[0].starts_with('-'))) {
        words.insert(words.begin(), std::string(kDefaultCommand));
    }
    try {
        if (words.empty() || (!words[0].starts_with('-') && command_named(program, words[0]) == nullptr)) {
            throw CLI::RequiredError(fmt::format("expected a command ({}), found {}", known_commands(program),
                                                 words.empty() ? "none" : in_quotes(words[0])),
                                     CLI::ExitCodes::RequiredError);
        }
        std::reverse(words.begin(), words.end());  // the order that CLI11 expects
        program.parse(words);
        return exit_status;
    } catch (const CLI::Success& asked) {
        return print(program, asked);
    } catch (const CLI::ParseError& error) {
        return refuse_usage(program, error);
    } catch (const std::bad_alloc&) {
        return report(system_lacks("not enough memory"));
    } catch (const std::exception& error) {
        return report(failed(error.what()));
    }
}

}  // namespace onggi::app
