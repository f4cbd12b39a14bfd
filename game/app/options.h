// Options that several commands have, with their bounds said once. Main thread.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace onggi::app {

// What to throw: a hand, and for a gesture the rate and the clay it does not bring itself.
struct InputOptions {
    std::string file;  // a gesture or a session, told apart by content
    std::optional<double> rate_hz = {};
    std::optional<int> element_count = {};
    std::optional<std::string> clay = {};
};

struct PictureSize {
    int width = 1280;
    int height = 720;
};

// The file, as the command's one word without dashes.
void add_input_file(CLI::App& command, InputOptions& options);
void add_rate_option(CLI::App& command, InputOptions& options);      // --rate HZ
void add_clay_options(CLI::App& command, InputOptions& options);     // --clay NAME, --elements N
CLI::Option* add_size_option(CLI::App& command, PictureSize& size);  // --size WxH

// An option with a plain decimal number within bounds: no hexadecimal, no "nan", whatever the locale.
CLI::Option* add_number_option(CLI::App& command, const std::string& name, std::optional<double>& number,
                               double least, double most, const std::string& description);

}  // namespace onggi::app
