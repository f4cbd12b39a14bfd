// How far two pictures are apart, in numbers and for the eye. Any thread.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/asset/image.h"

namespace onggi::support {

struct DifferingPixel {
    int x = 0;
    int y = 0;
    int delta = 0;  // of the channel that differs most, 0 to 255
    std::array<std::uint8_t, 4> expected{};
    std::array<std::uint8_t, 4> actual{};
};

// A pixel's delta is that of its most differing channel, alpha included, in steps of 1/255.
struct ImageDifference {
    double bad_fraction = 0.0;          // of pixels whose delta is above the limit
    double mean_delta = 0.0;            // over all pixels
    std::vector<DifferingPixel> worst;  // at most five, the worst first
};

// Precondition: same size, at least one pixel.
ImageDifference compare_images(const asset::Image& expected, const asset::Image& actual, int delta_limit);

// Sixteen times the difference of each colour, opaque: a delta of 1 is just visible. Same precondition.
asset::Image difference_image(const asset::Image& expected, const asset::Image& actual);

// For a log: each character stands for a tile and its largest delta; '.' is none. Same precondition.
std::string difference_map(const asset::Image& expected, const asset::Image& actual);

}  // namespace onggi::support
