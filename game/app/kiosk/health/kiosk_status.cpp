#include "game/app/kiosk/health/kiosk_status.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/quote.h"
#include "game/app/system/or_null.h"

namespace onggi::app {
namespace {

using nlohmann::json;

// The end of the year 9999: what can still be said as a date.
constexpr std::int64_t kLastS = 253'402'300'799;

std::optional<double> number_or_none(const json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

StatusNote note_of(const json& all) {
    const json& pulse = all.at("pulse");
    return {.at_s = all.at("at_s").get<std::int64_t>(),
            .has_ended = all.at("has_ended").get<bool>(),
            .running_s = all.at("running_s").get<double>(),
            .picture_moves = all.at("picture_moves").get<bool>(),
            .hand_turns = all.at("hand_turns").get<bool>(),
            .version = all.at("version").get<std::string>(),
            .pulse = {.screen = pulse.at("screen").get<std::string>(),
                      .is_closed = pulse.at("is_closed").get<bool>(),
                      .fault = pulse.at("fault").get<std::string>(),
                      .faults = pulse.at("faults").get<std::uint64_t>(),
                      .asked_hz = pulse.at("asked_hz").get<double>(),
                      .achieved_hz = pulse.at("achieved_hz").get<double>(),
                      .skipped_periods = pulse.at("skipped_periods").get<std::uint64_t>(),
                      .late_periods = pulse.at("late_periods").get<std::uint64_t>(),
                      .frame_ms = pulse.at("frame_ms").get<double>(),
                      .worst_frame_ms = pulse.at("worst_frame_ms").get<double>(),
                      .frames_shown = pulse.at("frames_shown").get<std::uint64_t>(),
                      .haptic_ticks = pulse.at("haptic_ticks").get<std::uint64_t>(),
                      .is_safe_mode = pulse.at("is_safe_mode").get<bool>()},
            .celsius = number_or_none(all.at("celsius")),
            .resident_mb = number_or_none(all.at("resident_mb"))};
}

}  // namespace

std::string text_of(const StatusNote& note) {
    const KioskPulse& pulse = note.pulse;
    const json all{{"format", StatusNote::kFormat},
                   {"at_s", note.at_s},
                   {"has_ended", note.has_ended},
                   {"running_s", note.running_s},
                   {"picture_moves", note.picture_moves},
                   {"hand_turns", note.hand_turns},
                   {"version", note.version},
                   {"celsius", or_null<json>(note.celsius)},
                   {"resident_mb", or_null<json>(note.resident_mb)},
                   {"pulse",
                    {{"screen", pulse.screen},
                     {"is_closed", pulse.is_closed},
                     {"fault", pulse.fault},
                     {"faults", pulse.faults},
                     {"asked_hz", pulse.asked_hz},
                     {"achieved_hz", pulse.achieved_hz},
                     {"skipped_periods", pulse.skipped_periods},
                     {"late_periods", pulse.late_periods},
                     {"frame_ms", pulse.frame_ms},
                     {"worst_frame_ms", pulse.worst_frame_ms},
                     {"frames_shown", pulse.frames_shown},
                     {"haptic_ticks", pulse.haptic_ticks},
                     {"is_safe_mode", pulse.is_safe_mode}}}};
    return all.dump() + "\n";
}

Result<StatusNote> read_status_note(std::string_view text, const std::string& file) {
    try {
        const json all = json::parse(text);
        const int format = all.at("format").get<int>();
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
