#include "engine/render/shapes/ring_lod.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::render {
namespace {

// The furthest element to which one chord from `from` keeps the tolerance. The chord's slope must lie within
// an interval that every element passed on the way narrows; an end point is good if its own slope is inside.
std::size_t end_of_chord(const LodFace& face, std::size_t from, float tolerance, std::size_t last,
                         float max_span) {
    float lowest = -std::numeric_limits<float>::infinity();
    float highest = std::numeric_limits<float>::infinity();
    std::size_t end = from + 1;
    for (std::size_t to = from + 1; to <= last; ++to) {
        const float run = face.places_mm.empty() ? static_cast<float>(to - from)
                                                 : face.places_mm[to] - face.places_mm[from];
        if (run > max_span && to > from + 1) break;
        const float fraction = 1.0F / std::max(run, 1e-6F);
        const float rise = face.radii_mm[to] - face.radii_mm[from];
        const float slope = rise * fraction;
        if (slope >= lowest && slope <= highest) end = to;
        lowest = std::max(lowest, (rise - tolerance) * fraction);
        highest = std::min(highest, (rise + tolerance) * fraction);
        if (lowest > highest) break;
    }
    return end;
}

// False as soon as there are more than `room`, which it takes from.
bool try_face(const LodFace& face, float tolerance, std::size_t max_step, float max_span, std::size_t& room,
              std::vector<std::uint32_t>& elements) {
    elements.clear();
    if (face.radii_mm.empty()) return true;
    const std::size_t top = face.radii_mm.size() - 1;
    for (std::size_t at = 0;;) {
        if (room == 0) return false;
        --room;
        elements.push_back(static_cast<std::uint32_t>(at));
        if (at >= top) return true;
        at = end_of_chord(face, at, tolerance, std::min(at + max_step, top), max_span);
    }
}

}  // namespace

std::vector<RingChoice> choose_face_rings(std::span<const LodFace> faces, const RingBudget& budget) {
    std::vector<RingChoice> choices(faces.size());
    std::size_t elements = 0;
    float span_mm = 0.0F;
    for (const LodFace& face : faces) {
        elements += face.radii_mm.size();
        if (!face.places_mm.empty()) span_mm += face.places_mm.back() - face.places_mm.front();
    }
    const auto cap = std::max(static_cast<std::size_t>(std::max(budget.max_rings, 0)),
                              2 * std::max<std::size_t>(faces.size(), 1));
    // Steps that alone need more rings than there may be could never be met.
    const std::size_t shared = std::max<std::size_t>(cap - faces.size(), 1);
    const std::size_t least_step = elements == 0 ? 1 : (elements - 1) / shared + 1;
    const std::size_t max_step = std::max(static_cast<std::size_t>(std::max(budget.max_step, 1)), least_step);
    const float max_span = std::max(budget.max_span_mm, 2.0F * span_mm / static_cast<float>(shared));

    std::vector<std::vector<std::uint32_t>> tried(faces.size());
    const auto try_all = [&](float tolerance) {
        std::size_t room = cap;
        for (std::size_t face = 0; face < faces.size(); ++face) {
            if (!try_face(faces[face], tolerance, max_step, max_span, room, tried[face])) return false;
        }
        for (std::size_t face = 0; face < faces.size(); ++face)
            choices[face] = {.elements = tried[face], .tolerance_mm = tolerance};
        return true;
    };
    float too_fine = 0.0F;
    float tolerance = budget.tolerance_mm;
    while (!try_all(tolerance)) {
        too_fine = tolerance;
        tolerance = std::max(tolerance * 2.0F, 1e-4F);
        if (!std::isfinite(tolerance)) return choices;  // radii that are not numbers are not drawn
    }
    if (too_fine > 0.0F) {
        // Between the last that failed and the first that passed; four halvings are within 6 % of the least.
        for (int halving = 0; halving < 4; ++halving) {
            const float middle = 0.5F * (too_fine + tolerance);
            (try_all(middle) ? tolerance : too_fine) = middle;
        }
    }
    return choices;
}

}  // namespace onggi::render
