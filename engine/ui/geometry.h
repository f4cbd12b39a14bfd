// Rectangles on a screen. Any thread. x right, y down; the unit is the user's: u of a design or pixels.
#pragma once

#include <algorithm>

#include "engine/math/math.h"

namespace onggi::ui {

struct Rect {
    float x = 0.0F;
    float y = 0.0F;
    float width = 0.0F;
    float height = 0.0F;

    [[nodiscard]] constexpr float right() const { return x + width; }
    [[nodiscard]] constexpr float bottom() const { return y + height; }
    [[nodiscard]] constexpr vec2 centre() const { return {x + 0.5F * width, y + 0.5F * height}; }
    [[nodiscard]] constexpr bool contains(vec2 at) const {
        return at.x >= x && at.x < right() && at.y >= y && at.y < bottom();
    }
    [[nodiscard]] constexpr Rect grown(float by) const {
        return {x - by, y - by, width + 2.0F * by, height + 2.0F * by};
    }
    [[nodiscard]] constexpr Rect moved(vec2 by) const { return {x + by.x, y + by.y, width, height}; }
    [[nodiscard]] constexpr Rect scaled(float by) const { return {x * by, y * by, width * by, height * by}; }
    friend bool operator==(const Rect&, const Rect&) = default;
};

[[nodiscard]] constexpr Rect overlap(const Rect& a, const Rect& b) {
    const float x = std::max(a.x, b.x);
    const float y = std::max(a.y, b.y);
    return {x, y, std::max(0.0F, std::min(a.right(), b.right()) - x),
            std::max(0.0F, std::min(a.bottom(), b.bottom()) - y)};
}

}  // namespace onggi::ui
