#include "game/app/command_line/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <initializer_list>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/core/number_in.h"
#include "engine/core/quote.h"
#include "game/app/command_line/finding.h"
#include "game/app/devices/attached_devices.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/clay/paper_clay.h"
#include "game/clay/studio/lump.h"
#include "game/exporter/studio_export.h"
#include "game/tool/gesture.h"

namespace onggi::app {
namespace {

// Limits of a picture's sides: smaller ones show nothing; larger render targets are not guaranteed by Vulkan
// devices.
constexpr int kMinSide = 16;
constexpr int kMaxSide = 8192;

// Reads the text itself, for CLI11 takes 010 for 8
// (findings/cli11-reads-a-number-with-a-leading-zero-as-octal.sh).
template <typename T>
CLI::Option* add_bounded(CLI::App& command, const std::string& name, std::optional<T>& number, T least,
                         T most, const std::string& kind, const std::string& description) {
    const auto read = [&number, name, least, most](const CLI::results_t& words) {
        const auto found = number_in<T>(words.at(0));
        if (!found || !(*found >= least && *found <= most)) {
            throw CLI::ValidationError(
                name, fmt::format("expected {} to {}, found {}", least, most, in_quotes(words.at(0))));
        }
        number = *found;
        return true;
    };
    return command.add_option(name, read, description)->type_name(kind);
}

// Adds an option whose value is one of several words; each stands for one value of T.
template <typename T, typename Slot>
CLI::Option* add_choice(CLI::App& command, const std::string& name,
                        const std::vector<std::pair<std::string, T>>& words, Slot& slot,
                        const std::string& description) {
    std::string kind;
    for (const auto& [word, value] : words)
        kind += (kind.empty() ? "" : "|") + word;
    const auto read = [words, &slot, name, kind](const CLI::results_t& given) {
        for (const auto& [word, value] : words) {
            if (word != given.at(0)) continue;
            slot = value;
            return true;
        }
        throw CLI::ValidationError(name, fmt::format("expected {}, found {}", kind, in_quotes(given.at(0))));
    };
    return command.add_option(name, read, description)->type_name(kind);
}
template <typename T, typename Name>
std::vector<std::pair<std::string, T>> named(std::initializer_list<T> values, Name&& name_of) {
    std::vector<std::pair<std::string, T>> words;
    for (const T value : values)
        words.emplace_back(name_of(value), value);
    return words;
}

}  // namespace

void add_gallery_options(CLI::App& command, GalleryChoice& choice) {
    command
        .add_option("--config", choice.config,
                    fmt::format("settings of the kiosk; default: those in {}, if present", kUsualSettings))
        ->type_name("FILE.toml");
    command.add_option("--gallery", choice.gallery, "the folder of its pots, overriding the settings")
        ->type_name("FOLDER");
}

Result<kiosk::Config> settings_of(const GalleryChoice& choice) {
    std::error_code error;
    kiosk::Config config;
    const std::string file = choice.config.empty() ? kUsualSettings : choice.config;
    if (!choice.config.empty() || std::filesystem::exists(file, error)) {
        auto read = read_config_file(file);
        if (!read) return read;
        config = std::move(*read);
    }
    if (!choice.gallery.empty()) config.gallery.folder = choice.gallery;
    return config;
}

CLI::Option* add_word_option(CLI::App& command, const std::string& name,
                             const std::vector<std::string>& words, std::string& word,
                             const std::string& description) {
    std::vector<std::pair<std::string, std::string>> themselves;
    for (const std::string& one : words)
        themselves.emplace_back(one, one);
    return add_choice(command, name, themselves, word, description);
}

CLI::Option* add_number_option(CLI::App& command, const std::string& name, std::optional<double>& number,
                               double least, double most, const std::string& description) {
    return add_bounded(command, name, number, least, most, "NUMBER", description);
}

void add_input_file(CLI::App& command, InputOptions& options) {
    command.add_option("file", options.file, "a gesture (.csv) or a recorded session (.onggi)")
        ->type_name("GESTURE.csv|SESSION.onggi")
        ->required();
    command.footer(fmt::format(
        "A gesture is a table with the header line\n"
        "  t_s,x_mm,y_mm,z_mm,button,tool_radius_mm\n"
        "and rows with t_s rising from 0 to at most 3600. Position (wheel frame, y up from the wheel head, "
        "within\n"
        "+-1000) is linear between rows; button (0 the wheel stands, 1 it turns) and tool radius (2 to 40) "
        "hold from\n"
        "their row on. More columns may follow to the right; the studio clay uses those below. An empty\n"
        "field is treated like a missing column:\n"
        "  tool             {}\n"
        "  side             {}: the side that an approaching hand aims at\n"
        "  water            0 dry to 1 dripping: hands that slide, a sponge that gives\n"
        "  wheel_rev_min    0 to 300: speed while the button is 1 (120)\n"
        "  assist_gap_mm    0 to 60: least gap to a second hand, which squeezes on the way up; 0 none\n"
        "  shaft_mm         0 to 40: radius of the arm that holds an inside tool from above\n"
        "  wire, wire_y_mm  none, rim (cut it level) or off (cut the pot off), and at which height\n"
        "  hand2_x_mm, hand2_y_mm, hand2_z_mm, and if wanted hand2_radius_mm, hand2_tool: the second hand,\n"
        "                   absent where its place is empty\n"
        "  guided           0 or 1: x, y are a finger on the vertical plane z = 0 through the axis, and two "
        "simulated\n"
        "                   hands follow it; 0 a ball in the clay (0)\n"
        "  pressing         0 or 1: hands that do not press do not touch the clay, wherever they are (1)\n"
        "The wheel head is at y = 0; a studio lump of 1000 g is a dome 124 mm wide and 50 mm high.",
        fmt::join(tool::kToolWords, ", "), fmt::join(tool::kSideWords, ", ")));
}

void add_rate_option(CLI::App& command, InputOptions& options) {
    add_bounded(command, "--rate", options.rate_hz, tool::kMinRateHz, tool::kMaxRateHz, "HZ",
                "ticks a second, 100 to 10000, for a gesture (1000)");
}

void add_clay_options(CLI::App& command, InputOptions& options) {
    add_choice<std::string>(command, "--clay", {{"studio", "studio"}, {"paper", "paper"}}, options.clay,
                            "the clay's model, for a gesture (studio)");
    add_bounded(
        command, "--elements", options.element_count, clay::kMinElements, clay::kMaxElements, "N",
        "elements over 200 mm, 100 to 200000, for a gesture (2000); the studio clay takes the nearest "
        "it can have, 200 to 4000");
    add_bounded(command, "--clay-mass", options.clay_mass_g, clay::kLeastLumpG, clay::kLargestLumpG, "G",
                "mass of a studio lump in grams, 100 to 5000, for a gesture (1000)");
    add_choice(command, "--body",
               named({clay::ClayBody::kStoneware, clay::ClayBody::kPorcelain, clay::ClayBody::kEarthenware},
                     [](clay::ClayBody body) { return exporter::name_of(body); }),
               options.body, "body of a studio lump, for a gesture (stoneware)");
    add_choice<std::string>(command, "--wheel", {{"electric", "electric"}, {"kick", "kick"}}, options.wheel,
                            "under the studio clay (electric)");
    command.add_flag("--forgiving", options.forgiving,
                     "the wheel slows by itself before the studio clay gives way");
}

void add_start_pot_options(CLI::App& command, StartPot& options) {
    CLI::Option* on =
        command.add_option("--on", options.on, "throw a gesture on the pot that this session left")
            ->type_name("SESSION.onggi");
    CLI::Option* join = command
                            .add_option("--join", options.joined,
                                        "turn the pot that this session left upside down and join it to "
                                        "that one, rim to rim; its floor is cut out")
                            ->type_name("SESSION.onggi")
                            ->needs(on);
    constexpr double kWidestMouthMm = 290.0;
    add_number_option(command, "--mouth", options.bore_mm, 1.0, kWidestMouthMm,
                      "cut the joined pot open this wide inside, mm (as wide as its floor was)")
        ->needs(join);
}

void add_firing_option(CLI::App& command, clay::Firing& stage, const std::string& what) {
    add_choice(command, "--fired",
               named({clay::Firing::kWet, clay::Firing::kDry, clay::Firing::kBisque, clay::Firing::kGlaze},
                     [](clay::Firing known) { return exporter::name_of(known); }),
               stage, what + ": wet, dry, bisque or glaze (wet)");
}

void add_drawing_options(CLI::App& command, DrawingOptions& options) {
    CLI::Option* drawing =
        command
            .add_option(
                "--drawing", options.drawings,
                "the archaeologist's drawing at 1:1, half a section and half an elevation; may be repeated")
            ->type_name("F.svg|F.pdf")
            ->allow_extra_args(false);
    command
        .add_option("--credit", options.credit,
                    "whose the pot is: a line below the drawing's measures, and in F.json")
        ->type_name("TEXT")
        ->needs(drawing);
    command.add_option("--measures", options.measures, "the pot's measures, wet and glazed")
        ->type_name("F.json");
}

CLI::Option* add_size_option(CLI::App& command, PictureSize& size) {
    const std::string usual = fmt::format("the picture's size in pixels ({}x{})", size.width, size.height);
    const auto read = [&size](const CLI::results_t& words) {
        const std::string_view text = words.at(0);
        const std::size_t cross = std::min(text.find('x'), text.size());
        const auto width = number_in<int>(text.substr(0, cross));
        const auto height = number_in<int>(text.substr(std::min(cross + 1, text.size())));
        const auto fits = [](const std::optional<int>& side) {
            return side && *side >= kMinSide && *side <= kMaxSide;
        };
        if (!fits(width) || !fits(height)) {
            throw CLI::ValidationError("--size", fmt::format("expected WIDTHxHEIGHT, each {} to {}, found {}",
                                                             kMinSide, kMaxSide, in_quotes(text)));
        }
        size = {*width, *height};
        return true;
    };
    return command.add_option("--size", read, usual)->type_name("WxH");
}

void add_view_option(CLI::App& command, wheel::StillView& view, CLI::Option* picture) {
    add_choice<wheel::StillView>(
        command, "--view",
        {{"throw", wheel::StillView::kThrowing},
         {"look-in", wheel::StillView::kLookingIn},
         {"portrait", wheel::StillView::kPortrait},
         {"cutaway", wheel::StillView::kCutaway}},
        view, "what the picture shows: pot and hands, into the pot, the pot alone, its section")
        ->needs(picture);
}

void add_volume_option(CLI::App& command, std::optional<double>& volume) {
    add_number_option(command, "--volume", volume, 0.0, 1.0,
                      "volume of the wheel, 0 to 1; 0 opens no sound device (0.5)");
}

CLI::Option* add_backend_option(CLI::App& command, std::optional<render::BackendChoice>& backend,
                                const std::string& description) {
    return add_choice(
        command, "--backend",
        named({render::BackendChoice::kGpu, render::BackendChoice::kCpu, render::BackendChoice::kAuto},
              render::backend_choice_name),
        backend, description);
}

CLI::Option* add_device_option(CLI::App& command, std::string& word, const std::string& first) {
    const auto known = [first](const std::string& given) -> std::string {
        if (given == first || names_a_device(given)) return {};
        return fmt::format(
            "expected auto, {}, spacemouse, dualsense, joystick, inverse3, /dev/hidrawN or VENDOR:PRODUCT, "
            "found {}",
            first, in_quotes(given));
    };
    return command
        .add_option(
            "--device", word,
            fmt::format(
                "the device that holds the tool: auto (any that is plugged in, now or later), {} alone, "
                "spacemouse, dualsense, joystick, inverse3, /dev/hidrawN or VENDOR:PRODUCT ({})",
                first, word))
        ->type_name("DEVICE")
        ->check(CLI::Validator(known, ""));
}

}  // namespace onggi::app
