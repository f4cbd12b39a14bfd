// What the staff's panel says of a kiosk's health, in lines with ok, warn or fault as words. Any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "game/screens/view.h"

namespace onggi::app {

struct Health {
    double rate_hz = 0.0;
    std::uint64_t skipped_periods = 0;  // since the start
    std::uint64_t late_periods = 0;
    bool has_fault = false;
    double frame_ms = 0.0;  // between two frames
    std::string_view quality;
    double free_mb = 0.0;
    double least_free_mb = 0.0;
    std::vector<std::string> devices;
    std::string holder;             // empty: touch and mouse
    std::vector<std::string> pots;  // newest first
};

enum class StaffPage { kHealth, kGallery, kDevices };
[[nodiscard]] std::vector<screens::StaffLine> staff_lines(const Health& health, StaffPage page);

// Of the machine's clock, where it stands: minutes after midnight.
[[nodiscard]] int minute_of_day();

}  // namespace onggi::app
