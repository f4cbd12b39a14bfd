// Selects the driver of a HID device, or states why there is none. Pure; any thread. Sources: vendor and
// product numbers of 3Dconnexion as in spacenavd's and PySpaceMouse's public lists, Sony's as in Linux's
// hid-playstation; force-feedback joysticks by their report descriptor alone.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/haptics/hid/hid_list.h"

namespace onggi::haptics::hid {

// Fills kind, can, refusal and remedy from the other fields. A device of a known kind is refused if it may
// not be opened, or if its descriptor lacks a report that forces need.
void recognise(HidDeviceInfo& device);

[[nodiscard]] std::string_view words_for(HidKind kind);

struct KnownDevice {
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    HidKind kind = HidKind::kUnknown;
};
// Devices known by number. Joysticks are recognised by their descriptor, from any maker; those listed here
// are only for the udev rules.
[[nodiscard]] std::span<const KnownDevice> known_devices() noexcept;

// The udev rule that opens such a device to the user at the machine and to the group plugdev. One rule per
// device and never a whole vendor, because a keyboard's keys can be read through its hidraw node.
// assets/udev/70-onggi.rules holds the rules of all known devices.
[[nodiscard]] std::string udev_rule(std::uint16_t vendor_id, std::uint16_t product_id);
// The rule for a device that is connected by Bluetooth, which has no USB device above its node. Only a
// DualSense is driven that way.
[[nodiscard]] std::string bluetooth_rule(std::uint16_t vendor_id, std::uint16_t product_id);

}  // namespace onggi::haptics::hid
