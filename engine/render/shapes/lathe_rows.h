// Chooses a lathe's rows of vertices, and computes the values that are constant around each row. Any thread;
// pure functions. mm, pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/camera.h"
#include "engine/render/shapes/lathe_light.h"
#include "engine/render/shapes/lathe_profile.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// Limits for choosing rings of vertices from a lathe's many elements. mm.
struct RingBudget {
    float tolerance_mm = 0.05F;  // wanted maximum error of any element's radius
    int max_rings = 128;         // hard cap; at least 2
    // Maximum elements between two rings, so that light is interpolated over short spans.
    int max_step = 100;
    float max_span_mm = 1e9F;  // the same as a length, for elements with explicit places
};

// One face of a lathe: the radius of each element and its place along the axis, ascending. Without places,
// elements are 1 apart.
struct LodFace {
    std::span<const float> radii_mm{};
    std::span<const float> places_mm{};
};

struct RingChoice {
    std::vector<std::uint32_t> elements;  // ascending; always includes the first and the last element
    // The wanted tolerance, or the smallest larger one that was found to meet the cap.
    float tolerance_mm = 0.0F;
};

// Greedy, from the bottom: each chord is the longest within the tolerance of every radius under it. If that
// exceeds the cap (a rough face has unlimited detail), the tolerance is relaxed until it fits; max_step is
// relaxed too if it alone requires too many rings. Linear in the number of elements for each of about twenty
// tolerances at most; most attempts stop early. All faces share one cap and one tolerance. Returns one entry
// per face; an empty face has no rings.
[[nodiscard]] std::vector<RingChoice> choose_face_rings(std::span<const LodFace> faces,
                                                        const RingBudget& budget);

struct RowBudget {
    float tolerance_mm = 0.05F;  // wanted maximum distance of a ring from the drawn outline
    int max_rows = 128;          // hard cap on all rows together
    int edge_stride = 3;         // takes every edge_stride-th point of the rounded edge
    float max_span_mm = 9.0F;    // between two rows of a wall, so that light is interpolated over short spans
};

struct LatheRows {
    std::vector<std::uint32_t> points;  // indices of the profile's points, in order
    std::size_t inside = 0;             // rows from here on are on the inner face or on a solid's top
    float tolerance_mm = 0.0F;          // the tolerance that met the cap
};

// Returns how many of the profile's points, from the first, must be drawn for the part of the inside that the
// eye can see: all if the floor is visible; no inside points if the eye is below the rim. slack_mm: how far
// dents and an off-centre throw may move the occluders.
[[nodiscard]] std::size_t points_seen(const LatheProfile& profile, vec3 eye_mm, float slack_mm);

[[nodiscard]] LatheRows choose_rows(const LatheProfile& profile, std::size_t seen, const RowBudget& budget);

// Computes light and water of each row. Reuses the memory of `rows`.
void fill_rows(const Lathe& lathe, const LatheProfile& profile, const LatheSamples& samples,
               const LatheRows& chosen, std::vector<shaders::RowData>& rows);

}  // namespace onggi::render
