// Which driver a HID device gets, and why one gets none. Pure; any thread.
// Sources: vendor and product numbers of 3Dconnexion as in spacenavd's and PySpaceMouse's public lists,
// Sony's as in Linux's hid-playstation; force-feedback joysticks by their report descriptor alone.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/haptics/hid/hid_list.h"

namespace onggi::haptics::hid {

// Fills kind, can, refusal and remedy from all else. A device of a known kind is refused when it may not be
// opened, or when its descriptor lacks what a force needs.
void recognise(HidDeviceInfo& device);

[[nodiscard]] std::string_view words_for(HidKind kind);

struct KnownDevice {
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    HidKind kind = HidKind::kUnknown;
};
// Devices known by number. Joysticks are recognised by their descriptor, whoever made them: those named here
// are named for the udev rules alone.
[[nodiscard]] std::span<const KnownDevice> known_devices() noexcept;

// The udev rule that opens such a device to whoever sits at the machine and to the group plugdev. One device
// a rule, never a whole vendor: a keyboard's keys can be read through its hidraw node.
// assets/udev/70-onggi.rules holds that of each known device.
[[nodiscard]] std::string udev_rule(std::uint16_t vendor_id, std::uint16_t product_id);
// The same for one that is connected by Bluetooth, which has no USB device above its node. Only a DualSense
// is driven that way.
[[nodiscard]] std::string bluetooth_rule(std::uint16_t vendor_id, std::uint16_t product_id);

}  // namespace onggi::haptics::hid
