#include "game/app/kiosk_statistics.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <fstream>

namespace onggi::app {

Result<void> note_visit(const std::filesystem::path& folder, const VisitNote& note) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::filesystem::path file = folder / "visits.csv";
    const bool is_new = !std::filesystem::exists(file, error);
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::ofstream stream(file, std::ios::app);
    if (is_new) stream << "day,hour,dwell_s,ended_on,kept\n";
    stream << fmt::format("{:%Y-%m-%d,%H},{},{},{}\n", fmt::localtime(now), note.dwell_s,
                          kiosk::name_of(note.last), note.kept ? 1 : 0);
    stream.flush();
    if (!stream)
        return system_lacks(
            fmt::format("{}: expected a file to append a visit to, found none", file.string()));
    return {};
}

}  // namespace onggi::app
