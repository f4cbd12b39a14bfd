// A painted picture in memory, on its way to the atlas. Any thread; not changed once made.
#pragma once

#include <cstdint>
#include <vector>

namespace onggi::ui {

// Rows from the top, four bytes a pixel: red, green, blue (sRGB-encoded, already multiplied by alpha), alpha.
struct Painting {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

}  // namespace onggi::ui
