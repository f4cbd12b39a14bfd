// Where on a pot's wall a finger points. Any thread; pure. mm.
#pragma once

#include <optional>

#include "engine/math/math.h"
#include "game/decoration/wall.h"

namespace onggi::decoration {

// A place of the wall.
struct WallPlace {
    double turns = 0.0;  // from the pot's direction 0, counter-clockwise from above; 0 to 1
    double height_mm = 0.0;
    double facing = 0.0;  // 1: it is seen straight on; 0: at the pot's edge
};

// The first place of the wall that a ray meets, of a pot that stands on y = 0 about the axis and has turned
// by so much: `turned` is (cos, sin) of it, counter-clockwise from above. The pot is drawn `scale` times as
// large as the wall says. Nothing: it misses the wall.
[[nodiscard]] std::optional<WallPlace> pick(const Wall& wall, double scale, const dvec2& turned,
                                            const dvec3& eye_mm, const dvec3& ray);

// Where a place of the wall is then; the way back.
[[nodiscard]] dvec3 place_of(const Wall& wall, double scale, const dvec2& turned, double turns,
                             double height_mm);

}  // namespace onggi::decoration
