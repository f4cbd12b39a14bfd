// Options that several commands have, with their bounds said once. Main thread.
#pragma once

#include <optional>
#include <string>

#include "engine/render/quality.h"
#include "game/clay/studio/pot.h"
#include "game/wheel/still.h"

// Named only: the whole of CLI11 takes g++ ten seconds, so only the files that register options include it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace onggi::app {

// A pot to throw on instead of a fresh lump (performance.h).
struct StartPot {
    std::optional<std::string> on = {};      // a session: its pot is put back on the wheel
    std::optional<std::string> joined = {};  // another: its pot is turned upside down and joined rim to rim
    std::optional<double> mouth_mm = {};     // the opening cut into the joined pot, inside
};

// What to throw: a hand, and for a gesture the rate and the clay it does not bring itself.
struct InputOptions {
    std::string file;  // a gesture or a session, told apart by content
    std::optional<double> rate_hz = {};
    std::optional<int> element_count = {};
    std::optional<std::string> clay = {};     // "studio" unless it says "paper"
    std::optional<double> clay_mass_g = {};   // of a studio lump
    std::optional<clay::ClayBody> body = {};  // of the same; stoneware unless it says otherwise
    std::optional<std::string> wheel = {};    // "electric" unless it says "kick"
    bool forgiving = false;                   // the wheel slows before the clay gives way
    StartPot start = {};                      // in place of a lump
};

struct PictureSize {
    int width = 1280;
    int height = 720;
};

// The file, as the command's one word without dashes.
void add_input_file(CLI::App& command, InputOptions& options);
void add_rate_option(CLI::App& command, InputOptions& options);  // --rate HZ
// --clay, --elements, --clay-mass, --body, --wheel, --forgiving
void add_clay_options(CLI::App& command, InputOptions& options);
void add_start_pot_options(CLI::App& command, StartPot& options);  // --on, --join, --mouth
// --fired STAGE, which is `what`
void add_firing_option(CLI::App& command, clay::Firing& stage, const std::string& what);
CLI::Option* add_size_option(CLI::App& command, PictureSize& size);  // --size WxH
// --volume, 0 to 1; 0: no sound device is opened at all.
void add_volume_option(CLI::App& command, std::optional<double>& volume);
// --backend: who draws.
CLI::Option* add_backend_option(CLI::App& command, std::optional<render::BackendChoice>& backend,
                                const std::string& description);
// --device: a word that names_a_device(), or `first`, what the first hand is called here.
CLI::Option* add_device_option(CLI::App& command, std::string& word, const std::string& first = "mouse");
// --view; it needs `picture`, the option that asks for one.
void add_view_option(CLI::App& command, wheel::StillView& view, CLI::Option* picture);

// An option with a plain decimal number within bounds: no hexadecimal, no "nan", whatever the locale.
CLI::Option* add_number_option(CLI::App& command, const std::string& name, std::optional<double>& number,
                               double least, double most, const std::string& description);

}  // namespace onggi::app
