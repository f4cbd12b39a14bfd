// What `onggi doctor` asks the machine besides Vulkan and real time: display, disk, fonts, the kiosk's
// settings. Main thread; may block for some milliseconds; changes nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/app/command_line/finding.h"

namespace onggi::app {

// Whether a window can be opened, by trying to reach the display that the environment names.
Finding probe_display();

// The photographed workshop that comes with the program: where it is, or why the small still life is shown
// instead.
Finding probe_workshop();

// Free space where pots, pictures and sessions go. An hour of throwing at 4 kHz may take 700 MB.
Finding probe_disk(const std::filesystem::path& folder);

// The font families of the visitor's screens, looked for by file name below `folders`.
Finding probe_fonts(const std::vector<std::filesystem::path>& folders);
std::vector<std::filesystem::path> font_folders();

// Where an installed kiosk has its settings.
constexpr const char* kUsualSettings = "/etc/onggi/kiosk.toml";

// The kiosk's settings, read as `onggi kiosk` reads them and, where they are wrong, in its words; what they
// leave out; the room of their own; and whether the disk has the space that they ask for pots. `file` empty:
// those at `usual`, if there are any.
std::vector<Finding> probe_settings(const std::string& file, const std::string& usual = kUsualSettings);

}  // namespace onggi::app
