// The usage statistics of a kiosk: local CSV files with a line per visit, per interruption of the attract
// screen, per start of the program, and per minute with phone activity. They are anonymous: day and hour, but
// no minute, no visitor number and no pot's shape. Any one thread at a time but the haptic one; blocks.
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
    kiosk::Screen last = kiosk::Screen::kAttract;  // the last screen
    bool thrown = false;                           // clay was put on the wheel
    int kept = 0;                                  // number of kept pots
};

// Appends a line with the local day and hour of now_s to visits.csv in the folder, after a line of names in a
// new file. System lacks: no permission or no room.
Result<void> note_visit(const std::filesystem::path& folder, const VisitNote& note,
                        std::int64_t now_s = wall_clock_s());
// The same for attract_breaks.csv: an interruption of the attract screen.
Result<void> note_attract_break(const std::filesystem::path& folder, std::int64_t now_s = wall_clock_s());
// The same for starts.csv: a start of the program.
Result<void> note_start(const std::filesystem::path& folder, std::int64_t now_s = wall_clock_s());

// Counts of the codes and pages for phones, without personal data.
struct PhoneNote {
    int codes = 0;  // number shown on the screen
    int pages = 0;  // number opened
    int models = 0;
    int prints = 0;
    int films = 0;

    friend bool operator==(const PhoneNote&, const PhoneNote&) = default;
};
// The same for phones.csv; another thread may write the other files meanwhile.
Result<void> note_phones(const std::filesystem::path& folder, const PhoneNote& note,
                         std::int64_t now_s = wall_clock_s());

struct UseOfHour {
    int breaks = 0;  // interruptions of the attract screen
    int visits = 0;  // number that ended in this hour
    int thrown = 0;
    int kept = 0;      // number of kept pots; several per visit are possible
    long dwell_s = 0;  // total of all visits

    UseOfHour& operator+=(const UseOfHour& other);
    friend bool operator==(const UseOfHour&, const UseOfHour&) = default;
};

struct UseOfDay {
    std::array<UseOfHour, 24> hours{};
    int starts = 0;

    [[nodiscard]] UseOfHour total() const;
    friend bool operator==(const UseOfDay&, const UseOfDay&) = default;
};

// The statistics of a day, "2026-11-21". Missing files count as empty; invalid lines are skipped.
[[nodiscard]] UseOfDay use_of(const std::filesystem::path& folder, const std::string& day);

}  // namespace onggi::app
