// The outer wall to draw on, by texture rows: its circumference, and its length along the outline. Any
// thread. mm.
#pragma once

#include <array>
#include <span>

#include "engine/math/math.h"
#include "game/decoration/texture.h"

namespace onggi::decoration {

struct Wall {
    float height_mm = 0.0F;
    std::array<float, kRows> round_mm{};  // circumference at the middle of each row
    std::array<float, kRows> along_mm{};  // length from the foot along the outline to the middle of each row

    [[nodiscard]] float row_of_height(
        float height_mm_above) const;  // row with its fraction; 0.5 is the middle of row 0
    [[nodiscard]] float along_at(float height_mm_above) const;
    [[nodiscard]] float round_at_along(float along) const;
    // The first row whose middle is at least that far along the outline, or kRows.
    [[nodiscard]] int row_from_along(float along) const;
    friend bool operator==(const Wall&, const Wall&) = default;
};

// Makes a wall from points (radius, height) with rising heights from the foot; throwing rings are smoothed
// out, as a brush passes over them. Precondition: at least two points and a height above 0.
[[nodiscard]] Wall wall_of(std::span<const vec2> outline);

}  // namespace onggi::decoration
