// Picking: the place on a pot's wall under a finger. Any thread; pure. mm.
#pragma once

#include <optional>

#include "engine/math/math.h"
#include "game/decoration/wall.h"

namespace onggi::decoration {

// A place on the wall.
struct WallPlace {
    double turns = 0.0;  // from the pot's direction 0, counter-clockwise from above; 0 to 1
    double height_mm = 0.0;
    double facing = 0.0;  // 1: seen straight on; 0: at the silhouette
};

// The first place of the wall on a ray. The pot stands on y = 0 about the axis, is turned by `turned` = (cos,
// sin), counter-clockwise from above, and is drawn `scale` times as large as the wall. Empty if the ray
// misses the wall.
[[nodiscard]] std::optional<WallPlace> pick(const Wall& wall, double scale, const dvec2& turned,
                                            const dvec3& eye_mm, const dvec3& ray);

// The inverse: the position of a place on the wall.
[[nodiscard]] dvec3 place_of(const Wall& wall, double scale, const dvec2& turned, double turns,
                             double height_mm);

}  // namespace onggi::decoration
