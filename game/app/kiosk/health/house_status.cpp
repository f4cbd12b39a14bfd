#include "game/app/kiosk/health/house_status.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include "engine/core/list_folder.h"
#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/health/kiosk_health.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/system/or_null.h"
#include "game/app/system/process_use.h"
#include "game/app/system/start_log.h"
#include "game/app/system/version.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNoteBytes = std::size_t{64} << 10U;

// Returns an error if the folder may not be read, instead of counting an empty gallery.
Result<void> may_look_into(const fs::path& folder) {
    if (::access(folder.c_str(), R_OK | X_OK) == 0 || errno == ENOENT) return {};
    const int error = errno;
    return system_lacks(
        fmt::format("{}: expected permission to read it, found: {}; root and users of its group have it",
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
    // After the clock was set back, the last heartbeat is in the future until the next one.
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
            complaints.emplace_back("it ended with an error or crashed");
            break;
        case State::kRunning: {
            const StatusNote& note = *status.note;
            if (!note.picture_moves) complaints.emplace_back("the picture hangs");
            if (!note.hand_turns) complaints.emplace_back("the haptic loop hangs");
            if (!note.pulse.fault.empty()) complaints.push_back("no force: " + note.pulse.fault);
            if (note.pulse.is_safe_mode) complaints.emplace_back("safe mode: no devices, a plain picture");
            break;
        }
    }
    if (status.free_mb < least_free_mb) {
        complaints.push_back(
            fmt::format("no pot is kept: {:.0f} MB of the disk are free, {:.0f} are reserved", status.free_mb,
                        least_free_mb));
    }
    return complaints;
}

using nlohmann::ordered_json;

// ISO 8601, UTC.
std::string moment(std::int64_t s) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(s)));
}

double mean_dwell_s(const UseOfHour& use) {
    return use.visits > 0 ? static_cast<double>(use.dwell_s) / use.visits : 0.0;
}

// A label's value: backslash, quote and line end have to be escaped (Prometheus, text format 0.0.4).
std::string label(std::string_view text) {
    std::string escaped;
    for (const char letter : text) {
        if (letter == '\\' || letter == '"') escaped += '\\';
        if (letter == '\n') {
            escaped += "\\n";
        } else {
            escaped += letter;
        }
    }
    return escaped;
}

class Metrics {
  public:
    void gauge(std::string_view name, std::string_view help, double value) {
        add(name, help, "gauge", value);
    }
    void counter(std::string_view name, std::string_view help, double value) {
        add(name, help, "counter", value);
    }
    void information(std::string_view help, std::string_view labels) {
        text_ +=
            fmt::format("# HELP onggi_info {}\n# TYPE onggi_info gauge\nonggi_info{{{}}} 1\n", help, labels);
    }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    void add(std::string_view name, std::string_view help, std::string_view type, double value) {
        text_ += fmt::format("# HELP onggi_{0} {1}\n# TYPE onggi_{0} {2}\nonggi_{0} {3}\n", name, help, type,
                             value);
    }
    std::string text_;
};

constexpr const char* kMetricsFile = "onggi.prom";

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

std::string lines_of(const HouseStatus& status) {
    std::string text;
    const auto line = [&](std::string_view subject, std::string_view words) {
        text += fmt::format("{:<10} {}\n", subject, words);
    };
    const UseOfHour use = status.use.total();
    line("wheel", shown_path(status.name));
    line("health", status.is_well() ? "well" : fmt::format("{}", fmt::join(status.why_not_well, "; ")));
    line("state", name_of(status.state));
    if (const auto& note = status.note) {
        line("heartbeat", fmt::format("{}, {} s ago", moment(note->at_s), status.age_s()));
        line("program", fmt::format("{}, for {:.0f} s, {} crashes lately", note->version, note->running_s,
                                    status.falls));
        line("screen", note->pulse.screen + (note->pulse.is_closed ? ", closed" : ""));
        line("picture", fmt::format("{:.1f} ms a frame, {:.1f} at worst", note->pulse.frame_ms,
                                    note->pulse.worst_frame_ms));
        line("hand", fmt::format("{:.0f} Hz of {:.0f}, {} periods late, {} skipped, {} faults",
                                 note->pulse.achieved_hz, note->pulse.asked_hz, note->pulse.late_periods,
                                 note->pulse.skipped_periods, note->pulse.faults));
        if (note->celsius) line("warmth", fmt::format("{:.0f} degrees Celsius", *note->celsius));
        if (note->resident_mb) line("memory", fmt::format("{:.0f} MB", *note->resident_mb));
    }
    line("disk", fmt::format("{:.0f} MB free, {} pots", status.free_mb, status.pots));
    line("today", fmt::format("{}: {} visits of {:.0f} s, {} threw, {} pots kept; {} starts", status.day,
                              use.visits, mean_dwell_s(use), use.thrown, use.kept, status.use.starts));
    for (const HouseStatus::Fault& fault : status.faults)
        line("fault", fmt::format("{}: onggi replay {} --validate", moment(fault.at_s),
                                  shown_path(fault.session.native())));
    return text;
}

std::string json_of(const HouseStatus& status) {
    const UseOfHour use = status.use.total();
    ordered_json all{{"name", status.name},
                     {"well", status.is_well()},
                     {"why_not_well", status.why_not_well},
                     {"state", name_of(status.state)},
                     {"now", moment(status.now_s)},
                     {"falls", status.falls}};
    if (const auto& note = status.note) {
        const KioskPulse& pulse = note->pulse;
        all["heartbeat"] = {{"at", moment(note->at_s)},
                            {"age_s", status.age_s()},
                            {"version", note->version},
                            {"running_s", note->running_s},
                            {"screen", pulse.screen},
                            {"closed", pulse.is_closed},
                            {"safe_mode", pulse.is_safe_mode},
                            {"fault", pulse.fault},
                            {"faults", pulse.faults},
                            {"haptic_hz", {{"asked", pulse.asked_hz}, {"achieved", pulse.achieved_hz}}},
                            {"late_periods", pulse.late_periods},
                            {"skipped_periods", pulse.skipped_periods},
                            {"frame_ms", {{"mean", pulse.frame_ms}, {"worst", pulse.worst_frame_ms}}},
                            {"frames_shown", pulse.frames_shown},
                            {"celsius", or_null<ordered_json>(note->celsius)},
                            {"resident_mb", or_null<ordered_json>(note->resident_mb)}};
    } else {
        all["heartbeat"] = nullptr;
    }
    all["free_mb"] = status.free_mb;
    all["pots"] = status.pots;
    all["today"] = {{"day", status.day},          {"attract_breaks", use.breaks},
                    {"visits", use.visits},       {"thrown", use.thrown},
                    {"kept", use.kept},           {"mean_dwell_s", mean_dwell_s(use)},
                    {"starts", status.use.starts}};
    all["faults"] = ordered_json::array();
    for (const HouseStatus::Fault& fault : status.faults)
        all["faults"].push_back({{"at", moment(fault.at_s)}, {"session", fault.session.string()}});
    // A folder's name need not be UTF-8.
    return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string metrics_of(const HouseStatus& status) {
    constexpr double kMsPerS = 1e3;
    const UseOfHour use = status.use.total();
    Metrics metrics;
    metrics.information(
        "Name and version of the kiosk.",
        fmt::format(R"(name="{}",version="{}")", label(status.name),
                    label(status.note ? std::string_view(status.note->version) : std::string_view())));
    metrics.gauge("up", "Whether the kiosk runs.", status.state == HouseStatus::State::kRunning ? 1 : 0);
    metrics.gauge("well", "Whether the kiosk is healthy.", status.is_well() ? 1 : 0);
    if (const auto& note = status.note) {
        const KioskPulse& pulse = note->pulse;
        metrics.gauge("heartbeat_timestamp_seconds", "Time of the last heartbeat, since 1970.",
                      static_cast<double>(note->at_s));
        metrics.gauge("start_timestamp_seconds", "When the program was started, since 1970.",
                      static_cast<double>(note->at_s) - note->running_s);
        metrics.gauge("safe_mode", "Whether the kiosk is in safe mode.", pulse.is_safe_mode ? 1 : 0);
        metrics.gauge("force_fault", "Whether a fault removes the force.", pulse.fault.empty() ? 0 : 1);
        metrics.counter("force_faults_total", "Faults of the force since the start.",
                        static_cast<double>(pulse.faults));
        metrics.gauge("haptic_rate_hertz", "Ticks a second.", pulse.achieved_hz);
        metrics.gauge("haptic_asked_rate_hertz", "Wanted ticks a second.", pulse.asked_hz);
        metrics.counter("haptic_late_periods_total", "Ticks that were late, since the start.",
                        static_cast<double>(pulse.late_periods));
        metrics.counter("haptic_skipped_periods_total", "Skipped ticks, since the start.",
                        static_cast<double>(pulse.skipped_periods));
        metrics.gauge("frame_seconds", "Mean time between two frames.", pulse.frame_ms / kMsPerS);
        metrics.gauge("frame_worst_seconds", "Longest time between two frames, of ten seconds.",
                      pulse.worst_frame_ms / kMsPerS);
        metrics.counter("frames_total", "Frames shown since the start.",
                        static_cast<double>(pulse.frames_shown));
        if (note->celsius)
            metrics.gauge("temperature_celsius", "The machine's highest temperature.", *note->celsius);
        if (note->resident_mb)
            metrics.gauge("resident_memory_bytes", "Memory of the kiosk.",
                          *note->resident_mb * kiosk::kBytesPerMb);
    }
    metrics.gauge("falls", "Crashes of the program within ten minutes.", status.falls);
    metrics.gauge("disk_free_bytes", "Free space on the disk of the pots.",
                  status.free_mb * kiosk::kBytesPerMb);
    metrics.gauge("pots", "Pots in the gallery.", static_cast<double>(status.pots));
    metrics.gauge("visits_today", "Visits that ended today.", use.visits);
    metrics.gauge("visits_thrown_today", "Visits today with clay on the wheel.", use.thrown);
    metrics.gauge("pots_kept_today", "Pots kept today.", use.kept);
    metrics.gauge("dwell_today_seconds", "Total time of today's visits.", static_cast<double>(use.dwell_s));
    metrics.gauge("starts_today", "Starts of the program today.", status.use.starts);
    return metrics.text();
}

Result<void> KioskHeartbeat::beat(const KioskPulse& pulse, std::int64_t now_s) {
    const KioskPulse before = note_ ? note_->pulse : KioskPulse{};
    note_ = StatusNote{.at_s = now_s,
                       .running_s = since_start_s().value_or(0.0),
                       .picture_moves = pulse.frames_shown != before.frames_shown,
                       .hand_turns = pulse.haptic_ticks != before.haptic_ticks,
                       .version = version(),
                       .pulse = pulse,
                       .celsius = hottest_celsius(),
                       .resident_mb = resident_mb()};
    return write(now_s);
}

Result<void> KioskHeartbeat::end(std::int64_t now_s) {
    if (!note_) return {};
    note_->at_s = now_s;
    note_->has_ended = true;
    return write(now_s);
}

Result<void> KioskHeartbeat::end_after_fall(std::int64_t now_s) {
    auto note = read_status_note_of(config_.gallery.folder);
    if (!note) return note.error();
    if (!*note || (*note)->has_ended) return {};
    note_ = std::move(**note);
    return end(now_s);
}

Result<void> KioskHeartbeat::write(std::int64_t now_s) {
    std::error_code ignored;  // write_file_atomically() reports the error
    const std::filesystem::path file = status_file(config_.gallery.folder);
    std::filesystem::create_directories(file.parent_path(), ignored);
    Result<void> written = files::write_file_atomically(file, text_of(*note_));
    if (const auto metrics = write_metrics(now_s); written) written = metrics;
    const std::string trouble = written ? std::string() : written.error().message;
    if (std::exchange(told_, trouble) == trouble) return {};
    return written;
}

Result<void> KioskHeartbeat::write_metrics(std::int64_t now_s) {
    if (config_.staff.metrics_folder.empty()) return {};
    const auto status = look_at_house(config_, now_s);
    if (!status) return status.error();
    const std::filesystem::path file = std::filesystem::path(config_.staff.metrics_folder) / kMetricsFile;
    if (auto written = files::write_file_atomically(file, metrics_of(*status)); !written) return written;
    // Another user reads the file, so it must be readable whatever the umask; an existing file keeps its
    // permissions.
    using std::filesystem::perms;
    std::error_code error;
    std::filesystem::permissions(
        file, perms::owner_read | perms::owner_write | perms::group_read | perms::others_read, error);
    if (error)
        return system_lacks(file.string() + ": expected to let others read it, found: " + error.message());
    return {};
}

}  // namespace onggi::app
