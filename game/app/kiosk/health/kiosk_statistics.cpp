#include "game/app/kiosk/health/kiosk_statistics.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/cells.h"
#include "engine/core/number_in.h"
#include "engine/files/append_line.h"
#include "game/visit/flow/step.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVisits = "visits.csv";
constexpr const char* kBreaks = "attract_breaks.csv";
constexpr const char* kStarts = "starts.csv";
constexpr const char* kPhones = "phones.csv";
constexpr int kMostKept = 1000;  // per visit; this program never writes more

// Appends a line of the day, the hour and `rest`.
Result<void> append(const fs::path& folder, const char* name, std::string_view header, std::string_view rest,
                    std::int64_t now_s) {
    std::error_code error;
    fs::create_directories(folder, error);
    return files::append_line(
        folder / name, header,
        fmt::format("{:%Y-%m-%d,%H}{}", fmt::localtime(static_cast<std::time_t>(now_s)), rest));
}

std::optional<int> number_of(std::string_view cell) {
    const auto number = number_in<int>(cell);
    return number && *number >= 0 ? number : std::nullopt;
}

// Calls take(hour, cells) for every line of that day with as many cells as the file's first line or as
// `cell_count`, the present number.
template <typename Take>
void for_each_line(const fs::path& file, const std::string& day, std::size_t cell_count, const Take& take) {
    std::ifstream stream(file);
    std::string line;
    std::size_t first_count = 0;
    while (std::getline(stream, line)) {
        if (first_count == 0) first_count = cells_of(line, ',').size();
        if (!line.starts_with(day)) continue;
        const auto cells = cells_of(line, ',');
        const bool fits = cells.size() == cell_count || cells.size() == first_count;
        if (!fits || cells.size() < 2 || cells[0] != day) continue;
        const auto hour = number_of(cells[1]);
        if (hour && *hour < 24) take(static_cast<std::size_t>(*hour), cells);
    }
}

}  // namespace

Result<void> note_visit(const fs::path& folder, const VisitNote& note, std::int64_t now_s) {
    return append(folder, kVisits, "day,hour,dwell_s,ended_on,thrown,kept",
                  fmt::format(",{},{},{},{}", note.dwell_s, visit::step_of(note.last).name,
                              note.thrown ? 1 : 0, note.kept),
                  now_s);
}

Result<void> note_attract_break(const fs::path& folder, std::int64_t now_s) {
    return append(folder, kBreaks, "day,hour", "", now_s);
}

Result<void> note_start(const fs::path& folder, std::int64_t now_s) {
    return append(folder, kStarts, "day,hour", "", now_s);
}

Result<void> note_phones(const fs::path& folder, const PhoneNote& note, std::int64_t now_s) {
    return append(
        folder, kPhones, "day,hour,codes,pages,models,prints,films",
        fmt::format(",{},{},{},{},{}", note.codes, note.pages, note.models, note.prints, note.films), now_s);
}

UseOfHour& UseOfHour::operator+=(const UseOfHour& other) {
    breaks += other.breaks;
    visits += other.visits;
    thrown += other.thrown;
    kept += other.kept;
    dwell_s += other.dwell_s;
    return *this;
}

UseOfHour UseOfDay::total() const {
    UseOfHour all;
    for (const UseOfHour& hour : hours)
        all += hour;
    return all;
}

UseOfDay use_of(const fs::path& folder, const std::string& day) {
    UseOfDay use;
    for_each_line(folder / kBreaks, day, 2, [&](std::size_t hour, const auto&) { ++use.hours[hour].breaks; });
    for_each_line(folder / kStarts, day, 2, [&](std::size_t, const auto&) { ++use.starts; });
    // Old files have no `thrown`; visits in them that kept a pot count as thrown.
    const auto take_visit = [&](std::size_t hour, const auto& cells) {
        if (cells.size() < 5) return;
        const auto dwell_s = number_of(cells[2]);
        const auto kept = number_of(cells.back());
        const auto thrown = number_of(cells[4]);
        if (!dwell_s || !thrown || !kept || *kept > kMostKept) return;
        UseOfHour& there = use.hours[hour];
        ++there.visits;
        there.thrown += *thrown > 0 ? 1 : 0;
        there.kept += *kept;
        there.dwell_s += *dwell_s;
    };
    for_each_line(folder / kVisits, day, 6, take_visit);
    return use;
}

}  // namespace onggi::app
