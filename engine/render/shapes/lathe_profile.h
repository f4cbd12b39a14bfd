// A lathe's outline in the half plane (r, y), with the solid on the left of its direction: up the outside
// from the base, over the rounded edge, then down the inside to the floor and in to the axis, or flat across
// the top of a solid one. Any thread; pure functions. mm.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "shaders/frame_data.h"

namespace onggi::render {

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

}  // namespace onggi::render
