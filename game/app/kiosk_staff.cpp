#include "game/app/kiosk_staff.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

namespace onggi::app {
namespace {

constexpr double kSlowFrameMs = 25.0;  // every second refresh of a 60 Hz panel is missed now and then

}  // namespace

std::vector<screens::StaffLine> staff_lines(const Health& health, StaffPage page) {
    std::vector<screens::StaffLine> lines;
    if (page == StaffPage::kGallery) {
        for (std::size_t i = 0; i < health.pots.size(); ++i)
            lines.push_back(
                {.name = "Pot", .value = health.pots[i], .status = "", .pot = static_cast<int>(i)});
        if (lines.empty()) lines.push_back({.name = "Pots", .value = "none", .status = ""});
        return lines;
    }
    if (page == StaffPage::kDevices) {
        lines.push_back({"Has the tool", health.holder.empty() ? "touch, mouse" : health.holder, ""});
        for (const std::string& name : health.devices)
            lines.push_back({"Plugged in", name, "ok"});
        if (health.devices.empty()) lines.push_back({"Plugged in", "none", ""});
        return lines;
    }
    const auto ok_unless = [](bool bad) { return std::string(bad ? "warn" : "ok"); };
    lines.push_back({"Force tick", fmt::format("{:.0f} Hz", health.rate_hz), "ok"});
    lines.push_back(
        {"Missed ticks", std::to_string(health.skipped_periods), ok_unless(health.skipped_periods > 0)});
    lines.push_back({"Late ticks", std::to_string(health.late_periods), ok_unless(health.late_periods > 0)});
    lines.push_back({"Force", health.has_fault ? "stopped" : "ready", health.has_fault ? "fault" : "ok"});
    lines.push_back(
        {"Frame", fmt::format("{:.0f} ms", health.frame_ms), ok_unless(health.frame_ms > kSlowFrameMs)});
    lines.push_back({"Picture", std::string(health.quality), ""});
    lines.push_back({"Disk free", fmt::format("{:.0f} MB", health.free_mb),
                     health.free_mb < health.least_free_mb ? "fault" : "ok"});
    return lines;
}

int minute_of_day() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm local{};
    localtime_r(&now, &local);
    return local.tm_hour * 60 + local.tm_min;
}

}  // namespace onggi::app
