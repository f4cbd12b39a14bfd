#include "engine/render/shapes/detail_texture.h"

#include <algorithm>

#include "engine/math/eight_bits.h"

namespace onggi::render {
namespace {

constexpr int kSize = kDetailTexels;

float hashed(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t h = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ seed * 0xC2B2AE3DU;
    h = (h ^ (h >> 15)) * 0x2C1B3C6DU;
    h = (h ^ (h >> 12)) * 0x297A2D39U;
    return static_cast<float>((h ^ (h >> 15)) >> 8) * (1.0F / 16777216.0F);
}

// Smooth noise with `across` x `up` cells; it tiles with the texture.
float noise(int x, int y, std::uint32_t across, std::uint32_t up, std::uint32_t seed) {
    const float fx = static_cast<float>(x) * static_cast<float>(across) / kSize;
    const float fy = static_cast<float>(y) * static_cast<float>(up) / kSize;
    const auto ix = static_cast<std::uint32_t>(fx);
    const auto iy = static_cast<std::uint32_t>(fy);
    float tx = fx - static_cast<float>(ix);
    float ty = fy - static_cast<float>(iy);
    tx = tx * tx * (3.0F - 2.0F * tx);
    ty = ty * ty * (3.0F - 2.0F * ty);
    const auto at = [&](std::uint32_t dx, std::uint32_t dy) {
        return hashed((ix + dx) % across, (iy + dy) % up, seed);
    };
    const float low = at(0, 0) + tx * (at(1, 0) - at(0, 0));
    const float high = at(0, 1) + tx * (at(1, 1) - at(0, 1));
    return low + ty * (high - low);
}

// Height of the streaks, about -0.5 to 0.5. The texture spans 67 mm of the pot's height, about 120 pixels of
// a 720-line picture; detail below a millimetre would flicker as the pot turns.
float streaks(int x, int y) {
    const float streaks =
        0.46F * noise(x, y, 3, 18, 1) + 0.32F * noise(x, y, 5, 40, 2) + 0.16F * noise(x, y, 11, 64, 3);
    const float grain = 0.06F * noise(x, y, 150, 64, 4);
    return streaks + grain - 0.5F;
}

std::vector<std::uint8_t> made_texture() {
    std::vector<float> heights(static_cast<std::size_t>(kSize) * kSize);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x)
            heights[static_cast<std::size_t>(y * kSize + x)] = streaks(x, y);
    }
    const auto height = [&](int x, int y) {
        return heights[static_cast<std::size_t>(((y + kSize) % kSize) * kSize + (x + kSize) % kSize)];
    };
    std::vector<std::uint8_t> texels;
    texels.reserve(heights.size() * 4);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const float pit = noise(x, y, 83, 44, 9) > 0.93F ? 0.25F : 0.0F;
            const float lean_round = height(x + 1, y) - height(x - 1, y);
            const float lean_up = height(x, y - 1) - height(x, y + 1);
            texels.push_back(eight_bits(0.5F + 0.8F * height(x, y) - pit));
            texels.push_back(eight_bits(0.5F + 3.5F * lean_round));
            texels.push_back(eight_bits(0.5F + 4.5F * lean_up));
            texels.push_back(eight_bits(0.5F + 1.1F * (noise(x, y, 4, 24, 6) - 0.5F) - 0.5F * height(x, y)));
        }
    }
    return texels;
}

}  // namespace

const std::vector<std::uint8_t>& detail_texture() {
    static const std::vector<std::uint8_t> texels = made_texture();
    return texels;
}

std::vector<std::uint8_t> coarser_detail(std::span<const std::uint8_t> texels, int across, int up) {
    const int width = kSize / across;
    const int height = kSize / up;
    const int count = width * height;
    std::vector<std::uint8_t> coarse;
    coarse.reserve(static_cast<std::size_t>(4 * across * up));
    for (int y = 0; y < up; ++y) {
        for (int x = 0; x < across; ++x) {
            for (int channel = 0; channel < 4; ++channel) {
                int sum = 0;
                for (int i = 0; i < count; ++i) {
                    const int at = (y * height + i / width) * kSize + x * width + i % width;
                    sum += texels[static_cast<std::size_t>(4 * at + channel)];
                }
                coarse.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
            }
        }
    }
    return coarse;
}

std::vector<std::uint8_t> streak_levels(std::span<const std::uint8_t> texels, int across, int up) {
    const auto at = [&](int x, int y, int channel) {
        return static_cast<std::size_t>(4 * ((y + up) % up * across + x) + channel);
    };
    std::vector<std::uint8_t> levels;
    levels.reserve(kStreakLevels * texels.size());
    for (int level = 0; level < kStreakLevels; ++level) {
        const int count = std::min(1 << level, up);
        for (int y = 0; y < up; ++y) {
            for (int x = 0; x < across; ++x) {
                for (int channel = 0; channel < 4; ++channel) {
                    int sum = 0;
                    for (int i = 0; i < count; ++i)
                        sum += texels[at(x, y + i - count / 2, channel)];
                    levels.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
                }
            }
        }
    }
    return levels;
}

}  // namespace onggi::render
