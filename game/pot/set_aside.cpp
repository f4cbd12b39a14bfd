#include "game/pot/set_aside.h"

#include <algorithm>

namespace onggi::pot {

Section section_of(const Pot& pot) {
    constexpr std::size_t kPoints = 40;
    const std::vector<vec2> outline = outer_outline(pot);
    const std::size_t step = std::max<std::size_t>(1, outline.size() / kPoints);
    Section section;
    for (std::size_t i = 0; i + 1 < outline.size(); i += step)
        section.outside.push_back(outline[i]);
    section.outside.push_back(outline.back());
    const auto floor_mm = static_cast<float>(pot.floor_mm);
    if (!pot.can_be_hollow()) return section;
    // Edges of the rings lie between the outline's points; the first and the last of those are no ring's.
    for (std::size_t ring = pot.inner_mm.size(); ring > 0; ring -= std::min(ring, step)) {
        const float height_mm = outline[ring].y;
        if (pot.inner_mm[ring - 1] <= 0.0F || height_mm <= floor_mm) break;
        section.inside.emplace_back(pot.inner_mm[ring - 1],
                                    section.inside.empty() ? outline.back().y : height_mm);
    }
    if (section.inside.empty()) return section;
    section.inside.emplace_back(section.inside.back().x, floor_mm);
    section.inside.emplace_back(0.0F, floor_mm);
    return section;
}

Pot stacked(const Pot& lower, const Pot& upper, const vec2& shift_mm) {
    Pot both = lower;
    both.inner_mm.clear();
    both.dents_mm.clear();
    both.floor_mm = 0.0;
    both.height_mm = lower.height_mm + upper.height_mm;
    const auto on = static_cast<float>(lower.height_mm);
    const auto upper_mm = static_cast<float>(upper.height_mm);
    for (std::size_t ring = upper.outer_mm.size(); ring-- > 0;) {
        const float bottom_mm = ring > 0 ? upper.top_mm[ring - 1] : 0.0F;
        both.outer_mm.push_back(upper.outer_mm[ring]);
        both.top_mm.push_back(on + upper_mm - bottom_mm);
        const vec2 centre_mm = upper.centre_mm.empty() ? vec2(0.0F) : upper.centre_mm[ring];
        both.centre_mm.push_back(vec2(centre_mm.x, -centre_mm.y) + shift_mm);
        both.film.push_back(upper.film[ring]);
        both.liquidity.push_back(upper.liquidity[ring]);
        both.load_index.push_back(0.0F);
    }
    return both;
}

}  // namespace onggi::pot
