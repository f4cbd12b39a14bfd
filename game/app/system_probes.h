// What `onggi doctor` asks the machine besides Vulkan and real time: display, disk, fonts, devices. Main
// thread; may block for some milliseconds; changes nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/app/finding.h"

namespace onggi::app {

// Whether a window can be opened, by trying to reach the display that the environment names.
Finding probe_display();

// Free space where pots, pictures and sessions go. An hour of throwing at 4 kHz may take 700 MB.
Finding probe_disk(const std::filesystem::path& folder);

// The font families of the visitor's screens, looked for by file name below `folders`.
Finding probe_fonts(const std::vector<std::filesystem::path>& folders);
std::vector<std::filesystem::path> font_folders();

// The simulated tool, which is always there, and every HID device.
std::vector<Finding> probe_haptic_devices();

}  // namespace onggi::app
