#include "game/decoration/wall.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace onggi::decoration {
namespace {

// Moving average over the rows; the end rows are repeated.
std::array<float, kRows> smoothed(const std::array<float, kRows>& from) {
    constexpr int kReach = 3;
    std::array<float, kRows> to{};
    for (int row = 0; row < kRows; ++row) {
        float sum = 0.0F;
        for (int k = -kReach; k <= kReach; ++k)
            sum += from[static_cast<std::size_t>(std::clamp(row + k, 0, kRows - 1))];
        to[static_cast<std::size_t>(row)] = sum / (2 * kReach + 1);
    }
    return to;
}

}  // namespace

Wall wall_of(std::span<const vec2> outline) {
    assert(outline.size() >= 2 && outline.back().y > 0.0F);
    Wall wall{.height_mm = outline.back().y};
    std::array<float, kRows> radius_mm{};
    std::size_t above = 1;
    const float step_mm = wall.height_mm / kRows;
    for (int row = 0; row < kRows; ++row) {
        const float y = (static_cast<float>(row) + 0.5F) * step_mm;
        while (above + 1 < outline.size() && outline[above].y < y)
            ++above;
        const vec2& low = outline[above - 1];
        const vec2& high = outline[above];
        const float rise = high.y - low.y;
        const float part = rise > 0.0F ? std::clamp((y - low.y) / rise, 0.0F, 1.0F) : 1.0F;
        radius_mm[static_cast<std::size_t>(row)] = low.x + part * (high.x - low.x);
    }
    radius_mm = smoothed(smoothed(radius_mm));
    constexpr float kLeastRoundMm = 1.0F;
    float along = 0.0F;
    float before = radius_mm[0];
    for (std::size_t row = 0; row < kRows; ++row) {
        const float across = radius_mm[row] - before;
        const float step = std::sqrt(across * across + step_mm * step_mm);
        along += row == 0 ? 0.5F * step_mm : step;
        before = radius_mm[row];
        wall.along_mm[row] = along;
        wall.round_mm[row] = std::max(kTurnF * radius_mm[row], kLeastRoundMm);
    }
    return wall;
}

float Wall::row_of_height(float height_mm_above) const {
    return height_mm_above / height_mm * kRows;
}

float Wall::along_at(float height_mm_above) const {
    const float row = std::clamp(row_of_height(height_mm_above) - 0.5F, 0.0F, kRows - 1.0F);
    const auto below = static_cast<std::size_t>(row);
    const std::size_t above = std::min<std::size_t>(below + 1, kRows - 1);
    return along_mm[below] + (row - static_cast<float>(below)) * (along_mm[above] - along_mm[below]);
}

int Wall::row_from_along(float along) const {
    return static_cast<int>(std::lower_bound(along_mm.begin(), along_mm.end(), along) - along_mm.begin());
}

float Wall::round_at_along(float along) const {
    return round_mm[static_cast<std::size_t>(std::min(row_from_along(along), kRows - 1))];
}

}  // namespace onggi::decoration
