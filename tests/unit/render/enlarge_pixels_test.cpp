#include "engine/render/pixels/enlarge_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace onggi::render {
namespace {

std::uint32_t channel(std::uint32_t pixel, unsigned number) {
    return pixel >> (8U * number) & 255U;
}

// Of the four pixels about the place, as a picture that is stretched has it.
double stretched(const std::vector<std::uint32_t>& from, int width, int height, int x, int y,
                 unsigned number) {
    const auto at = [&](int column, int row) {
        const int inside_x = std::clamp(column, 0, half_of(width) - 1);
        const int inside_y = std::clamp(row, 0, half_of(height) - 1);
        const auto place = static_cast<std::size_t>(inside_y * half_of(width) + inside_x);
        return static_cast<double>(channel(from[place], number));
    };
    const double u = (x + 0.5) / 2.0 - 0.5;
    const double v = (y + 0.5) / 2.0 - 0.5;
    const int left = static_cast<int>(std::floor(u));
    const int top = static_cast<int>(std::floor(v));
    const double right = u - left;
    const double below = v - top;
    return (at(left, top) * (1.0 - right) + at(left + 1, top) * right) * (1.0 - below) +
           (at(left, top + 1) * (1.0 - right) + at(left + 1, top + 1) * right) * below;
}

TEST(EnlargedPixels, AreBilinearToTheBorderOfEverySize) {
    for (const int width : {1, 2, 3, 17, 40, 41}) {
        for (const int height : {1, 2, 5, 6}) {
            std::vector<std::uint32_t> from;
            std::uint32_t random = 7;
            for (int i = 0; i < half_of(width) * half_of(height); ++i) {
                random = random * 1664525U + 1013904223U;
                from.push_back(random);
            }
            std::vector<std::uint32_t> into(static_cast<std::size_t>(width * height) + 1, 0xDEADBEEFU);
            enlarge_pixels(from, width, height, into);
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    const std::uint32_t pixel = into[static_cast<std::size_t>(y * width + x)];
                    // Rounded once down the picture and once across it.
                    for (unsigned number = 0; number < 4; ++number)
                        ASSERT_NEAR(channel(pixel, number), stretched(from, width, height, x, y, number),
                                    1.01)
                            << x << ", " << y << " of " << width << " x " << height;
                }
            }
            EXPECT_EQ(into.back(), 0xDEADBEEFU) << "beyond the picture";
        }
    }
}

TEST(EnlargedPixels, OfOneColourAreThatColour) {
    const std::vector<std::uint32_t> from(6, 0xFF13FE01U);
    std::vector<std::uint32_t> into(5 * 4);
    enlarge_pixels(from, 5, 4, into);
    EXPECT_EQ(into, std::vector<std::uint32_t>(5 * 4, 0xFF13FE01U));
}

TEST(EnlargedDepth, IsThatOfThePixelItLiesIn) {
    const std::vector<float> from{0.1F, 0.2F, 0.3F, 0.4F};
    std::vector<float> into(3 * 4);
    enlarge_depth(from, 3, 4, into);
    EXPECT_EQ(into,
              (std::vector<float>{0.1F, 0.1F, 0.2F, 0.1F, 0.1F, 0.2F, 0.3F, 0.3F, 0.4F, 0.3F, 0.3F, 0.4F}));
}

}  // namespace
}  // namespace onggi::render
