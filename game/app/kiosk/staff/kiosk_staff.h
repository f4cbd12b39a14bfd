// The lines of the staff's panel, with ok, warn or fault as words. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/render/pass_clock.h"
#include "game/app/devices/attached_devices.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/keeping/kiosk_phone.h"
#include "game/haptic/force_test.h"
#include "game/screens/page/view.h"

namespace onggi::app {

struct Health {
    double asked_hz = 0.0;
    double achieved_hz = 0.0;           // 0: not measured yet
    std::uint64_t skipped_periods = 0;  // since the start
    std::uint64_t late_periods = 0;
    std::string_view fault = {};  // in words; may be empty
    double frame_ms = 0.0;        // between two frames, mean of the last seconds
    double worst_frame_ms = 0.0;
    double device_ms = 0.0;  // of the last frame; 0: not measured
    std::vector<render::PassTime> parts = {};
    std::string_view quality = {};
    std::optional<double> celsius = {};
    double free_mb = 0.0;
    double least_free_mb = 0.0;
    int falls = 0;  // crashes within ten minutes before the start
    bool is_safe_mode = false;
    double running_s = 0.0;
    double text_degrees = 0.0;  // of the smallest capitals at the configured distance
    double distance_mm = 0.0;
    std::string sound = {};  // name of the sound device; empty without one
    std::string sound_lack = {};
    std::vector<AttachedDevices::Seen> devices = {};
    std::string holder = {};                 // the device with the tool; empty for touch and mouse
    std::vector<std::string> restless = {};  // devices and controls that do not come to rest
    UseOfDay use = {};
    std::vector<std::pair<int, std::string>> pots = {};  // number for the delete key, and name; newest first
    std::size_t pots_beyond = 0;                         // number of older ones, not in `pots`
    std::vector<std::pair<int, SharedPotNote>> shared = {};  // the same for the withdraw key
};

[[nodiscard]] std::vector<screens::StaffLine> staff_lines(const Health& health, kiosk::StaffPage page);

// The result of a force test. `hand` is the name of the device that had the tool.
[[nodiscard]] std::string force_test_words(const haptic::ForceTestReport& report, std::string_view hand);

// Local time in minutes after midnight: now by the machine's clock, or at a second since 1970.
[[nodiscard]] int minute_of_day();
[[nodiscard]] int minute_of_day_at(std::int64_t now_s);

}  // namespace onggi::app
