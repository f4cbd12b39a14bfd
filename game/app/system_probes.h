// What `onggi doctor` asks the machine besides Vulkan and real time: display, disk, fonts. Main
// thread; may block for some milliseconds; changes nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/app/finding.h"

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

}  // namespace onggi::app
