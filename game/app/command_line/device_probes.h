// What there is to hold and feel the clay with, for `onggi devices` and `onggi doctor`. Main thread; may
// block for some milliseconds; opens nothing and changes nothing.
#pragma once

#include <string>
#include <vector>

#include "engine/haptics/haply/inverse_session.h"
#include "engine/haptics/hid/hid_list.h"
#include "game/app/command_line/finding.h"

namespace onggi::app {

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

}  // namespace onggi::app
