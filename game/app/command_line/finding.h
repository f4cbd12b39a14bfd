// What `onggi doctor` finds: a fact, what its lack costs, and how to mend it. Main thread; a probe may block
// for some milliseconds, and changes nothing.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/haptics/haply/inverse_session.h"
#include "engine/haptics/hid/hid_list.h"

namespace onggi::app {

struct Finding {
    enum class Verdict {
        kGood,     // as it should be
        kNote,     // worth knowing; nothing is lost
        kLacking,  // something is lost: cost and remedy say what, and how to mend it
    };
    std::string subject{};  // one or two words
    Verdict verdict = Verdict::kGood;
    std::string found{};
    std::string cost{};    // only where lacking
    std::string remedy{};  // only where lacking
};

// Plain text, a finding a line, with its cost and remedy on lines of their own below it.
std::string findings_as_text(std::span<const Finding> findings);

bool any_lacking(std::span<const Finding> findings);

// What there is to hold and feel the clay with, for `onggi devices` and `onggi doctor`. Opens nothing.

// The simulated tool, which is always there, every HID device - what it can do here, or why it is not used
// and what would mend that -, every gamepad, and whether an Inverse3's service listens. Lacking: a device
// that could be used and is not, or a bus that cannot be seen.
[[nodiscard]] std::vector<Finding> probe_haptic_devices();

// Whether the Inverse3's service listens at that place; asks for 200 ms at most.
[[nodiscard]] Finding probe_inverse(const haptics::haply::InverseOptions& options);

// Whether a stop key is heard while the picture hangs: of keyboards below that folder.
[[nodiscard]] Finding probe_stop_keys(const std::string& folder = "/dev/input");

// Whether the wheel can be heard.
[[nodiscard]] Finding probe_sound();

// One device's line.
[[nodiscard]] Finding finding_for(const haptics::HidDeviceInfo& device);

// What `onggi doctor` asks the machine besides Vulkan and real time: display, disk, fonts, the kiosk's
// settings.

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
