// A lathe's outline in the half plane (r, y), walked with the solid on its left hand: up the outside from the
// base, over the rounded edge, and down the inside to the floor and in to the axis, or flat across the top of
// a solid one. Any thread; pure functions. mm.
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
    float along_mm = 0.0F;  // of the outline, from the base
    float ring = 0.0F;      // whose it is; between two, their fraction
};

struct LatheProfile {
    // outside [0, edge), edge [edge, inside), inside [inside, floor), floor or top [floor, size). The edge's
    // first and last points belong to the walls.
    std::vector<ProfilePoint> points;
    std::size_t edge = 0;
    std::size_t inside = 0;
    std::size_t floor = 0;
    bool hollow = false;
    float height_mm = 0.0F;
    float floor_mm = 0.0F;     // of the hollow; the height of a solid one
    float rounding_mm = 0.0F;  // of the edge: what there is room for, at most the wanted one

    [[nodiscard]] bool empty() const { return points.empty(); }
    [[nodiscard]] float length_mm() const { return points.empty() ? 0.0F : points.back().along_mm; }
    [[nodiscard]] float foot_mm() const { return points.empty() ? 0.0F : points.front().radius_mm; }
};

constexpr int kQuarterSteps = 12;  // of the edge's rounding

// Into `profile`, whose memory is used again. Rings of no height or with radii that are not numbers are drawn
// as if they were not there.
void build_profile(const Lathe& lathe, LatheProfile& profile);

// Both faces by height, evenly: what rays are walked against. Above the top nothing is met.
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

// The outward normal (r, y) along the whole outline, for the texels that fragments read: -1 to 1 as 0 to
// 65535, r in the lower half of a word. footprint_mm: how much of the outline one pixel shows; slopes are
// averaged over it, so that grooves finer than a pixel fade instead of flickering.
using NormalTexels = std::array<std::uint32_t, shaders::kProfileTexels>;
void profile_normals(const LatheProfile& profile, float footprint_mm, NormalTexels& texels);

// Where a place along the outline lies in that texture.
[[nodiscard]] float texture_place(const LatheProfile& profile, float along_mm);

// The normal over some span of the outline about a place, as a unit vector.
[[nodiscard]] vec2 profile_normal(const LatheProfile& profile, float along_mm, float span_mm);

}  // namespace onggi::render
