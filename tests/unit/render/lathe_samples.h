// Pots for the tests of the lathe: plain shapes with known results.
#pragma once

#include <vector>

#include "engine/render/shapes/lathe_mesh.h"

namespace onggi::render {

constexpr int kSectors = 64;

// A cylinder with a floor, in rings of equal height.
struct Cylinder {
    explicit Cylinder(float outer_mm = 50.0F, float wall_mm = 5.0F, float floor_mm = 10.0F,
                      float height_mm = 100.0F, int rings = 1000)
        : outer(static_cast<std::size_t>(rings), outer_mm) {
        for (int i = 0; i < rings; ++i) {
            const float bottom = static_cast<float>(i) * height_mm / static_cast<float>(rings);
            inner.push_back(bottom + 1e-3F < floor_mm ? 0.0F : outer_mm - wall_mm);
            top.push_back(static_cast<float>(i + 1) * height_mm / static_cast<float>(rings));
        }
    }
    [[nodiscard]] Lathe lathe(float rounding_mm = 4.0F) const {
        return {.radii_mm = outer, .inner_mm = inner, .top_mm = top, .edge_rounding_mm = rounding_mm};
    }
    [[nodiscard]] LatheProfile profile(float rounding_mm = 4.0F) const {
        LatheProfile built;
        build_profile(lathe(rounding_mm), built);
        return built;
    }

    std::vector<float> outer;
    std::vector<float> inner;
    std::vector<float> top;
};

inline LatheSamples samples_of(const LatheProfile& profile) {
    LatheSamples samples;
    sample_profile(profile, samples);
    return samples;
}

}  // namespace onggi::render
