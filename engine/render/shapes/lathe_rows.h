// Which rows of vertices a lathe is drawn with, and what is the same all the way round each. Any thread; pure
// functions. mm, pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/camera.h"
#include "engine/render/shapes/lathe_light.h"
#include "engine/render/shapes/lathe_profile.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// Which of a lathe's many elements are worth a ring of vertices. mm.
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

struct RowBudget {
    float tolerance_mm = 0.05F;  // wanted: no ring lies further from the drawn outline than this
    int max_rows = 128;          // hard, everything counted
    int edge_stride = 3;         // of the rounded edge's points
    float max_span_mm = 9.0F;    // between two rows of a wall, so that light interpolates over short spans
};

struct LatheRows {
    std::vector<std::uint32_t> points;  // of the profile, in its order
    std::size_t inside = 0;             // rows from here on are on the inner face, or the top of a solid
    float tolerance_mm = 0.0F;          // the one that met the cap
};

// How much of the inside an eye can see: the number of the profile's points, from its first, that must be
// drawn. All of them if the floor shows; none of the inside if the eye lies below the rim.
// slack_mm: how far dents and a pot off its centre may move what hides.
[[nodiscard]] std::size_t points_seen(const LatheProfile& profile, vec3 eye_mm, float slack_mm);

[[nodiscard]] LatheRows choose_rows(const LatheProfile& profile, std::size_t seen, const RowBudget& budget);

// What light and water make of each row. `rows` is used again.
void fill_rows(const Lathe& lathe, const LatheProfile& profile, const LatheSamples& samples,
               const LatheRows& chosen, std::vector<shaders::RowData>& rows);

}  // namespace onggi::render
