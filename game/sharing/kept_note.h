// The note in a shared pot's folder: creation and expiry time. Three lines of plain text, format 1
// (game/app/FORMATS.md). Any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace onggi::sharing {

struct KeptNote {
    std::int64_t made_s = 0;     // seconds since 1970, UTC
    std::int64_t expires_s = 0;  // the pot is gone from this time on
    std::string gallery_name;    // of the pot in the kiosk's gallery; may be empty
};

constexpr std::size_t kMostNoteBytes = 512;

// A machine without a battery starts in the past, until the network sets its clock. Before 2026 it is not set
// yet.
constexpr std::int64_t kClockIsSetS = 1'767'225'600;

// Whether the pot has expired. Also true for a pot shared while the clock was far ahead: no pot stays longer
// than the largest setting (a week) plus an hour. This second rule waits until the machine's clock is set.
// False for a pot that was shared before the clock was set, until redated() gives it the time that it was
// promised.
[[nodiscard]] bool is_over(const KeptNote& note, std::int64_t now_s);
// The note of a pot that was shared before the clock was set, with the same stay from now on. Empty for every
// other note, and for a longer stay than any pot gets.
[[nodiscard]] std::optional<KeptNote> redated(const KeptNote& note, std::int64_t now_s);

[[nodiscard]] std::string written(const KeptNote& note);
// Empty for text of another form.
[[nodiscard]] std::optional<KeptNote> read_note(std::string_view text);

}  // namespace onggi::sharing
