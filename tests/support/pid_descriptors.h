// Report descriptors of force-feedback joysticks, written from public tables of their report layouts, for
// tests. Any thread. None is a capture: the byte offsets are the tables', the items around them are ours.
#pragma once

#include <cstdint>
#include <vector>

namespace onggi::testing {

// OpenFFBoard (1209:ffb0), two axes: 16-bit values up to 32767, directions up to 36000, control as a bit
// mask.
std::vector<std::uint8_t> open_ffboard_descriptor();
// VPforce Rhino (ffff:2055): report numbers above 100, values up to 4096, directions up to 255, control as an
// array in another order, the start delay last.
std::vector<std::uint8_t> rhino_descriptor();
// After the third layout, ArduinoJoystickWithFFBLibrary: 8-bit gain and direction, and the fields that some
// firmwares lack left out: start delay, parameter block offset, negative coefficient and saturation, dead
// band, and the Device Control collection around its list.
std::vector<std::uint8_t> sparse_descriptor();

}  // namespace onggi::testing
