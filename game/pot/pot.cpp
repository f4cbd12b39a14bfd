#include "game/pot/pot.h"

namespace onggi::pot {

Pot fired(Pot pot, clay::Firing stage) {
    const double scale = clay::shrunk_scale(pot.body, stage);
    const auto shrink = [&](float length) { return static_cast<float>(double{length} * scale); };
    pot.height_mm *= scale;
    pot.floor_mm *= scale;
    for (auto* lengths : {&pot.outer_mm, &pot.inner_mm, &pot.top_mm, &pot.dents_mm}) {
        for (float& length : *lengths)
            length = shrink(length);
    }
    for (vec2& centre : pot.centre_mm)
        centre = {shrink(centre.x), shrink(centre.y)};
    pot.stage = stage;
    return pot;
}

}  // namespace onggi::pot
