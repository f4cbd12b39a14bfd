#include "game/pot/pot.h"

#include <algorithm>

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

std::size_t ring_at(const Pot& pot, double y_mm) {
    const std::size_t count = pot.outer_mm.size();
    if (count == 0) return 0;
    std::size_t ring = 0;
    if (pot.top_mm.size() == count) {
        const auto above = std::upper_bound(pot.top_mm.begin(), pot.top_mm.end(), static_cast<float>(y_mm));
        ring = static_cast<std::size_t>(above - pot.top_mm.begin());
    } else {
        const double fraction = std::clamp(y_mm / std::max(pot.height_mm, 1e-6), 0.0, 1.0);
        ring = static_cast<std::size_t>(fraction * static_cast<double>(count));
    }
    return std::min(ring, count - 1);
}

Wall wall_at(const Pot& pot, double y_mm) {
    if (pot.outer_mm.empty() || y_mm < 0.0 || y_mm >= pot.height_mm) return {};
    const std::size_t ring = ring_at(pot, y_mm);
    return {double{pot.outer_mm[ring]}, pot.inner_mm.empty() ? 0.0 : double{pot.inner_mm[ring]}};
}

Wall rim_of(const Pot& pot) {
    constexpr double kWithinMm = 0.5;
    return wall_at(pot, std::max(0.0, pot.height_mm - kWithinMm));
}

bool is_solid(const Pot& pot) {
    constexpr double kSolidMm = 8.0;  // a hollow up to this depth does not count
    return pot.floor_mm > pot.height_mm - kSolidMm;
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
