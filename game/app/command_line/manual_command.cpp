#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/atomic_file.h"
#include "game/app/command_line/commands.h"
#include "game/app/system/report.h"
#include "game/app/system/version.h"

namespace onggi::app {
namespace {

// Makes the manual page and the shell completion from the same tree as --help.

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

// Escapes text for troff: hyphens that can be copied, backslashes, and lines that would be requests.
std::string as_troff(std::string_view text) {
    std::string out;
    bool begins_line = true;
    for (const char letter : text) {
        if (begins_line && (letter == '.' || letter == '\'')) out += "\\&";
        if (letter == '-') {
            out += "\\-";
        } else if (letter == '\\') {
            out += "\\e";
        } else {
            out += letter;
        }
        begins_line = letter == '\n';
    }
    return out;
}

std::string as_upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](char letter) {
        return letter >= 'a' && letter <= 'z' ? char(letter - 'a' + 'A') : letter;
    });
    return text;
}

// Help texts are table cells and may start with a small letter; a manual page has sentences.
std::string as_sentence(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

std::string options_of(const CLI::App& command) {
    const CLI::Formatter formatter;
    std::string page;
    for (const bool positional : {true, false}) {
        for (const CLI::Option* option : command.get_options()) {
            const bool is_positional = !option->nonpositional();
            if (is_positional != positional || option->get_group().empty()) continue;
            page += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n",
                                as_troff(formatter.make_option_name(option, positional)),
                                as_troff(formatter.make_option_opts(option)),
                                as_troff(as_sentence(option->get_description())));
        }
    }
    return page;
}

std::string notes_of(const CLI::App& command) {
    if (command.get_footer().empty()) return {};
    return fmt::format(".PP\n.nf\n{}\n.fi\n", as_troff(command.get_footer()));
}

bool is_flag(const CLI::Option& option) {
    return option.get_items_expected_max() == 0;
}

// Returns the words that an option accepts, as "wet|dry|bisque|glaze", or nothing if it accepts other values.
std::string words_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const bool are_words =
        type.find('|') != std::string::npos && std::all_of(type.begin(), type.end(), [](char letter) {
            return letter == '|' || letter == '-' || (letter >= 'a' && letter <= 'z');
        });
    if (!are_words) return {};
    std::string words = type;
    std::replace(words.begin(), words.end(), '|', ' ');
    return words;
}

bool takes_file(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    return type.find('.') != std::string::npos || type == "FOLDER" || type == "PIPE";
}

std::string with_dashes(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : option.get_snames())
        names += (names.empty() ? "-" : " -") + name;
    for (const std::string& name : option.get_lnames())
        names += (names.empty() ? "--" : " --") + name;
    return names;
}

// Returns onggi(1) in troff's man macros: the program, and each command that help lists, with its options and
// notes. `named` is the program's version, `day` (YYYY-MM-DD) its date.
std::string manual_page(const CLI::App& program, const std::string& named, const std::string& day) {
    std::string page = fmt::format(
        ".\\\" Written by the program from its own command line.\n"
        ".TH ONGGI 1 {} \"{}\" \"User Commands\"\n.SH NAME\nonggi \\- {}\n.SH SYNOPSIS\n"
        ".B onggi\n[\\fICOMMAND\\fR] [\\fIOPTION\\fR]...\n.SH DESCRIPTION\n"
        "A visitor takes a stylus, a joystick, a controller, a mouse or a touch screen, and throws a pot; "
        "the clay "
        "yields,\ndrags and pushes back. Without a command it is \\fBonggi kiosk\\fR.\n.SH COMMANDS\n",
        day, as_troff(named), as_troff(program.get_description()));
    for (const CLI::App* command : commands_of(program)) {
        page += fmt::format(".TP\n\\fB{}\\fR\n{}\n", as_troff(command->get_name()),
                            as_troff(as_sentence(command->get_description())));
    }
    for (const CLI::App* command : commands_of(program)) {
        page += fmt::format(".SH {}\n\\fBonggi {}\\fR: {}\n", as_upper(as_troff(command->get_name())),
                            as_troff(command->get_name()), as_troff(as_sentence(command->get_description())));
        page += options_of(*command) + notes_of(*command);
    }
    page +=
        ".SH EXIT STATUS\n"
        ".TP\n0\nDone.\n.TP\n1\nSomething else failed.\n.TP\n2\nBad usage or input.\n.TP\n3\nThe system "
        "lacks "
        "something.\n"
        ".SH ENVIRONMENT\n"
        ".TP\n\\fBONGGI_VULKAN_DEVICE\\fR\nThe GPU that draws, by its number or a part of its name; "
        "\\fBonggi "
        "doctor\\fR lists them.\n"
        ".TP\n\\fBONGGI_ASSETS\\fR\nThe folder with what the program brings along, in the place of its own.\n"
        ".SH SEE ALSO\n.BR kiosk.toml (5),\n.BR onggi\\-kiosk (8)\n";
    return page;
}

// Returns the bash completion for "onggi": commands, their options, the words that an option accepts, files.
std::string bash_completion(const CLI::App& program) {
    std::string commands;
    std::string cases;
    for (const CLI::App* command : commands_of(program)) {
        commands += (commands.empty() ? "" : " ") + command->get_name();
        std::string options;
        std::string values;
        std::string first;  // the words of a first argument
        for (const CLI::Option* option : command->get_options()) {
            const std::string names = with_dashes(*option);
            if (names.empty()) first += words_of(*option);
            if (names.empty() || option->get_group().empty()) continue;
            options += (options.empty() ? "" : " ") + names;
            if (is_flag(*option)) continue;
            std::string any = names;
            std::replace(any.begin(), any.end(), ' ', '|');
            const std::string words = words_of(*option);
            const char* how = !words.empty() ? "words" : takes_file(*option) ? "files" : "nothing";
            values +=
                fmt::format("            {}) {} {} ;;\n", any, how, words.empty() ? "" : "'" + words + "'");
        }
        if (!first.empty())
            values += fmt::format("            {}) words '{} {}' ;;\n", command->get_name(), first, options);
        cases += fmt::format(
            "    {})\n        case $before in\n{}            *) options_or_files '{}' ;;\n        esac\n     "
            "   ;;\n",
            command->get_name(), values, options);
    }
    return fmt::format(
        "# bash completion for onggi. Written by the program from its own command line.\n"
        "_onggi() {{\n"
        "    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}\n"
        "    words() {{ mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$word\"); }}\n"
        "    files() {{ mapfile -t COMPREPLY < <(compgen -f -- \"$word\"); compopt -o filenames 2>/dev/null; "
        "}}\n"
        "    nothing() {{ COMPREPLY=(); }}\n"
        "    options_or_files() {{ if [[ $word == -* ]]; then words \"$1\"; else files; fi; }}\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        words '{0} --help --version'\n"
        "    else\n"
        "    case ${{COMP_WORDS[1]}} in\n{1}    esac\n"
        "    fi\n"
        "    unset -f words files nothing options_or_files\n"
        "}}\n"
        "complete -F _onggi onggi\n",
        commands, cases);
}

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
