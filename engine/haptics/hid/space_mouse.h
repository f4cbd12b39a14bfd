// 3Dconnexion SpaceMouse: six axes at rest in the middle, buttons, one lamp; no force. Decoding and mapping,
// pure; one thread at a time.
// Source: the two report layouts as captured in public from a SpaceNavigator (046d:c626), a SpaceMouse
// Compact (256f:c635) and, by its descriptor only, a SpaceMouse Wireless (AndunHH/spacemouse; CloudCompare
// pull request 2339). Never tried on hardware by this project.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/haptics/hid/hand_input.h"
#include "engine/haptics/hid/hid_port.h"

namespace onggi::haptics::hid {

// The device's own axes: X right, Y towards the user, Z down; each about -350 to 350, some a little beyond.
struct SpaceMouseState {
    std::array<std::int16_t, 3> translation{};  // X, Y, Z
    std::array<std::int16_t, 3> rotation{};     // Rx, Ry, Rz
    std::uint32_t buttons = 0;                  // bit 0 is button 1
    int battery_percent = -1;                   // -1: it did not say

    [[nodiscard]] bool at_rest() const noexcept {
        return translation == std::array<std::int16_t, 3>{} && rotation == std::array<std::int16_t, 3>{};
    }
};

// Takes one report into the state. Whether report 1 carries the rotation too is told by its length, not by
// the model: receivers and firmware decide. False: not a report of this device; the state is as before.
//   id 1, 7 bytes: X Y Z;  id 2, 7 bytes: Rx Ry Rz;  id 1, 13 bytes: X Y Z Rx Ry Rz; all int16, low byte
//   first id 3, 2 to 5 bytes and more: buttons from byte 1, bit 0;  id 0x17, 3 bytes: byte 1 the battery in
//   percent
bool take_space_mouse_report(std::span<const std::uint8_t> report, SpaceMouseState& state) noexcept;

// Host to device: 04 01 lamp on, 04 00 off.
[[nodiscard]] Report space_mouse_lamp(bool on) noexcept;

// Rate control: push sideways to move the tool out and in, down to lower it.
struct SpaceMouseMapping {
    double full_scale = 350.0;  // of the descriptor's logical range; more is held to it
    double dead_band = 15.0;
    double fastest_mm_s = 150.0;
    double fastest_change_rev_min_s = 80.0;  // of the wheel, twisted all the way
};

// An axis as -1 to 1: zero within the dead band, then growing from zero by the third power, so that a light
// push moves finely.
[[nodiscard]] double shaped_axis(std::int16_t value, const SpaceMouseMapping& mapping) noexcept;
// Radius and height, mm/s: X right is outwards, Z down is down.
[[nodiscard]] dvec2 space_mouse_rate_mm_s(const SpaceMouseState& state,
                                          const SpaceMouseMapping& mapping) noexcept;

}  // namespace onggi::haptics::hid
