#include "game/app/performance.h"

#include <fmt/format.h>

#include <utility>

#include "engine/core/quote.h"
#include "engine/files/read_file.h"
#include "engine/haptics/gesture.h"

namespace onggi::app {
namespace {

// Enough of a file to tell its kind, and to refuse one that is neither.
constexpr std::size_t kStartBytes = haptics::kMaxGestureLineBytes + 2;

Result<void> check_brings_its_own(const InputOptions& options) {
    const auto refused = [&](std::string_view option) {
        return bad_input(fmt::format("{}: a session brings its own rate, clay and elements: expected no {}",
                                     shown_path(options.file), option));
    };
    if (options.rate_hz) return refused("--rate");
    if (options.clay) return refused("--clay");
    if (options.element_count) return refused("--elements");
    return {};
}

Result<LoadedSession> session_in_file(const std::string& file) {
    auto bytes = files::read_file(file, record::kMaxSessionBytes);
    if (!bytes) return bytes.error();
    auto session = record::parse_session(std::move(bytes).value(), file);
    if (!session) return session.error();
    const record::SessionHeader& header = session->header();
    if (header.clay_model != record::ClayModel::kPaper || header.sector_count != 1) {
        return bad_input(fmt::format("{}: expected a session of the paper clay, found one of another clay",
                                     shown_path(file)));
    }
    auto start = haptic::start_from_bytes(session->start_state(), header.rate_hz);
    if (!start) {
        return Error{start.error().kind, fmt::format("{}: {}", shown_path(file), start.error().message)};
    }
    const auto elements = static_cast<std::uint32_t>(start->state.clay.element_count());
    if (elements != header.element_count) {
        return bad_input(
            fmt::format("{}: expected {} elements as the header says, found {} in the start state",
                        shown_path(file), header.element_count, elements));
    }
    return LoadedSession{std::move(session).value(), std::move(start).value()};
}

Result<Performance> performance_of_session(const InputOptions& options) {
    if (auto own = check_brings_its_own(options); !own) return own.error();
    auto loaded = session_in_file(options.file);
    if (!loaded) return loaded.error();
    Performance performance;
    performance.start = std::move(loaded->start);
    performance.tick_count = loaded->session.tick_count();
    performance.remark = remark_on_cut(loaded->session, options.file);
    performance.hand = std::make_unique<record::SessionPlayer>(std::move(loaded->session));
    return performance;
}

Result<Performance> performance_of_gesture(const InputOptions& options) {
    auto text = files::read_file(options.file, haptics::kMaxGestureBytes);
    if (!text) return text.error();
    auto gesture = haptics::parse_gesture(*text, options.file);
    if (!gesture) return gesture.error();
    const clay::PaperLump usual;
    Performance performance;
    performance.start.parameters.clay.rate_hz =
        options.rate_hz.value_or(performance.start.parameters.clay.rate_hz);
    performance.start.state = haptic::HapticState(
        clay::PaperClay({.element_count = options.element_count.value_or(usual.element_count)}));
    const double rate_hz = performance.start.parameters.clay.rate_hz;
    performance.tick_count = gesture->tick_count(rate_hz);
    performance.hand = std::make_unique<haptics::GesturePlayer>(std::move(gesture).value(), rate_hz);
    return performance;
}

}  // namespace

Result<Performance> load_performance(const InputOptions& options) {
    const auto start = files::read_file_start(options.file, kStartBytes);
    if (!start) return start.error();
    if (record::opens_a_session(*start)) return performance_of_session(options);
    // A gigabyte of something else is refused by its first line, unread.
    if (auto gesture = haptics::check_gesture_start(*start, options.file); !gesture) return gesture.error();
    return performance_of_gesture(options);
}

Result<LoadedSession> load_session(const std::string& file) {
    const auto start = files::read_file_start(file, record::kMagic.size());
    if (!start) return start.error();
    if (!record::opens_a_session(*start)) {
        // The parser says it in its own words, and needs no more of the file for it.
        return record::parse_session(*start, file).error();
    }
    return session_in_file(file);
}

std::optional<std::string> remark_on_cut(const record::Session& session, const std::string& file) {
    if (session.is_complete()) return std::nullopt;
    return fmt::format(
        "{}: cut short: expected the end marker, found the end of the file at byte {}; plays {} "
        "ticks, up to the last whole block at byte {}",
        shown_path(file), session.file_bytes(), session.tick_count(), session.usable_bytes());
}

record::SessionHeader session_header(const haptic::Start& start) {
    return {.rate_hz = start.parameters.clay.rate_hz,
            .element_count = static_cast<std::uint32_t>(start.state.clay.element_count()),
            .sector_count = 1,
            .clay_model = record::ClayModel::kPaper,
            .start_state_hash = start.state.hash()};
}

}  // namespace onggi::app
