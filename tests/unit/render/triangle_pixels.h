// The pixels that a triangle must cover: those whose centre lies inside.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "engine/render/pixels/picture_shapes.h"

namespace onggi::render {

constexpr std::uint32_t kUntouched = 0x12345678U;

// How far inside a triangle a point lies, px, if it goes clockwise in a picture whose y points down; below 0:
// outside.
inline float inside_px(const std::array<vec2, 3>& corners, vec2 point) {
    float least = 1e9F;
    for (std::size_t i = 0; i < 3; ++i) {
        const vec2 from = corners[i];
        const vec2 to = corners[(i + 1) % 3];
        least = std::min(least, shapes::area_of(from, to, point) / glm::length(to - from));
    }
    return least;
}

// Clockwise ones are drawn, the others, or both.
struct DrawnWays {
    bool clockwise = true;
    bool counter_clockwise = true;
};

// A picture whose width is not a multiple of the vector width.
class TrianglePixels : public ::testing::Test {
  protected:
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        return pixels_[static_cast<std::size_t>(y * kWidth + x)];
    }
    void clear() {
        std::fill(pixels_.begin(), pixels_.end(), kUntouched);
        std::fill(depth_.begin(), depth_.end(), 1.0F);
    }
    // Draws many triangles, each on a cleared picture: `draw` takes its corners. Returns the number of
    // covered pixels.
    template <typename Draw>
    int expect_those_inside(const DrawnWays& ways, Draw draw) {
        std::mt19937 random(5);
        std::uniform_real_distribution<float> place(-20.0F, 80.0F);
        int covered = 0;
        for (int round = 0; round < 300; ++round) {
            const std::array<vec2, 3> corners{vec2{place(random), place(random)},
                                              vec2{place(random), place(random)},
                                              vec2{place(random), place(random)}};
            const std::array<vec2, 3> back{corners[2], corners[1], corners[0]};
            clear();
            draw(corners);
            for (int y = 0; y < kHeight; ++y) {
                for (int x = 0; x < kWidth; ++x) {
                    const vec2 middle(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                    const float clockwise = inside_px(corners, middle);
                    const float counter = inside_px(back, middle);
                    if (std::min(std::abs(clockwise), std::abs(counter)) < 0.005F) continue;
                    const bool is_inside =
                        (ways.clockwise && clockwise > 0.0F) || (ways.counter_clockwise && counter > 0.0F);
                    EXPECT_EQ(at(x, y) != kUntouched, is_inside) << round << ": " << x << ", " << y;
                    if (HasFailure()) return covered;
                    covered += is_inside ? 1 : 0;
                }
            }
        }
        return covered;
    }

    // Draws on a cleared picture: whole, then in bands that each have memory up to their last row alone, the
    // lowest band first. `draw` takes the canvas.
    template <typename Draw>
    void expect_the_same_in_bands(Draw draw) {
        clear();
        draw(PictureCanvas{.size = {kWidth, kHeight}, .pixels = pixels_, .depth = depth_});
        const std::vector<std::uint32_t> pixels = pixels_;
        const std::vector<float> depth = depth_;
        EXPECT_GT(std::count(pixels.begin(), pixels.end(), kUntouched), 500);
        EXPECT_LT(std::count(pixels.begin(), pixels.end(), kUntouched), 1500);
        clear();
        for (const RowSpan rows : {RowSpan{25, kHeight}, RowSpan{24, 25}, RowSpan{7, 24}, RowSpan{0, 7}}) {
            const std::ptrdiff_t end = std::ptrdiff_t{rows.end} * kWidth;
            std::vector<std::uint32_t> own_pixels(pixels_.begin(), pixels_.begin() + end);
            std::vector<float> own_depth(depth_.begin(), depth_.begin() + end);
            draw(PictureCanvas{
                .size = {kWidth, kHeight}, .pixels = own_pixels, .depth = own_depth, .rows = rows});
            std::copy(own_pixels.begin(), own_pixels.end(), pixels_.begin());
            std::copy(own_depth.begin(), own_depth.end(), depth_.begin());
        }
        EXPECT_EQ(pixels_, pixels);
        EXPECT_EQ(depth_, depth);
    }

    static constexpr int kWidth = 61;
    static constexpr int kHeight = 43;
    std::vector<std::uint32_t> pixels_ =
        std::vector<std::uint32_t>(std::size_t{kWidth} * kHeight, kUntouched);
    std::vector<float> depth_ = std::vector<float>(std::size_t{kWidth} * kHeight, 1.0F);
};

}  // namespace onggi::render
