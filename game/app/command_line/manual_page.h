// The command line as a manual page and as words for a shell, made of the same tree that --help is printed
// from. Any thread; no file is touched.
#pragma once

#include <string>

#include "game/app/command_line/cli_names.h"

namespace onggi::app {

// onggi(1) in troff's man macros: the program, each command that help lists with its options and notes.
// `named` is its version, `day` (YYYY-MM-DD) its date.
[[nodiscard]] std::string manual_page(const CLI::App& program, const std::string& named,
                                      const std::string& day);

// What bash completes after "onggi": commands, their options, the words that an option takes, files.
[[nodiscard]] std::string bash_completion(const CLI::App& program);

}  // namespace onggi::app
