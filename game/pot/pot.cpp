#include "game/pot/pot.h"

namespace onggi::pot {

std::vector<vec2> outer_outline(const Pot& pot) {
    const auto height_mm = static_cast<float>(pot.height_mm);
    const float even_mm = height_mm / static_cast<float>(pot.ring_count());
    std::vector<vec2> outline{{pot.outer_mm.front(), 0.0F}};
    float below_mm = 0.0F;
    for (std::size_t ring = 0; ring < pot.outer_mm.size(); ++ring) {
        const float top_mm = pot.top_mm.empty() ? even_mm * static_cast<float>(ring + 1) : pot.top_mm[ring];
        outline.push_back({pot.outer_mm[ring], 0.5F * (below_mm + top_mm)});
        below_mm = top_mm;
    }
    outline.push_back({pot.outer_mm.back(), height_mm});
    return outline;
}

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
