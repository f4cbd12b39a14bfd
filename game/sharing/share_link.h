// The kiosk's text about a shared pot: its address, the Wi-Fi to join first, and its expiry time. Any thread;
// pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "game/kiosk/config.h"
#include "game/sharing/outbox.h"
#include "game/sharing/share_code.h"

namespace onggi::sharing {

// The content of the QR code: "http://10.0.0.5:8080" or a public_url, and a code.
[[nodiscard]] std::string page_url(const std::string& base, const ShareCode& code);

// "http://10.0.0.5:8080", "http://[fd00::5]"; port 80 is omitted.
[[nodiscard]] std::string base_url(std::string_view address, int port);

// The QR text with which a phone joins a Wi-Fi: "WIFI:T:WPA;S:Museum;P:key;;", without a key
// "WIFI:T:nopass;...". Empty if the settings have no Wi-Fi.
[[nodiscard]] std::string wifi_text(const kiosk::Config& config);

constexpr std::int64_t kDayS = 24 * 3600;

// Times of a pot shared now. It expires after the configured hours; without these at the end of the day
// (closing time or midnight), but at least an hour from now.
[[nodiscard]] ShareTime share_time(const kiosk::Config& config, std::int64_t now_s,
                                   std::int64_t utc_offset_s);

}  // namespace onggi::sharing
