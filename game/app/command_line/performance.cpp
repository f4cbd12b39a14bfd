#include "game/app/command_line/performance.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/quote.h"
#include "engine/files/read_file.h"
#include "game/clay/studio/joining.h"
#include "game/tool/gesture.h"

namespace onggi::app {
namespace {

// Enough bytes to recognise a gesture or a session and to refuse anything else.
constexpr std::size_t kStartBytes = tool::kMaxGestureLineBytes + 2;

Result<void> check_brings_its_own(const InputOptions& options) {
    const auto refused = [&](std::string_view option) {
        return bad_input(fmt::format("{}: a session brings its own rate, clay and elements: expected no {}",
                                     shown_path(options.file), option));
    };
    if (options.rate_hz) return refused("--rate");
    if (options.clay) return refused("--clay");
    if (options.element_count) return refused("--elements");
    if (options.clay_mass_g) return refused("--clay-mass");
    if (options.body) return refused("--body");
    if (options.start.on) return refused("--on");
    if (options.wheel) return refused("--wheel");
    if (options.forgiving) return refused("--forgiving");
    return {};
}

Result<Performance> performance_of_session(const InputOptions& options) {
    if (auto own = check_brings_its_own(options); !own) return own.error();
    auto loaded = load_session(options.file);
    if (!loaded) return loaded.error();
    Performance performance;
    performance.start = std::move(loaded->start);
    performance.tick_count = loaded->session.tick_count();
    performance.remark = remark_on_cut(loaded->session, options.file);
    performance.player = std::make_unique<haptic::SessionPlayer>(std::move(loaded->session));
    return performance;
}

Result<Performance> performance_of_gesture(const InputOptions& options) {
    auto text = files::read_file(options.file, tool::kMaxGestureBytes);
    if (!text) return text.error();
    auto gesture = tool::parse_gesture(*text, options.file);
    if (!gesture) return gesture.error();
    auto start = fresh_start(options);
    if (!start) return start.error();
    Performance performance;
    performance.start = std::move(start).value();
    const double rate_hz = performance.start.parameters.rate_hz();
    performance.tick_count = gesture->tick_count(rate_hz);
    performance.player = std::make_unique<haptic::GesturePlayer>(std::move(gesture).value(), rate_hz);
    return performance;
}

}  // namespace

Result<haptic::Start> fresh_start(const InputOptions& options) {
    haptic::Start start;
    start.parameters.set_rate_hz(options.rate_hz.value_or(start.parameters.rate_hz()));
    if (options.clay == "paper") {
        const auto refused = [](std::string_view option) {
            return bad_input(fmt::format("{}: expected the studio clay, found --clay paper", option));
        };
        if (options.clay_mass_g) return refused("--clay-mass");
        if (options.wheel) return refused("--wheel");
        if (options.forgiving) return refused("--forgiving");
        if (options.body) return refused("--body");
        if (options.start.on) return refused("--on");
        const clay::PaperLump usual;
        start.state = haptic::HapticState(
            clay::PaperClay({.element_count = options.element_count.value_or(usual.element_count)}));
        return start;
    }
    if (options.wheel == "kick") start.parameters.studio.wheel = clay::studio::kick_wheel();
    start.parameters.studio.forgiving = options.forgiving;
    if (options.start.on && (options.clay_mass_g || options.body || options.element_count))
        return bad_input("--on: expected no --clay-mass, --body or --elements: the pot brings its own");
    auto pot = start_pot(options.start);
    if (!pot) return pot.error();
    if (*pot) {
        start.state = haptic::HapticState(std::move(**pot));
        return start;
    }
    clay::StudioLump lump;
    lump.mass_g = options.clay_mass_g.value_or(lump.mass_g);
    lump.body = options.body.value_or(lump.body);
    lump.rings = std::clamp(options.element_count.value_or(lump.rings), clay::kFewestRings, clay::kMostRings);
    start.state = haptic::HapticState(clay::StudioClay(lump));
    return start;
}

Result<Performance> load_performance(const InputOptions& options) {
    const auto start = files::read_file_start(options.file, kStartBytes);
    if (!start) return start.error();
    if (record::opens_a_session(*start)) return performance_of_session(options);
    // Refuses a large file of another kind by its first line, without reading the rest.
    if (auto gesture = tool::check_gesture_start(*start, options.file); !gesture) return gesture.error();
    return performance_of_gesture(options);
}

namespace {

// Returns the pot at the end of a session, put back on the wheel.
Result<clay::StudioClay> pot_left_by(const std::string& file) {
    auto loaded = load_session(file);
    if (!loaded) return loaded.error();
    haptic::HapticState& state = loaded->start.state;
    if (state.studio() == nullptr) {
        return bad_input(fmt::format("{}: expected a session of the studio clay, found one of the paper's",
                                     shown_path(file)));
    }
    record::SessionCursor recorded(loaded->session);
    for (std::uint64_t tick = 0; tick < loaded->session.tick_count(); ++tick)
        haptic::tick(state, recorded.at(tick), loaded->start.parameters);
    clay::StudioClay pot = std::move(*state.studio());
    pot.put_back();
    return pot;
}

}  // namespace

Result<std::optional<clay::StudioClay>> start_pot(const StartPot& options) {
    if (!options.on) return std::optional<clay::StudioClay>();
    auto lower = pot_left_by(*options.on);
    if (!lower) return lower.error();
    if (!options.joined) return std::optional(std::move(lower).value());
    auto upper = pot_left_by(*options.joined);
    if (!upper) return upper.error();
    auto pot = clay::join_pots(*lower, *upper, {.bore_mm = options.bore_mm.value_or(0.0)});
    if (!pot) return pot.error();
    return std::optional(std::move(pot).value());
}

}  // namespace onggi::app
