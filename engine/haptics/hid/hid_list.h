// The HID devices that are plugged in, as hidapi sees them. Main thread; may block for some milliseconds.
// hidapi is used in this folder only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace onggi::haptics {

struct HidDeviceInfo {
    std::string path;  // /dev/hidrawN
    std::string name;  // manufacturer and product, as the device says; may be empty
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    bool may_open = false;  // this user may read and write the device node
};

// One entry a device (hidapi gives one a usage collection), ordered by path.
Result<std::vector<HidDeviceInfo>> list_hid_devices();

}  // namespace onggi::haptics
