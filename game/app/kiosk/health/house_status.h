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
        kFell,    // it ended with an error or crashed and its supervisor said so
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

// Writes what the house's monitoring reads: the heartbeat beside the visit in progress, and metrics where the
// settings name a folder for them. The keeper's thread; blocks.
class KioskHeartbeat {
  public:
    static constexpr double kEveryS = 60.0;

    explicit KioskHeartbeat(kiosk::Config config) : config_(std::move(config)) {}

    // Both files anew, each whole or as it was. An error is told once, until there is another or none.
    Result<void> beat(const KioskPulse& pulse, std::int64_t now_s);
    // The program ends; nothing where it had not begun.
    Result<void> end(std::int64_t now_s);
    // For a supervisor, after the death of its child, which could not say so itself; nothing where it had
    // said so or had not begun.
    Result<void> end_after_fall(std::int64_t now_s);

  private:
    Result<void> write(std::int64_t now_s);
    Result<void> write_metrics(std::int64_t now_s);

    kiosk::Config config_;
    std::optional<StatusNote> note_;
    std::string told_;  // what went wrong last
};

}  // namespace onggi::app
