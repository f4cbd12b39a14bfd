// A lathe's mesh: its outline, the light that passes it, the rows of vertices along it, and the vertices. Any
// thread; pure functions. mm, rad, pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/camera.h"
#include "engine/render/scene.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// The outline in the half plane (r, y), with the solid on the left of its direction: up the outside from the
// base, over the rounded edge, then down the inside to the floor and in to the axis, or flat across the top
// of a solid one.

struct ProfilePoint {
    float radius_mm = 0.0F;
    float y_mm = 0.0F;
    float along_mm = 0.0F;  // arc length from the base
    float ring = 0.0F;      // number of its ring; fractional between two rings
};

struct LatheProfile {
    // outside [0, edge), edge [edge, inside), inside [inside, floor), floor or top [floor, size). The first
    // and last points of the edge belong to the walls.
    std::vector<ProfilePoint> points;
    std::size_t edge = 0;
    std::size_t inside = 0;
    std::size_t floor = 0;
    bool hollow = false;
    float height_mm = 0.0F;
    float floor_mm = 0.0F;     // of the hollow; solid: the full height
    float rounding_mm = 0.0F;  // of the edge, as wide as there is room, up to the wanted rounding

    [[nodiscard]] bool empty() const { return points.empty(); }
    [[nodiscard]] float length_mm() const { return points.empty() ? 0.0F : points.back().along_mm; }
    [[nodiscard]] float foot_mm() const { return points.empty() ? 0.0F : points.front().radius_mm; }
};

constexpr int kQuarterSteps = 12;  // steps in each quarter of the edge's rounding

// Reuses the memory of `profile`. Rings without height or with NaN or infinite radii are skipped.
void build_profile(const Lathe& lathe, LatheProfile& profile);

// Radii of both faces at evenly spaced heights, for ray marching. Rays above the top hit nothing.
struct LatheSamples {
    static constexpr int kCount = shaders::kOutlineSamples;
    std::array<float, kCount> outer_mm{};
    std::array<float, kCount> inner_mm{};  // 0 where solid
    float per_mm = 0.0F;
    float height_mm = 0.0F;
    float floor_mm = 0.0F;

    [[nodiscard]] std::size_t at(float y_mm) const {
        const float sample = y_mm * per_mm;
        if (!(sample > 0.0F)) return 0;
        return sample < kCount - 1 ? static_cast<std::size_t>(sample) : kCount - 1;
    }
};
void sample_profile(const LatheProfile& profile, LatheSamples& samples);

// The outward normal (r, y) along the whole outline, as texels for the fragment shaders: -1 to 1 as 0 to
// 65535, r in the lower half of a word. footprint_mm: length of outline that one pixel covers; normals are
// averaged over it, so that grooves finer than a pixel fade instead of flickering.
using NormalTexels = std::array<std::uint32_t, shaders::kProfileTexels>;
void profile_normals(const LatheProfile& profile, float footprint_mm, NormalTexels& texels);

// Returns the coordinate in that texture of a position along the outline.
[[nodiscard]] float texture_place(const LatheProfile& profile, float along_mm);

// Returns the unit normal averaged over a span of the outline about a position.
[[nodiscard]] vec2 profile_normal(const LatheProfile& profile, float along_mm, float span_mm);

// How much light reaches each point of a turned shape past the shape itself: the sky as ambient occlusion,
// the key light as a soft shadow. Both depend only on the outline, not on the wheel's rotation, so the
// processor computes them per ring.

enum class LatheFace { kOuter, kInner };

// Returns the visible fraction of the sky for a point on the outside, 0 to 1, cosine-weighted for a vertical
// wall: the part between the outline's horizons above and below.
[[nodiscard]] float open_outside(const LatheSamples& samples, float radius_mm, float y_mm);

// Returns the fraction of the sky that an inside point sees through the mouth, 0 to 1, cosine-weighted about
// its normal (r, y); by a fixed set of rays.
[[nodiscard]] float open_inside(const LatheSamples& samples, float radius_mm, float y_mm, vec2 normal);

struct KeyRay {
    vec3 towards_light{0.0F, 1.0F, 0.0F};  // unit; only its height matters here
    float tangent = 0.05F;                 // of half the light's angular width
};

// The visible fraction of the key light at the points of a ring; it goes from 0 to 1 over the light's width.
// One entry per column, evenly spaced from the light's azimuth to the far side; a ring is symmetrical about
// the light.
constexpr int kKeyColumns = 25;
using KeyColumns = std::array<float, kKeyColumns>;
void key_columns(const LatheSamples& samples, LatheFace face, vec2 place, vec2 normal, const KeyRay& key,
                 KeyColumns& columns);

// The rows of vertices, and the values that are constant around each row.

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

// The vertices: rows turned about the axis and displaced by dents and off-centre rings, with the key light
// that reaches each vertex.

struct LatheMeshInput {
    const Lathe& lathe;
    const LatheProfile& profile;
    const LatheSamples& samples;
    const LatheRows& chosen;
    std::span<const shaders::RowData> rows;
};
// Each row has a vertex at each of the angles (seen_sectors() and even_sectors() in frame_build.h); the last
// vertex coincides with the first or is on the other side of a cut. Reuses the memory of `vertices`.
void fill_vertices(const LatheMeshInput& input, const DirectionalLight& key,
                   std::span<const float> angles_rad, std::vector<shaders::VertexData>& vertices);

// Maximum displacement of the wall by dents and centres.
[[nodiscard]] float largest_offset_mm(const Lathe& lathe);

}  // namespace onggi::render
