// A picture of a film: a slope of colours under a square that moves.
#pragma once

#include <cmath>

#include "engine/asset/image.h"

namespace onggi::asset {

inline Image moving_square(int index, int width, int height) {
    Image image{.width = width, .height = height, .rgba = {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool in_square = std::abs(x - 8 - 3 * index) < 5 && std::abs(y - 15) < 5;
            image.rgba.push_back(static_cast<std::uint8_t>(in_square ? 230 : 4 * x));
            image.rgba.push_back(static_cast<std::uint8_t>(in_square ? 40 : 6 * y));
            image.rgba.push_back(static_cast<std::uint8_t>(in_square ? 20 : 90));
            image.rgba.push_back(255);
        }
    }
    return image;
}

}  // namespace onggi::asset
