#include "engine/render/ring_lod.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::render {
namespace {

// The furthest element to which one chord from `from` keeps the tolerance. The chord's slope must lie within
// an interval that every element passed on the way narrows; an end point is good if its own slope is inside.
std::size_t end_of_chord(std::span<const float> radii, std::size_t from, float tolerance, std::size_t last) {
    float lowest = -std::numeric_limits<float>::infinity();
    float highest = std::numeric_limits<float>::infinity();
    std::size_t end = from + 1;
    for (std::size_t to = from + 1; to <= last; ++to) {
        const auto run = static_cast<float>(to - from);
        const float rise = radii[to] - radii[from];
        const float slope = rise / run;
        if (slope >= lowest && slope <= highest) end = to;
        lowest = std::max(lowest, (rise - tolerance) / run);
        highest = std::min(highest, (rise + tolerance) / run);
        if (lowest > highest) break;
    }
    return end;
}

// False as soon as there are more than the cap.
bool try_rings(std::span<const float> radii, float tolerance, int max_rings, std::size_t max_step,
               std::vector<std::uint32_t>& elements) {
    elements.assign(1, 0);
    const std::size_t top = radii.size() - 1;
    for (std::size_t at = 0; at < top;) {
        at = end_of_chord(radii, at, tolerance, std::min(at + max_step, top));
        if (elements.size() == static_cast<std::size_t>(max_rings)) return false;
        elements.push_back(static_cast<std::uint32_t>(at));
    }
    return true;
}

}  // namespace

RingChoice choose_rings(std::span<const float> radii_mm, const RingBudget& budget) {
    RingChoice choice;
    if (radii_mm.empty()) return choice;
    const int max_rings = std::max(budget.max_rings, 2);
    // A step that alone needs more rings than there may be could never be met.
    const std::size_t least_step = (radii_mm.size() - 1) / static_cast<std::size_t>(max_rings - 1) + 1;
    const std::size_t max_step = std::max(static_cast<std::size_t>(std::max(budget.max_step, 1)), least_step);

    float too_fine = 0.0F;
    float tolerance = budget.tolerance_mm;
    while (!try_rings(radii_mm, tolerance, max_rings, max_step, choice.elements)) {
        too_fine = tolerance;
        tolerance = std::max(tolerance * 2.0F, 1e-4F);
        if (!std::isfinite(tolerance)) break;  // radii that are not numbers: what was found so far is drawn
    }
    if (too_fine > 0.0F) {
        // Between the last that failed and the first that passed; four halvings are within 6 % of the least.
        std::vector<std::uint32_t> finer;
        for (int halving = 0; halving < 4; ++halving) {
            const float middle = 0.5F * (too_fine + tolerance);
            if (try_rings(radii_mm, middle, max_rings, max_step, finer)) {
                tolerance = middle;
                choice.elements.swap(finer);
            } else {
                too_fine = middle;
            }
        }
    }
    choice.tolerance_mm = tolerance;
    return choice;
}

float ring_error_mm(std::span<const float> radii_mm, std::span<const std::uint32_t> elements) {
    float worst = 0.0F;
    for (std::size_t ring = 1; ring < elements.size(); ++ring) {
        const std::uint32_t below = elements[ring - 1];
        const std::uint32_t above = elements[ring];
        for (std::uint32_t i = below; i <= above; ++i) {
            const float share = static_cast<float>(i - below) / static_cast<float>(above - below);
            const float chord = radii_mm[below] + share * (radii_mm[above] - radii_mm[below]);
            worst = std::max(worst, std::abs(radii_mm[i] - chord));
        }
    }
    return worst;
}

}  // namespace onggi::render
