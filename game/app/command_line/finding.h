// What `onggi doctor` finds: a fact, what its lack costs, and how to mend it. Main thread; a probe may block
// for some milliseconds, and does not change the machine.
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

// Probes the haptic and input devices for `onggi devices` and `onggi doctor`. Opens no device.

// The simulated tool, which is always available; every HID device with its use here, or the reason why it is
// not used and the remedy; every gamepad; and whether an Inverse3's service listens. Lacking: a usable device
// that is not used, or a bus that cannot be read.
[[nodiscard]] std::vector<Finding> probe_haptic_devices();

// Whether the Inverse3's service listens at that address; waits for up to 200 ms.
[[nodiscard]] Finding probe_inverse(const haptics::haply::InverseOptions& options);

// Whether the stop key works while the picture hangs: looks for readable keyboards below that folder.
[[nodiscard]] Finding probe_stop_keys(const std::string& folder = "/dev/input");

// Whether there is a sound device.
[[nodiscard]] Finding probe_sound();

// The finding of one device.
[[nodiscard]] Finding finding_for(const haptics::HidDeviceInfo& device);

// The probes of `onggi doctor` besides Vulkan and real time: display, disk, fonts, the kiosk's settings.

// Whether a window can be opened: tries to connect to the display of the environment.
Finding probe_display();

// The photographed workshop that comes with the program: its place, or why the small still life is shown
// instead.
Finding probe_workshop();

// Free space where pots, pictures and sessions go. An hour of throwing at 4 kHz may take 700 MB.
Finding probe_disk(const std::filesystem::path& folder);

// The font families of the visitor's screens, searched by file name below `folders`.
Finding probe_fonts(const std::vector<std::filesystem::path>& folders);
std::vector<std::filesystem::path> font_folders();

// The settings file of an installed kiosk.
constexpr const char* kUsualSettings = "/etc/onggi/kiosk.toml";

// The kiosk's settings, read like `onggi kiosk` with the same errors; missing settings; their room; and
// whether the disk has the space that they require for pots. An empty `file` means `usual`, if it exists.
std::vector<Finding> probe_settings(const std::string& file, const std::string& usual = kUsualSettings);

}  // namespace onggi::app
