#include "game/app/kiosk/health/house_status.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <utility>

#include "engine/core/list_folder.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/system/start_log.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNoteBytes = std::size_t{64} << 10U;

// Who may not look is told so, instead of finding an empty gallery.
Result<void> may_look_into(const fs::path& folder) {
    if (::access(folder.c_str(), R_OK | X_OK) == 0 || errno == ENOENT) return {};
    const int error = errno;
    return system_lacks(fmt::format(
        "{}: expected to look into it, found: {}; as root, or a user of the group that owns it, one can",
        shown_path(folder.native()), std::strerror(error)));
}

std::vector<HouseStatus::Fault> newest_faults(const fs::path& folder) {
    std::vector<HouseStatus::Fault> faults;
    for (const fs::path& file : list_folder(folder).entries) {
        if (file.extension() != ".onggi") continue;
        std::error_code gone;
        const auto written = fs::last_write_time(file, gone);
        if (gone) continue;
        const auto at = std::chrono::file_clock::to_sys(written).time_since_epoch();
        faults.push_back({file, std::chrono::duration_cast<std::chrono::seconds>(at).count()});
    }
    std::sort(faults.begin(), faults.end(), [](const auto& a, const auto& b) {
        return std::pair(a.at_s, a.session) > std::pair(b.at_s, b.session);
    });
    if (faults.size() > HouseStatus::kMostFaults) faults.resize(HouseStatus::kMostFaults);
    return faults;
}

HouseStatus::State state_of(const HouseStatus& status, const StartLog& starts) {
    using State = HouseStatus::State;
    if (!status.note) return State::kNeverStarted;
    if (status.note->has_ended) return starts.is_running ? State::kFell : State::kEnded;
    // A clock that was put back makes heartbeats of the future, until the next one.
    const bool is_fresh =
        status.age_s() <= HouseStatus::kSilentAfterS && status.age_s() >= -HouseStatus::kSilentAfterS;
    return is_fresh ? State::kRunning : State::kSilent;
}

std::vector<std::string> complaints_of(const HouseStatus& status, double least_free_mb) {
    using State = HouseStatus::State;
    std::vector<std::string> complaints;
    switch (status.state) {
        case State::kNeverStarted:
            complaints.emplace_back("it has never been started");
            break;
        case State::kSilent:
            complaints.push_back(fmt::format("no heartbeat for {} s", status.age_s()));
            break;
        case State::kEnded:
            complaints.emplace_back("it was ended");
            break;
        case State::kFell:
            complaints.emplace_back("it ended with an error, or died");
            break;
        case State::kRunning: {
            const StatusNote& note = *status.note;
            if (!note.picture_moves) complaints.emplace_back("the picture stands still");
            if (!note.hand_turns) complaints.emplace_back("the hand's loop stands still");
            if (!note.pulse.fault.empty()) complaints.push_back("no force: " + note.pulse.fault);
            if (note.pulse.is_safe_mode) complaints.emplace_back("safe mode: no devices, a plain picture");
            break;
        }
    }
    if (status.free_mb < least_free_mb) {
        complaints.push_back(
            fmt::format("no pot is kept: {:.0f} MB of the disk are free, {:.0f} are left alone",
                        status.free_mb, least_free_mb));
    }
    return complaints;
}

}  // namespace

fs::path status_file(const fs::path& gallery) {
    return state_folder(gallery) / "status.json";
}

Result<std::optional<StatusNote>> read_status_note_of(const fs::path& gallery) {
    const fs::path file = status_file(gallery);
    std::error_code error;
    if (!fs::exists(file, error)) return std::optional<StatusNote>();
    const auto text = files::read_file(file, kMostNoteBytes);
    if (!text) return text.error();
    auto note = read_status_note(*text, file.string());
    if (!note) return note.error();
    return std::optional(std::move(*note));
}

const char* name_of(HouseStatus::State state) {
    using State = HouseStatus::State;
    switch (state) {
        case State::kNeverStarted:
            return "never started";
        case State::kRunning:
            return "running";
        case State::kSilent:
            return "silent";
        case State::kEnded:
            return "ended";
        case State::kFell:
            return "fell";
    }
    return "";
}

Result<HouseStatus> look_at_house(const kiosk::Config& config, std::int64_t now_s) {
    const fs::path gallery = config.gallery.folder;
    const fs::path statistics = statistics_folder(config);
    for (const fs::path& folder : {gallery, state_folder(gallery), statistics, faults_folder(gallery)})
        if (auto may = may_look_into(folder); !may) return may.error();

    HouseStatus status{.name = config.staff.name, .now_s = now_s, .day = day_of(now_s)};
    auto note = read_status_note_of(gallery);
    if (!note) return note.error();
    status.note = std::move(*note);
    StartLog starts;
    if (auto log = read_start_log_of(state_folder(gallery))) {
        starts = std::move(*log);
        status.falls = falls_lately(starts, now_s);
    }
    status.state = state_of(status, starts);
    status.use = use_of(statistics, status.day);
    status.pots = kept_pots(gallery).size();
    status.free_mb = free_mb_at(gallery);
    status.faults = newest_faults(faults_folder(gallery));
    status.why_not_well = complaints_of(status, config.gallery.least_free_mb);
    return status;
}

}  // namespace onggi::app
