// The note in a shared pot's folder: when it came, when it goes. Three lines of plain text, format 1
// (game/app/FORMATS.md). Any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace onggi::sharing {

struct KeptNote {
    std::int64_t made_s = 0;     // seconds since 1970, UTC
    std::int64_t expires_s = 0;  // gone from then on
    std::string gallery_name;    // of the pot in the kiosk's gallery; may be empty
};

constexpr std::size_t kMostNoteBytes = 512;

// Whether the pot's time is over. Also where it was shared by a clock that was far ahead: none stays longer
// than the settings can say (a week) and an hour, except while the machine's own clock plainly stands before
// today, as without a battery it does until the network tells it the time.
[[nodiscard]] bool is_over(const KeptNote& note, std::int64_t now_s);

[[nodiscard]] std::string written(const KeptNote& note);
// None for anything that written() does not give.
[[nodiscard]] std::optional<KeptNote> read_note(std::string_view text);

}  // namespace onggi::sharing
