// Which of a lathe's many elements are worth a ring of vertices. Any thread; pure functions. mm.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace onggi::render {

struct RingBudget {
    float tolerance_mm = 0.05F;  // wanted: no element's radius is drawn further off than this
    int max_rings = 128;         // hard; at least 2
    int max_step = 100;          // elements between two rings, so that light interpolates over short spans
    float max_span_mm = 1e9F;    // the same as a length, where elements have places of their own
};

// One face of a lathe: an element's radius, and its place along the axis, rising. Without places the elements
// lie 1 apart.
struct LodFace {
    std::span<const float> radii_mm{};
    std::span<const float> places_mm{};
};

struct RingChoice {
    std::vector<std::uint32_t> elements;  // ascending; the first and the last element are always there
    float tolerance_mm = 0.0F;  // that which met the cap: the wanted one, or the least found above it
};

// Greedy, from the bottom: from each ring on, the longest chord that stays within the tolerance of every
// radius under it. Where that gives more rings than the cap allows (a rough one has no end of detail), the
// tolerance is relaxed until it does not, and max_step with it if it alone asks for too many.
// Linear in the number of elements for each of at most some twenty tolerances, most of which stop early.
// Several faces are under one cap, with the same tolerance for all of them. One entry a face; an empty face
// has none of the rings.
[[nodiscard]] std::vector<RingChoice> choose_face_rings(std::span<const LodFace> faces,
                                                        const RingBudget& budget);

}  // namespace onggi::render
