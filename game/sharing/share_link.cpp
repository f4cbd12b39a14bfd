#include "game/sharing/share_link.h"

#include <fmt/format.h>

#include <algorithm>

namespace onggi::sharing {
namespace {

// Escapes the characters that need a backslash in such a text.
std::string fenced(std::string_view text) {
    std::string safe;
    for (const char letter : text) {
        if (std::string_view("\\;,:\"").find(letter) != std::string_view::npos) safe += '\\';
        safe += letter;
    }
    return safe;
}

}  // namespace

std::string page_url(const std::string& base, const ShareCode& code) {
    return base + (base.ends_with('/') ? "" : "/") + code.text() + "/";
}

std::string base_url(std::string_view address, int port) {
    constexpr int kWebPort = 80;
    const bool is_ipv6 = address.find(':') != std::string_view::npos;
    return fmt::format("http://{}{}{}{}", is_ipv6 ? "[" : "", address, is_ipv6 ? "]" : "",
                       port == kWebPort ? "" : fmt::format(":{}", port));
}

std::string wifi_text(const kiosk::Config& config) {
    const auto& sharing = config.sharing;
    if (sharing.wifi_name.empty()) return {};
    if (sharing.wifi_key.empty()) return fmt::format("WIFI:T:nopass;S:{};;", fenced(sharing.wifi_name));
    return fmt::format("WIFI:T:WPA;S:{};P:{};;", fenced(sharing.wifi_name), fenced(sharing.wifi_key));
}

ShareTime share_time(const kiosk::Config& config, std::int64_t now_s, std::int64_t utc_offset_s) {
    constexpr std::int64_t kHourS = 3600;
    ShareTime time{.now_s = now_s, .expires_s = 0, .utc_offset_s = utc_offset_s};
    if (config.sharing.hours > 0) {
        time.expires_s = now_s + config.sharing.hours * kHourS;
        return time;
    }
    const std::int64_t of_day = ((now_s + utc_offset_s) % kDayS + kDayS) % kDayS;
    const bool closes = config.hours.opens_min != config.hours.closes_min;
    // The next closing time. A visit that goes on after closing gets an hour.
    std::int64_t left_s = (closes ? std::int64_t{config.hours.closes_min} * 60 : kDayS) - of_day;
    if (left_s <= 0) left_s += kDayS;
    if (closes && !kiosk::is_open(config, static_cast<int>(of_day / 60))) left_s = kHourS;
    time.expires_s = now_s + std::max(left_s, kHourS);
    return time;
}

}  // namespace onggi::sharing
