// What the kiosk shows of a shared pot: its address, the Wi-Fi to join before, and until when it is there.
// Any thread; pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "game/kiosk/config.h"
#include "game/sharing/outbox.h"
#include "game/sharing/share_code.h"

namespace onggi::sharing {

// "http://10.0.0.5:8080" or a public_url, and a code: what the QR code says.
[[nodiscard]] std::string page_url(const std::string& base, const ShareCode& code);

// "http://10.0.0.5:8080", "http://[fd00::5]"; port 80 is left out.
[[nodiscard]] std::string base_url(std::string_view address, int port);

// What a phone's camera joins a Wi-Fi by: "WIFI:T:WPA;S:Museum;P:key;;", without a key "WIFI:T:nopass;...".
// Empty where the settings name none.
[[nodiscard]] std::string wifi_text(const kiosk::Config& config);

constexpr std::int64_t kDayS = 24 * 3600;

// A pot that is shared now goes at the end of the day, when the museum closes or at midnight, but an hour
// from now at the earliest; or after so many hours, where the settings say how many.
[[nodiscard]] ShareTime share_time(const kiosk::Config& config, std::int64_t now_s,
                                   std::int64_t utc_offset_s);

}  // namespace onggi::sharing
