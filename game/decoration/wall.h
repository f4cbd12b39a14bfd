// The outer wall that is drawn on, by the rows of the texture: how wide it is there, and how long it is along
// its outline. Any thread. mm.
#pragma once

#include <array>
#include <span>

#include "engine/math/math.h"
#include "game/decoration/texture.h"

namespace onggi::decoration {

struct Wall {
    float height_mm = 0.0F;
    std::array<float, kRows> round_mm{};  // circumference at the middle of each row
    std::array<float, kRows> along_mm{};  // from the foot along the outline, likewise

    [[nodiscard]] float row_of_height(
        float height_mm_above) const;  // with its fraction; 0.5 is a row's middle
    [[nodiscard]] float along_at(float height_mm_above) const;
    [[nodiscard]] float round_at_along(float along) const;
    // The first row whose middle lies so far along the outline, or kRows.
    [[nodiscard]] int row_from_along(float along) const;
    friend bool operator==(const Wall&, const Wall&) = default;
};

// Points (radius, height) with rising heights from the foot on; the marks of fingers in it are smoothed, as a
// brush goes over them. Precondition: two points at least and a height above 0.
[[nodiscard]] Wall wall_of(std::span<const vec2> outline);

}  // namespace onggi::decoration
