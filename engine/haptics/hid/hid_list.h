// Lists the plugged-in HID devices with their use here, or the reason why a device is not used. Main thread
// or an I/O thread; may block for some milliseconds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace onggi::haptics {

enum class HidBusType : std::uint8_t { kUnknown, kUsb, kBluetooth, kOther };

// The kinds of device that have a driver.
enum class HidKind : std::uint8_t {
    kUnknown,
    kForceJoystick,  // USB PID 1.0: two axes that push back
    kSpaceMouse,     // six axes, no force
    kDualSense,      // sticks; a trigger that pushes back
    kVecPedal,       // a foot pedal for the wheel
};

struct HidDeviceInfo {
    std::string path = {};  // /dev/hidrawN
    std::string name = {};  // manufacturer and product, as reported; may be empty
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    bool may_open = false;  // this user may read and write the device node
    HidBusType bus = HidBusType::kUnknown;
    std::vector<std::uint8_t> report_descriptor = {};  // empty if it cannot be read
    // Derived from the above (hid_kind.h).
    HidKind kind = HidKind::kUnknown;
    std::string can = {};      // one line: its use here; empty for an unknown device
    std::string refusal = {};  // one line: why it is not used; empty if it is used
    std::string remedy = {};   // one line: how to fix that; empty if there is no fix
};

// One entry per device, ordered by path; hidapi lists one per collection
// (findings/hidapi-lists-one-joystick-once-for-each-inner-collection.sh).
Result<std::vector<HidDeviceInfo>> list_hid_devices();

}  // namespace onggi::haptics
