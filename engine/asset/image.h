// A picture in memory. Any thread; plain data.
#pragma once

#include <cstdint>
#include <vector>

namespace onggi::asset {

// Eight bits a channel, sRGB, rows from the top, width x height x 4 bytes (red, green, blue, alpha).
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

}  // namespace onggi::asset
