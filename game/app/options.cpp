#include "game/app/options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "engine/core/quote.h"
#include "engine/haptics/gesture.h"
#include "game/clay/paper_clay.h"

namespace onggi::app {
namespace {

// The sides a picture may have: below, nothing can be seen; above, no device promises a target.
constexpr int kMinSide = 16;
constexpr int kMaxSide = 8192;

template <typename T>
std::optional<T> number_in(std::string_view text) {
    T number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

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

}  // namespace

CLI::Option* add_number_option(CLI::App& command, const std::string& name, std::optional<double>& number,
                               double least, double most, const std::string& description) {
    return add_bounded(command, name, number, least, most, "NUMBER", description);
}

void add_input_file(CLI::App& command, InputOptions& options) {
    command.add_option("file", options.file, "a gesture (.csv) or a recorded session (.onggi)")
        ->type_name("GESTURE.csv|SESSION.onggi")
        ->required();
    command.footer(
        "A gesture is a table with the header line\n"
        "  t_s,x_mm,y_mm,z_mm,button,tool_radius_mm\n"
        "and rows with t_s rising from 0 to at most 3600. Position (wheel frame, y up from the wheel head, "
        "within\n"
        "+-1000) is linear between rows; button (0 the wheel stands, 1 it turns) and tool radius (2 to 40) "
        "hold from\n"
        "their row on. More columns may follow to the right.");
}

void add_rate_option(CLI::App& command, InputOptions& options) {
    add_bounded(command, "--rate", options.rate_hz, haptics::kMinRateHz, haptics::kMaxRateHz, "HZ",
                "ticks a second, 100 to 10000, for a gesture (1000)");
}

void add_clay_options(CLI::App& command, InputOptions& options) {
    const auto known = [](const std::string& name) {
        return name == "paper"
                   ? std::string{}
                   : fmt::format("expected one of the clays there are (paper), found {}", in_quotes(name));
    };
    command.add_option("--clay", options.clay, "the clay's model, for a gesture: paper")
        ->type_name("NAME")
        ->check(CLI::Validator(known, ""));
    add_bounded(command, "--elements", options.element_count, clay::kMinElements, clay::kMaxElements, "N",
                "elements of the clay, 100 to 200000, for a gesture (2000)");
}

CLI::Option* add_size_option(CLI::App& command, PictureSize& size) {
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
    return command.add_option("--size", read, "the picture's size in pixels (1280x720)")->type_name("WxH");
}

}  // namespace onggi::app
