// The measured use of a kiosk: local CSV files, a line a visit, a line whenever somebody interrupts the
// attract screen, a line a start of the program, a line a minute in which phones were busy. Nothing says who
// it was: a day, an hour, no minute, no number, no shape. Any one thread at a time but the haptic one;
// blocks.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "engine/core/result.h"
#include "game/app/system/wall_clock.h"
#include "game/kiosk/state.h"

namespace onggi::app {

struct VisitNote {
    int dwell_s = 0;
    kiosk::Screen last = kiosk::Screen::kAttract;  // where it ended
    bool thrown = false;                           // clay was put on for it
    int kept = 0;                                  // pots of it that were kept: its completions
};

// Appends to visits.csv in the folder, with a line of names first where the file is new, under the local day
// and hour of now_s. System lacks: no permission or no room.
Result<void> note_visit(const std::filesystem::path& folder, const VisitNote& note,
                        std::int64_t now_s = wall_clock_s());
// The same to attract_breaks.csv: the attract screen was interrupted.
Result<void> note_attract_break(const std::filesystem::path& folder, std::int64_t now_s = wall_clock_s());
// And to starts.csv: the program has started.
Result<void> note_start(const std::filesystem::path& folder, std::int64_t now_s = wall_clock_s());

// What phones were shown and took: counts, nothing of whom.
struct PhoneNote {
    int codes = 0;  // shown on the screen
    int pages = 0;  // opened
    int models = 0;
    int prints = 0;
    int films = 0;

    friend bool operator==(const PhoneNote&, const PhoneNote&) = default;
};
// To phones.csv, which nobody else writes: another thread may note visits meanwhile.
Result<void> note_phones(const std::filesystem::path& folder, const PhoneNote& note,
                         std::int64_t now_s = wall_clock_s());

struct UseOfHour {
    int breaks = 0;  // of the attract screen
    int visits = 0;  // that ended in this hour
    int thrown = 0;
    int kept = 0;      // pots, of which a visit may keep several
    long dwell_s = 0;  // of all of them

    UseOfHour& operator+=(const UseOfHour& other);
    friend bool operator==(const UseOfHour&, const UseOfHour&) = default;
};

struct UseOfDay {
    std::array<UseOfHour, 24> hours{};
    int starts = 0;

    [[nodiscard]] UseOfHour total() const;
    friend bool operator==(const UseOfDay&, const UseOfDay&) = default;
};

// What the files say of a day, "2026-11-21". Files that are not there say nothing; lines that are not as
// written above are left out.
[[nodiscard]] UseOfDay use_of(const std::filesystem::path& folder, const std::string& day);

}  // namespace onggi::app
