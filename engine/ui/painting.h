// A painted picture in memory, on its way to the atlas. Any thread; immutable once made.
#pragma once

#include <cstdint>
#include <vector>

namespace onggi::ui {

// Rows from the top, four bytes per pixel: red, green, blue (sRGB-encoded, premultiplied), alpha.
struct Painting {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

}  // namespace onggi::ui
