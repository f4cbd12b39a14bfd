// A gamepad as the window system sees it: plain data. Any thread.
#pragma once

#include <cstdint>
#include <string>

namespace onggi::window {

struct Gamepad {
    enum Button : std::uint32_t {  // bits of `buttons`, named as on an Xbox pad
        kA = 1U << 0U,
        kB = 1U << 1U,
        kX = 1U << 2U,
        kY = 1U << 3U,
        kLeftBumper = 1U << 4U,
        kRightBumper = 1U << 5U,
        kBack = 1U << 6U,
        kStart = 1U << 7U,
        kGuide = 1U << 8U,
        kLeftStick = 1U << 9U,
        kRightStick = 1U << 10U,
        kUp = 1U << 11U,
        kRight = 1U << 12U,
        kDown = 1U << 13U,
        kLeft = 1U << 14U,
    };

    int slot = 0;  // constant while the pad is plugged in
    std::string name = {};
    std::uint16_t vendor_id = 0;  // of the USB device; 0 where it is unknown
    std::uint16_t product_id = 0;
    float left_x = 0.0F;  // sticks: -1 to 1, right and down positive
    float left_y = 0.0F;
    float right_x = 0.0F;
    float right_y = 0.0F;
    float left_trigger = 0.0F;  // triggers: 0 released, 1 pulled
    float right_trigger = 0.0F;
    std::uint32_t buttons = 0;

    [[nodiscard]] bool holds(Button button) const { return (buttons & button) != 0; }
};

}  // namespace onggi::window
