// The findings of `onggi doctor`: a fact, the effect of a lack, and its remedy. Main thread. A probe may
// block for some milliseconds and does not change the machine.
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
        kGood,     // as expected
        kNote,     // worth knowing, without a loss
        kLacking,  // something is lost: `cost` and `remedy` explain
    };
    std::string subject{};  // one or two words
    Verdict verdict = Verdict::kGood;
    std::string found{};
    std::string cost{};    // only if kLacking
    std::string remedy{};  // only if kLacking
};

// Plain text: one line per finding, followed by lines for its cost and remedy.
std::string findings_as_text(std::span<const Finding> findings);

bool any_lacking(std::span<const Finding> findings);

// Probes the haptic and input devices for `onggi devices` and `onggi doctor`. Opens no device.

// Reports the simulated tool, which is always available; every HID device with its use here, or the reason
// why it is not used and the remedy; every gamepad; and whether an Inverse3's service listens. Lacking: a
// usable device is not used, or a bus cannot be read.
[[nodiscard]] std::vector<Finding> probe_haptic_devices();

// Checks whether the Inverse3's service listens at that address. Waits up to 200 ms.
[[nodiscard]] Finding probe_inverse(const haptics::haply::InverseOptions& options);

// Checks whether the stop key works while the picture hangs: looks for readable keyboards below that folder.
[[nodiscard]] Finding probe_stop_keys(const std::string& folder = "/dev/input");

// Checks whether there is a sound device.
[[nodiscard]] Finding probe_sound();

// Returns the finding for one device.
[[nodiscard]] Finding finding_for(const haptics::HidDeviceInfo& device);

// The other probes of `onggi doctor`, apart from Vulkan and real time: display, disk, fonts, the kiosk's
// settings.

// Checks whether a window can be opened: tries to connect to the environment's display.
Finding probe_display();

// Reports the place of the photographed workshop that comes with the program, or the reason why the small
// still life is shown instead.
Finding probe_workshop();

// Checks the free space for pots, pictures and sessions. An hour of throwing at 4 kHz may take 700 MB.
Finding probe_disk(const std::filesystem::path& folder);

// Checks the font families of the visitor's screens in these languages (BCP 47), searched by file name below
// `folders`.
Finding probe_fonts(const std::vector<std::filesystem::path>& folders,
                    std::span<const std::string> languages);
std::vector<std::filesystem::path> font_folders();

// The settings file of an installed kiosk.
constexpr const char* kUsualSettings = "/etc/onggi/kiosk.toml";

// Checks the kiosk's settings, read with the same errors as by `onggi kiosk`; missing settings; their room;
// and whether the disk has the space that they require for pots. An empty `file` means `usual`, if that
// exists.
std::vector<Finding> probe_settings(const std::string& file, const std::string& usual = kUsualSettings);

}  // namespace onggi::app
