// The state of a kiosk, from its files only. The museum's monitoring reads it while the kiosk runs or is
// down, and as another user. Any thread but the haptic one and the frame's; changes no file.
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
        kNeverStarted,  // no heartbeat yet
        kRunning,
        kSilent,  // no heartbeat for kSilentAfterS: it hangs, or was cut off with its supervisor
        kEnded,   // intentionally
        kFell,    // it ended with an error, or its supervisor reported a crash
    };
    struct Fault {
        std::filesystem::path session;  // for `onggi replay`
        std::int64_t at_s = 0;
    };
    static constexpr std::int64_t kSilentAfterS = 150;  // 2.5 heartbeats
    static constexpr std::size_t kMostFaults = 5;

    std::string name{};  // of the unit
    State state = State::kNeverStarted;
    std::vector<std::string> why_not_well{};  // empty if it is well
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

// The state of the kiosk with these settings, at that time. System lacks: its files may not be read.
[[nodiscard]] Result<HouseStatus> look_at_house(const kiosk::Config& config, std::int64_t now_s);

// lines_of(): one line per fact. json_of(): one JSON object. metrics_of(): Prometheus' text format, version
// 0.0.4, for the textfile collector of node_exporter.
[[nodiscard]] std::string lines_of(const HouseStatus& status);
[[nodiscard]] std::string json_of(const HouseStatus& status);
[[nodiscard]] std::string metrics_of(const HouseStatus& status);

// The folder of the sessions of faults and crashes.
[[nodiscard]] inline std::filesystem::path faults_folder(const std::filesystem::path& gallery) {
    return gallery / "faults";
}
[[nodiscard]] std::filesystem::path status_file(const std::filesystem::path& gallery);
// Reads the heartbeat. Returns nothing if there is none. Errors: as for reading the file.
[[nodiscard]] Result<std::optional<StatusNote>> read_status_note_of(const std::filesystem::path& gallery);

// Writes the files for the museum's monitoring: the heartbeat beside the visit in progress, and metrics if
// the settings name a folder for them. The keeper's thread; blocks.
class KioskHeartbeat {
  public:
    static constexpr double kEveryS = 60.0;

    explicit KioskHeartbeat(kiosk::Config config) : config_(std::move(config)) {}

    // Rewrites both files atomically. Reports an error once, until it changes or goes away.
    Result<void> beat(const KioskPulse& pulse, std::int64_t now_s);
    // Records the program's end; has no effect before the first beat.
    Result<void> end(std::int64_t now_s);
    // Records a crash, for a supervisor after the death of its child; has no effect if the child had recorded
    // its end or had not begun.
    Result<void> end_after_fall(std::int64_t now_s);

  private:
    Result<void> write(std::int64_t now_s);
    Result<void> write_metrics(std::int64_t now_s);

    kiosk::Config config_;
    std::optional<StatusNote> note_;
    std::string told_;  // the last error
};

}  // namespace onggi::app
