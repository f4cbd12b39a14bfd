#include "game/app/kiosk/staff/kiosk_staff.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <utility>

namespace onggi::app {
namespace {

using screens::StaffLine;

constexpr double kSlowFrameMs = 25.0;  // a 60 Hz panel sometimes misses every second refresh
constexpr double kEnoughRate = 0.98;   // of the requested rate
constexpr double kHotCelsius = 85.0;   // processors throttle from here

std::string ok_unless(bool bad) {
    return bad ? "warn" : "ok";
}

std::string time_words(double seconds) {
    const auto whole = static_cast<long>(seconds);
    constexpr long kMinute = 60;
    constexpr long kHour = 60 * kMinute;
    if (whole < kMinute) return fmt::format("{} s", whole);
    if (whole < kHour) return fmt::format("{} min {} s", whole / kMinute, whole % kMinute);
    return fmt::format("{} h {} min", whole / kHour, whole % kHour / kMinute);
}

StaffLine rate_line(const Health& health) {
    if (health.achieved_hz <= 0.0)
        return {"Force tick", fmt::format("{:.0f} Hz asked for", health.asked_hz), ""};
    return {"Force tick", fmt::format("{:.0f} of {:.0f} Hz", health.achieved_hz, health.asked_hz),
            ok_unless(health.achieved_hz < kEnoughRate * health.asked_hz)};
}

StaffLine drawing_line(const Health& health) {
    if (health.device_ms <= 0.0) return {"Drawing", "this device does not measure it", ""};
    // With a software device most of the drawing happens before the device's work.
    double whole_ms = health.device_ms;
    for (const render::PassTime& part : health.parts)
        whole_ms += part.is_on_host ? part.ms : 0.0;
    std::string words = fmt::format("{:.1f} ms", whole_ms);
    const char* between = ": ";
    for (const render::PassTime& part : health.parts) {
        constexpr double kLeastMs = 0.05;  // shorter passes are not listed
        if (part.ms < kLeastMs) continue;
        words += fmt::format("{}{} {:.1f}", between, part.name, part.ms);
        between = ", ";
    }
    return {"Drawing", words, ""};
}

std::vector<StaffLine> health_lines(const Health& health) {
    std::vector<StaffLine> lines;
    lines.push_back(rate_line(health));
    lines.push_back(
        {"Missed ticks", std::to_string(health.skipped_periods), ok_unless(health.skipped_periods > 0)});
    lines.push_back({"Late ticks", std::to_string(health.late_periods), ok_unless(health.late_periods > 0)});
    lines.push_back({"Force", health.fault.empty() ? "ready" : std::string(health.fault),
                     health.fault.empty() ? "ok" : "fault"});
    lines.push_back({"Frame",
                     fmt::format("{:.1f} ms, at most {:.0f} in 10 s", health.frame_ms, health.worst_frame_ms),
                     ok_unless(health.frame_ms > kSlowFrameMs)});
    lines.push_back(drawing_line(health));
    if (health.is_safe_mode) {
        lines.push_back({"Safe mode", fmt::format("after {} crashes", health.falls), "warn"});
    } else {
        lines.push_back({"Crashes before", std::to_string(health.falls), ok_unless(health.falls > 0)});
    }
    lines.push_back({"Picture", std::string(health.quality), ""});
    if (health.celsius) {
        lines.push_back({"Temperature", fmt::format("{:.0f} \u00b0C", *health.celsius),
                         ok_unless(*health.celsius > kHotCelsius)});
    } else {
        lines.push_back({"Temperature", "not measured here", ""});
    }
    lines.push_back({"Disk free",
                     fmt::format("{:.0f} MB, {:.0f} needed", health.free_mb, health.least_free_mb),
                     health.free_mb < health.least_free_mb ? "fault" : "ok"});
    lines.push_back({"Running",
                     fmt::format("{}, started {} {} today", time_words(health.running_s), health.use.starts,
                                 health.use.starts == 1 ? "time" : "times"),
                     ""});
    constexpr double kLeastDegrees = 0.7;
    lines.push_back({"Smallest text",
                     fmt::format("{:.2f}\u00b0 at {:.0f} mm", health.text_degrees, health.distance_mm),
                     ok_unless(health.text_degrees < kLeastDegrees)});
    lines.push_back({"Sound", health.sound.empty() ? "none: " + health.sound_lack : health.sound,
                     ok_unless(health.sound.empty())});
    return lines;
}

std::string use_words(const UseOfHour& use) {
    std::string words =
        fmt::format("{} begun, {} ended, {} thrown, {} kept", use.breaks, use.visits, use.thrown, use.kept);
    if (use.visits > 0) words += ", " + time_words(static_cast<double>(use.dwell_s) / use.visits) + " each";
    return words;
}

std::vector<StaffLine> visit_lines(const UseOfDay& use) {
    std::vector<StaffLine> lines{{"Today", use_words(use.total()), ""}};
    for (std::size_t hour = 0; hour < use.hours.size(); ++hour) {
        if (use.hours[hour] == UseOfHour{}) continue;
        lines.push_back({fmt::format("{:02}\u2013{:02} h", hour, hour + 1), use_words(use.hours[hour]), ""});
    }
    return lines;
}

std::vector<StaffLine> gallery_lines(const Health& health) {
    std::vector<StaffLine> lines;
    std::map<int, std::string> until;
    for (const auto& [number, note] : health.shared)
        until[number] = note.until;
    for (const auto& [number, name] : health.pots) {
        StaffLine line{.name = "Pot", .value = name, .status = "", .pot = number};
        if (const auto shared = until.extract(number); !shared.empty()) {
            line.name = "Shared until " + shared.mapped();
            line.code = number;
        }
        lines.push_back(std::move(line));
    }
    if (health.pots_beyond > 0)
        lines.push_back({"Older pots", fmt::format("{} more on the disk", health.pots_beyond), ""});
    // Pots deleted from the gallery outside the program are still shared.
    const char* const where = health.pots_beyond > 0 ? ", not among these" : ", no longer here";
    for (const auto& [number, note] : health.shared) {
        if (!until.contains(number)) continue;
        lines.push_back({.name = "Shared until " + note.until,
                         .value = note.gallery_name + where,
                         .status = "",
                         .code = number});
    }
    if (lines.empty()) lines.push_back({.name = "Pots", .value = "none", .status = ""});
    return lines;
}

std::vector<StaffLine> device_lines(const Health& health) {
    std::vector<StaffLine> lines;
    lines.push_back({"Has the tool", health.holder.empty() ? "touch, mouse" : health.holder, ""});
    for (const AttachedDevices::Seen& device : health.devices) {
        lines.push_back(
            {device.name, device.works ? device.ability : device.why_not, device.works ? "ok" : "warn"});
    }
    if (health.devices.empty()) lines.push_back({"Plugged in", "none", ""});
    for (const std::string& name : health.restless)
        lines.push_back({name, "does not come to rest; it does not keep the kiosk awake", "warn"});
    return lines;
}

}  // namespace

std::vector<StaffLine> staff_lines(const Health& health, kiosk::StaffPage page) {
    switch (page) {
        case kiosk::StaffPage::kHealth:
            return health_lines(health);
        case kiosk::StaffPage::kVisits:
            return visit_lines(health.use);
        case kiosk::StaffPage::kGallery:
            return gallery_lines(health);
        case kiosk::StaffPage::kDevices:
            return device_lines(health);
    }
    return {};
}

std::string force_test_words(const haptic::ForceTestReport& report, std::string_view device) {
    using Stage = haptic::ForceTestReport::Stage;
    constexpr double kGivenFraction = 0.5;
    constexpr double kMovedMm = 0.1;
    switch (report.stage) {
        case Stage::kNone:
            return {};
        case Stage::kWaits:
            return "Force: it comes back slowly, wait";
        case Stage::kPushes:
            return "Force: up, right, towards you";
        case Stage::kNobody:
            return fmt::format("Force: {} feels no hand; hold it and test again", device);
        case Stage::kBroken:
            return "Force: the test was interrupted";
        case Stage::kDone:
            break;
    }
    const dvec3& given_n = report.given_n;
    const dvec3& moved_mm = report.moved_mm;
    const double least_n = std::min({given_n.x, given_n.y, given_n.z});
    const double most_mm = std::max({moved_mm.x, moved_mm.y, moved_mm.z});
    const char* verdict = least_n < kGivenFraction * haptic::kTestForceN ? "less than asked for"
                          : most_mm < kMovedMm                           ? "given, but nothing moved"
                                                                         : "ok";
    return fmt::format("Force: {}. {}: {:.2f} N of {:.2f}, moved {:.1f} up, {:.1f} right, {:.1f} mm near",
                       verdict, device, least_n, haptic::kTestForceN, moved_mm.y, moved_mm.x, moved_mm.z);
}

int minute_of_day_at(std::int64_t now_s) {
    const auto now = static_cast<std::time_t>(now_s);
    std::tm local{};
    localtime_r(&now, &local);
    return local.tm_hour * 60 + local.tm_min;
}

int minute_of_day() {
    return minute_of_day_at(wall_clock_s());
}

}  // namespace onggi::app
