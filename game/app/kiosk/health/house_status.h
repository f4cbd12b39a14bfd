// How a wheel fares, by what lies on its disk alone: for the house's monitoring, which asks while the wheel
// runs, when it is down, and as another user. Any thread but the haptic one and the frame's; reads files and
// changes none.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/health/kiosk_status.h"
#include "game/kiosk/config.h"

namespace onggi::app {

struct HouseStatus {
    enum class State {
        kNeverStarted,  // no heartbeat lies there
        kRunning,
        kSilent,  // no heartbeat for kSilentAfterS: it hangs, or was cut off with its supervisor
        kEnded,   // as was meant
        kFell,    // it ended with an error, or died and its supervisor said so
    };
    struct Fault {
        std::filesystem::path session;  // which `onggi replay` works out again
        std::int64_t at_s = 0;
    };
    static constexpr std::int64_t kSilentAfterS = 150;  // two heartbeats and a half
    static constexpr std::size_t kMostFaults = 5;

    std::string name{};  // of the unit
    State state = State::kNeverStarted;
    std::vector<std::string> why_not_well{};  // empty: well
    std::optional<StatusNote> note{};         // the last heartbeat
    std::int64_t now_s = 0;
    int falls = 0;  // of the program, within ten minutes
    std::string day{};
    UseOfDay use{};
    std::size_t pots = 0;  // in the gallery
    double free_mb = 0.0;
    std::vector<Fault> faults{};  // newest first: the safety chain's and the program's crashes

    [[nodiscard]] bool is_well() const { return why_not_well.empty(); }
    [[nodiscard]] std::int64_t age_s() const { return note ? now_s - note->at_s : 0; }
};

[[nodiscard]] const char* name_of(HouseStatus::State state);

// Of the wheel with these settings, at that time. System lacks: what lies there may not be read.
[[nodiscard]] Result<HouseStatus> look_at_house(const kiosk::Config& config, std::int64_t now_s);

// A line a fact; one JSON object; and Prometheus' text format, version 0.0.4, for the textfile collector of
// node_exporter.
[[nodiscard]] std::string lines_of(const HouseStatus& status);
[[nodiscard]] std::string json_of(const HouseStatus& status);
[[nodiscard]] std::string metrics_of(const HouseStatus& status);

// Where faults and crashes are kept as sessions.
[[nodiscard]] inline std::filesystem::path faults_folder(const std::filesystem::path& gallery) {
    return gallery / "faults";
}
[[nodiscard]] std::filesystem::path status_file(const std::filesystem::path& gallery);
// The heartbeat that lies there; nothing: none does. Errors: of reading it.
[[nodiscard]] Result<std::optional<StatusNote>> read_status_note_of(const std::filesystem::path& gallery);

}  // namespace onggi::app
