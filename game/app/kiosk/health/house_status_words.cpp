#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <ctime>

#include "engine/core/quote.h"
#include "game/app/kiosk/health/house_status.h"
#include "game/app/system/or_null.h"

namespace onggi::app {
namespace {

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

}  // namespace

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
        line("program",
             fmt::format("{}, for {:.0f} s, {} falls lately", note->version, note->running_s, status.falls));
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
        "Which wheel this is.",
        fmt::format(R"(name="{}",version="{}")", label(status.name),
                    label(status.note ? std::string_view(status.note->version) : std::string_view())));
    metrics.gauge("up", "Whether the kiosk runs.", status.state == HouseStatus::State::kRunning ? 1 : 0);
    metrics.gauge("well", "Whether nothing is to be said against it.", status.is_well() ? 1 : 0);
    if (const auto& note = status.note) {
        const KioskPulse& pulse = note->pulse;
        metrics.gauge("heartbeat_timestamp_seconds", "When it was well last, since 1970.",
                      static_cast<double>(note->at_s));
        metrics.gauge("start_timestamp_seconds", "When the program was started, since 1970.",
                      static_cast<double>(note->at_s) - note->running_s);
        metrics.gauge("safe_mode", "Whether it has fallen too often.", pulse.is_safe_mode ? 1 : 0);
        metrics.gauge("force_fault", "Whether a fault takes the force away.", pulse.fault.empty() ? 0 : 1);
        metrics.counter("force_faults_total", "Faults of the force since the start.",
                        static_cast<double>(pulse.faults));
        metrics.gauge("haptic_rate_hertz", "Ticks a second.", pulse.achieved_hz);
        metrics.gauge("haptic_asked_rate_hertz", "Ticks a second as they should be.", pulse.asked_hz);
        metrics.counter("haptic_late_periods_total", "Ticks that were late, since the start.",
                        static_cast<double>(pulse.late_periods));
        metrics.counter("haptic_skipped_periods_total", "Ticks that were left out, since the start.",
                        static_cast<double>(pulse.skipped_periods));
        metrics.gauge("frame_seconds", "Mean time between two frames.", pulse.frame_ms / kMsPerS);
        metrics.gauge("frame_worst_seconds", "Longest time between two frames, of ten seconds.",
                      pulse.worst_frame_ms / kMsPerS);
        metrics.counter("frames_total", "Frames shown since the start.",
                        static_cast<double>(pulse.frames_shown));
        if (note->celsius)
            metrics.gauge("temperature_celsius", "Of the machine's hottest place.", *note->celsius);
        if (note->resident_mb)
            metrics.gauge("resident_memory_bytes", "Memory of the kiosk.",
                          *note->resident_mb * kiosk::kBytesPerMb);
    }
    metrics.gauge("falls", "Falls of the program within ten minutes.", status.falls);
    metrics.gauge("disk_free_bytes", "Where pots are kept.", status.free_mb * kiosk::kBytesPerMb);
    metrics.gauge("pots", "Pots in the gallery.", static_cast<double>(status.pots));
    metrics.gauge("visits_today", "Visits that ended today.", use.visits);
    metrics.gauge("visits_thrown_today", "Those of them with clay on the wheel.", use.thrown);
    metrics.gauge("pots_kept_today", "Pots kept today.", use.kept);
    metrics.gauge("dwell_today_seconds", "Time of today's visits, all together.",
                  static_cast<double>(use.dwell_s));
    metrics.gauge("starts_today", "Starts of the program today.", status.use.starts);
    return metrics.text();
}

}  // namespace onggi::app
