// See image_compare.h. Any thread.
#include "tests/support/image_compare.h"

#include <algorithm>
#include <cstdlib>

namespace onggi::support {
namespace {

using asset::Image;

constexpr std::size_t kChannels = 4;
constexpr std::size_t kWorstListed = 5;

std::size_t pixel_at(const Image& image, int x, int y) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(x)) *
           kChannels;
}

int pixel_delta(const Image& a, const Image& b, std::size_t at) {
    int delta = 0;
    for (std::size_t c = 0; c < kChannels; ++c) {
        delta = std::max(delta, std::abs(int{a.rgba[at + c]} - int{b.rgba[at + c]}));
    }
    return delta;
}

std::array<std::uint8_t, 4> colour_at(const Image& image, std::size_t at) {
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

template <typename Visit>
void for_each_pixel(const Image& image, Visit visit) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x)
            visit(x, y, pixel_at(image, x, y));
    }
}

}  // namespace

ImageDifference compare_images(const Image& expected, const Image& actual, int delta_limit) {
    std::int64_t sum = 0;
    std::int64_t bad = 0;
    std::vector<DifferingPixel> worst;
    for_each_pixel(expected, [&](int x, int y, std::size_t at) {
        const int delta = pixel_delta(expected, actual, at);
        sum += delta;
        bad += delta > delta_limit ? 1 : 0;
        if (delta == 0 || (worst.size() == kWorstListed && delta <= worst.back().delta)) return;
        const DifferingPixel pixel{x, y, delta, colour_at(expected, at), colour_at(actual, at)};
        const auto place = std::upper_bound(worst.begin(), worst.end(), pixel,
                                            [](const auto& a, const auto& b) { return a.delta > b.delta; });
        worst.insert(place, pixel);
        if (worst.size() > kWorstListed) worst.pop_back();
    });
    const double pixels = static_cast<double>(expected.rgba.size() / kChannels);
    return {static_cast<double>(bad) / pixels, static_cast<double>(sum) / pixels, std::move(worst)};
}

Image difference_image(const Image& expected, const Image& actual) {
    constexpr int kGain = 16;
    Image image{expected.width, expected.height, std::vector<std::uint8_t>(expected.rgba.size(), 255)};
    for_each_pixel(expected, [&](int, int, std::size_t at) {
        for (std::size_t c = 0; c < 3; ++c) {
            const int delta = std::abs(int{expected.rgba[at + c]} - int{actual.rgba[at + c]});
            image.rgba[at + c] = static_cast<std::uint8_t>(std::min(255, kGain * delta));
        }
    });
    return image;
}

std::string difference_map(const Image& expected, const Image& actual) {
    constexpr int kColumns = 64;
    constexpr int kRows = 24;
    const int columns = std::min(kColumns, expected.width);
    const int rows = std::min(kRows, expected.height);
    std::vector<int> tiles(static_cast<std::size_t>(columns * rows), 0);
    for_each_pixel(expected, [&](int x, int y, std::size_t at) {
        const int tile = (y * rows / expected.height) * columns + x * columns / expected.width;
        int& largest = tiles[static_cast<std::size_t>(tile)];
        largest = std::max(largest, pixel_delta(expected, actual, at));
    });
    // Steps of doubling deltas: 1, 2, 3 to 4, 5 to 8, ... 129 and above.
    constexpr std::string_view kMarks = ".:-=+*o#%@";
    std::string map;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        std::size_t mark = tiles[i] == 0 ? 0 : 1;
        for (int limit = 1; mark + 1 < kMarks.size() && tiles[i] > limit; limit *= 2)
            ++mark;
        map += kMarks[mark];
        if ((i + 1) % static_cast<std::size_t>(columns) == 0) map += '\n';
    }
    return map;
}

}  // namespace onggi::support
