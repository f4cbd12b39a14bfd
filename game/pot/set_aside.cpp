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
    // The outline's points are at the middles of the rings, except the first and the last.
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

namespace {

// Adds the rings of a pot, upside down, on top.
void add_turned_over(Pot& below, const Pot& pot, const vec2& shift_mm) {
    const auto on_mm = static_cast<float>(below.height_mm);
    const auto height_mm = static_cast<float>(pot.height_mm);
    for (std::size_t ring = pot.outer_mm.size(); ring-- > 0;) {
        const float bottom_mm = ring > 0 ? pot.top_mm[ring - 1] : 0.0F;
        below.outer_mm.push_back(pot.outer_mm[ring]);
        below.top_mm.push_back(on_mm + height_mm - bottom_mm);
        const vec2 centre_mm = pot.centre_mm.empty() ? vec2(0.0F) : pot.centre_mm[ring];
        below.centre_mm.push_back(vec2(centre_mm.x, -centre_mm.y) + shift_mm);
        below.film.push_back(pot.film[ring]);
        below.liquidity.push_back(pot.liquidity[ring]);
        below.load_index.push_back(0.0F);
    }
    below.height_mm += pot.height_mm;
}

}  // namespace

Pot turned_over(const Pot& pot) {
    Pot over{.body = pot.body, .stage = pot.stage};
    add_turned_over(over, pot, vec2(0.0F));
    return over;
}

Pot stacked(const Pot& lower, const Pot& upper, const vec2& shift_mm) {
    Pot both = lower;
    both.inner_mm.clear();
    both.dents_mm.clear();
    both.floor_mm = 0.0;
    add_turned_over(both, upper, shift_mm);
    return both;
}

}  // namespace onggi::pot
