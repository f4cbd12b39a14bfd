// Which pixels a triangle must cover, whoever draws it: those whose middle lies inside.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

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

// Draws many triangles, each on an untouched picture: `draw` takes its corners, `is_drawn` a pixel. Says how
// many pixels were covered.
template <typename Draw, typename IsDrawn>
int expect_those_inside(const PictureSize& size, const DrawnWays& ways, Draw draw, IsDrawn is_drawn) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-20.0F, 80.0F);
    int covered = 0;
    for (int round = 0; round < 300; ++round) {
        const std::array<vec2, 3> at{vec2(place(random), place(random)), vec2(place(random), place(random)),
                                     vec2(place(random), place(random))};
        const std::array<vec2, 3> back{at[2], at[1], at[0]};
        draw(at);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const vec2 middle(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                const float clockwise = inside_px(at, middle);
                const float counter = inside_px(back, middle);
                if (std::min(std::abs(clockwise), std::abs(counter)) < 0.005F) continue;
                const bool is_inside =
                    (ways.clockwise && clockwise > 0.0F) || (ways.counter_clockwise && counter > 0.0F);
                EXPECT_EQ(is_drawn(x, y), is_inside) << round << ": " << x << ", " << y;
                if (testing::Test::HasFailure()) return covered;
                covered += is_inside ? 1 : 0;
            }
        }
    }
    return covered;
}

}  // namespace onggi::render
