// See unit_circle.h. Any thread.
#include "game/pot/unit_circle.h"

#include <cmath>

namespace onggi::pot {

std::vector<dvec2> unit_circle(int n) {
    // A step of 90 or of 30 degrees is known exactly; halving it leads to 360/n.
    dvec2 step = n % 3 == 0 ? dvec2(0.5 * std::sqrt(3.0), 0.5) : dvec2(0.0, 1.0);
    for (int parts = n % 3 == 0 ? 12 : 4; parts < n; parts *= 2) {
        const double cosine = std::sqrt(0.5 * (1.0 + step.x));
        step = dvec2(cosine, step.y / (2.0 * cosine));
    }
    const auto quarter = static_cast<std::size_t>(n) / 4;
    std::vector<dvec2> circle(static_cast<std::size_t>(n));
    circle[0] = dvec2(1.0, 0.0);
    for (std::size_t k = 1; k < quarter; ++k) {
        const dvec2 last = circle[k - 1];
        circle[k] = dvec2(last.x * step.x - last.y * step.y, last.x * step.y + last.y * step.x);
    }
    // Quarter turns are exact, so that opposite corners are, too.
    for (std::size_t k = quarter; k < circle.size(); ++k) {
        circle[k] = dvec2(-circle[k - quarter].y, circle[k - quarter].x);
    }
    return circle;
}

}  // namespace onggi::pot
