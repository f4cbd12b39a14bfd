#include "game/app/kiosk/health/kiosk_status.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/quote.h"
#include "game/app/system/or_null.h"
#include "game/app/system/whole_number.h"

namespace onggi::app {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(KioskPulse, screen, is_closed, fault, faults, asked_hz, achieved_hz,
                                   skipped_periods, late_periods, frame_ms, worst_frame_ms, frames_shown,
                                   haptic_ticks, is_safe_mode)

namespace {

using nlohmann::json;

// The end of the year 9999, the last date that can be formatted.
constexpr std::int64_t kLastS = 253'402'300'799;

std::optional<double> number_or_none(const json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

StatusNote note_of(const json& all) {
    const json& pulse = all.at("pulse");
    for (const char* key : {"faults", "skipped_periods", "late_periods", "frames_shown", "haptic_ticks"})
        static_cast<void>(whole_number<std::uint64_t>(pulse.at(key)));
    return {.at_s = whole_number<std::int64_t>(all.at("at_s")),
            .has_ended = all.at("has_ended").get<bool>(),
            .running_s = all.at("running_s").get<double>(),
            .picture_moves = all.at("picture_moves").get<bool>(),
            .hand_turns = all.at("hand_turns").get<bool>(),
            .version = all.at("version").get<std::string>(),
            .pulse = pulse.get<KioskPulse>(),
            .celsius = number_or_none(all.at("celsius")),
            .resident_mb = number_or_none(all.at("resident_mb"))};
}

}  // namespace

std::string text_of(const StatusNote& note) {
    const json all{{"format", StatusNote::kFormat},
                   {"at_s", note.at_s},
                   {"has_ended", note.has_ended},
                   {"running_s", note.running_s},
                   {"picture_moves", note.picture_moves},
                   {"hand_turns", note.hand_turns},
                   {"version", note.version},
                   {"celsius", or_null<json>(note.celsius)},
                   {"resident_mb", or_null<json>(note.resident_mb)},
                   {"pulse", note.pulse}};
    return all.dump() + "\n";
}

Result<StatusNote> read_status_note(std::string_view text, const std::string& file) {
    try {
        const json all = json::parse(text);
        const int format = whole_number<int>(all.at("format"));
        if (format != StatusNote::kFormat) {
            return bad_input(fmt::format("{}: expected a status of format {}, found {}", shown_path(file),
                                         StatusNote::kFormat, format));
        }
        StatusNote note = note_of(all);
        if (note.at_s < 0 || note.at_s > kLastS) {
            return bad_input(fmt::format("{}: expected seconds since 1970 for at_s, found {}",
                                         shown_path(file), note.at_s));
        }
        return note;
    } catch (const json::exception& error) {
        return bad_input(
            fmt::format("{}: expected a kiosk's status, found: {}", shown_path(file), error.what()));
    }
}

}  // namespace onggi::app
