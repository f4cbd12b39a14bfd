#include "game/app/replay/stored_session.h"

#include <fmt/format.h>

#include <utility>

#include "engine/core/quote.h"
#include "engine/files/read_file.h"
#include "game/app/replay/session_marks.h"

namespace onggi::app {
namespace {

std::string clay_of(const record::SessionHeader& header) {
    return fmt::format("{} clay of {} elements and {} sectors",
                       header.tool_detail == record::ToolDetail::kPlain ? "paper" : "studio",
                       header.element_count, header.sector_count);
}

}  // namespace

Result<LoadedSession> load_session(const std::string& file) {
    const auto first_bytes = files::read_file_start(file, record::kMagic.size());
    if (!first_bytes) return first_bytes.error();
    if (!record::opens_a_session(*first_bytes)) {
        // The start suffices for the parser to report the error.
        return record::parse_session(*first_bytes, file).error();
    }
    auto bytes = files::read_file(file, record::kMaxSessionBytes);
    if (!bytes) return bytes.error();
    auto session = record::parse_session(std::move(bytes).value(), file);
    if (!session) return session.error();
    const record::SessionHeader& header = session->header();
    auto start = haptic::start_from_bytes(session->start_state(), header.rate_hz);
    if (!start) {
        return Error{start.error().kind, fmt::format("{}: {}", shown_path(file), start.error().message)};
    }
    auto decoration = decoration_in(*session, file);
    if (!decoration) return decoration.error();
    record::SessionHeader of_start = haptic::session_header(*start);
    of_start.start_state_hash = header.start_state_hash;  // a replay compares it
    if (of_start != header) {
        return bad_input(fmt::format("{}: expected {} as the header says, found {} in the start state",
                                     shown_path(file), clay_of(header), clay_of(of_start)));
    }
    return LoadedSession{std::move(session).value(), std::move(start).value(), std::move(decoration).value()};
}

std::optional<std::string> remark_on_cut(const record::Session& session, const std::string& file) {
    if (session.is_complete()) return std::nullopt;
    return fmt::format(
        "{}: cut short: expected the end marker, found the end of the file at byte {}; plays {} "
        "ticks, up to the last whole block at byte {}",
        shown_path(file), session.file_bytes(), session.tick_count(), session.usable_bytes());
}

}  // namespace onggi::app
