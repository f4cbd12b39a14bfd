// Options shared by several commands, with their bounds. Main thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/quality.h"
#include "game/clay/studio/pot.h"
#include "game/kiosk/config.h"
#include "game/wheel/still.h"

// Only declared: including CLI11 costs ten seconds of compile time, so only files that register options
// include it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace onggi::app {

// A pot to throw on instead of a fresh lump (performance.h).
struct StartPot {
    std::optional<std::string> on = {};  // a session whose pot is put back on the wheel
    std::optional<std::string> joined =
        {};  // another session, whose pot is turned upside down and joined rim to rim
    std::optional<double> bore_mm = {};  // the opening cut into the joined pot; inside diameter
};

// The input of a throw: a hand's path and, for a gesture, the rate and the clay, which its file does not
// contain.
struct InputOptions {
    std::string file;  // a gesture or a session, recognised by its content
    std::optional<double> rate_hz = {};
    std::optional<int> element_count = {};
    std::optional<std::string> clay = {};     // "studio" (the default) or "paper"
    std::optional<double> clay_mass_g = {};   // of a studio lump
    std::optional<clay::ClayBody> body = {};  // of a studio lump; default stoneware
    std::optional<std::string> wheel = {};    // "electric" (the default) or "kick"
    bool forgiving = false;                   // the wheel slows down before the clay fails
    StartPot start = {};                      // in place of a lump
};

// The gallery of a kiosk, by its settings.
struct GalleryChoice {
    std::string config;   // empty: the usual file, if present
    std::string gallery;  // overrides the settings' folder, if not empty
};

struct PictureSize {
    int width = 1280;
    int height = 720;
};

// Drawings of the pot and its measures, as files.
struct DrawingOptions {
    std::vector<std::string> drawings{};    // .svg, .pdf
    std::optional<std::string> measures{};  // .json
    std::string credit{};
};

// The input file, the command's positional argument.
void add_input_file(CLI::App& command, InputOptions& options);
void add_rate_option(CLI::App& command, InputOptions& options);  // --rate HZ
// --clay, --elements, --clay-mass, --body, --wheel, --forgiving
void add_clay_options(CLI::App& command, InputOptions& options);
void add_start_pot_options(CLI::App& command, StartPot& options);  // --on, --join, --mouth
// --fired STAGE; `what` is its help text
void add_firing_option(CLI::App& command, clay::Firing& stage, const std::string& what);
void add_drawing_options(CLI::App& command, DrawingOptions& options);  // --drawing, --credit, --measures
CLI::Option* add_size_option(CLI::App& command, PictureSize& size);    // --size WxH
// --volume, 0 to 1; 0: no sound device is opened at all.
void add_volume_option(CLI::App& command, std::optional<double>& volume);
// --backend: the renderer.
CLI::Option* add_backend_option(CLI::App& command, std::optional<render::BackendChoice>& backend,
                                const std::string& description);
// --device: a device accepted by names_a_device(), or `first`, the name of this command's first device.
CLI::Option* add_device_option(CLI::App& command, std::string& word, const std::string& first = "mouse");
// --view; requires `picture`, the option that requests a picture.
void add_view_option(CLI::App& command, wheel::StillView& view, CLI::Option* picture);

void add_gallery_options(CLI::App& command, GalleryChoice& choice);  // --config, --gallery
// The settings that add_gallery_options() chose. Errors as read_config_file().
[[nodiscard]] Result<kiosk::Config> settings_of(const GalleryChoice& choice);
// An option whose value is one of `words`.
CLI::Option* add_word_option(CLI::App& command, const std::string& name,
                             const std::vector<std::string>& words, std::string& word,
                             const std::string& description);

// An option with a decimal number within bounds: no hexadecimal, no "nan", independent of the locale.
CLI::Option* add_number_option(CLI::App& command, const std::string& name, std::optional<double>& number,
                               double least, double most, const std::string& description);

}  // namespace onggi::app
