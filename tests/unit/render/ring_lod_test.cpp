#include "engine/render/shapes/lathe_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace onggi::render {
namespace {

std::vector<float> wall(int count, float (*radius)(int)) {
    std::vector<float> radii;
    for (int i = 0; i < count; ++i)
        radii.push_back(radius(i));
    return radii;
}

float grooved(int i) {
    return 50.0F + 2.0F * std::sin(static_cast<float>(i) * 0.05F);
}

// Without libm's help the same on every machine; about 1 mm up and down.
float rough(int i) {
    const auto h = (static_cast<std::uint32_t>(i) * 2654435761U) >> 16U;
    return 50.0F + static_cast<float>(h % 2000U) * 0.001F;
}

RingChoice choose_rings(std::span<const float> radii_mm, const RingBudget& budget) {
    const LodFace face{.radii_mm = radii_mm};
    return choose_face_rings(std::span(&face, 1), budget).front();
}

// The largest |radius - chord| over all elements, mm: what the tolerance bounds.
float ring_error_mm(std::span<const float> radii_mm, std::span<const std::uint32_t> elements) {
    float worst = 0.0F;
    for (std::size_t ring = 1; ring < elements.size(); ++ring) {
        const std::uint32_t below = elements[ring - 1];
        const std::uint32_t above = elements[ring];
        for (std::uint32_t i = below; i <= above; ++i) {
            const float fraction = static_cast<float>(i - below) / static_cast<float>(above - below);
            const float chord = radii_mm[below] + fraction * (radii_mm[above] - radii_mm[below]);
            worst = std::max(worst, std::abs(radii_mm[i] - chord));
        }
    }
    return worst;
}

TEST(RingLod, DrawsAStraightWallWithItsTwoEnds) {
    const auto radii = wall(2000, [](int) { return 60.0F; });
    const RingChoice choice =
        choose_rings(radii, {.tolerance_mm = 0.05F, .max_rings = 128, .max_step = 5000});
    EXPECT_EQ(choice.elements, (std::vector<std::uint32_t>{0, 1999}));
    EXPECT_EQ(choice.tolerance_mm, 0.05F);
}

TEST(RingLod, PutsRingsExactlyAtTheCornersOfAStep) {
    const auto radii = wall(100, [](int i) { return i < 40 ? 60.0F : 30.0F; });
    const RingChoice choice =
        choose_rings(radii, {.tolerance_mm = 0.01F, .max_rings = 128, .max_step = 5000});
    EXPECT_EQ(choice.elements, (std::vector<std::uint32_t>{0, 39, 40, 99}));
    EXPECT_EQ(ring_error_mm(radii, choice.elements), 0.0F);
}

TEST(RingLod, KeepsItsErrorBoundAtEveryElement) {
    const auto radii = wall(2000, grooved);
    for (const float tolerance : {0.01F, 0.05F, 0.2F, 1.0F}) {
        const RingChoice choice =
            choose_rings(radii, {.tolerance_mm = tolerance, .max_rings = 2000, .max_step = 5000});
        EXPECT_EQ(choice.tolerance_mm, tolerance);
        EXPECT_LE(ring_error_mm(radii, choice.elements), tolerance * 1.001F);
        EXPECT_LT(choice.elements.size(), 500U);
    }
}

TEST(RingLod, NeedsFewerRingsForACoarserTolerance) {
    const auto radii = wall(2000, grooved);
    std::size_t before = std::numeric_limits<std::size_t>::max();
    for (const float tolerance : {0.01F, 0.05F, 0.2F, 1.0F}) {
        const std::size_t rings =
            choose_rings(radii, {.tolerance_mm = tolerance, .max_rings = 2000, .max_step = 5000})
                .elements.size();
        EXPECT_LT(rings, before);
        before = rings;
    }
}

TEST(RingLod, MeetsTheCapHoweverRoughTheClay) {
    const auto radii = wall(2000, rough);
    for (const int cap : {2, 3, 16, 64, 128, 256}) {
        const RingChoice choice =
            choose_rings(radii, {.tolerance_mm = 0.01F, .max_rings = cap, .max_step = 50});
        EXPECT_LE(choice.elements.size(), static_cast<std::size_t>(cap));
        EXPECT_EQ(choice.elements.front(), 0U);
        EXPECT_EQ(choice.elements.back(), 1999U);
        EXPECT_GT(choice.tolerance_mm, 0.01F);
        EXPECT_LE(ring_error_mm(radii, choice.elements), choice.tolerance_mm * 1.001F);
    }
}

TEST(RingLod, RelaxesTheToleranceNoFurtherThanTheCapAsks) {
    const auto radii = wall(2000, rough);
    const RingChoice choice = choose_rings(radii, {.tolerance_mm = 0.01F, .max_rings = 128, .max_step = 50});
    const RingChoice finer =
        choose_rings(radii, {.tolerance_mm = choice.tolerance_mm * 0.85F, .max_rings = 2000, .max_step = 50});
    EXPECT_GT(finer.elements.size(), 128U);
}

TEST(RingLod, KeepsRingsCloseEnoughForLightToInterpolate) {
    const auto radii = wall(2000, [](int) { return 60.0F; });
    const RingChoice choice = choose_rings(radii, {.tolerance_mm = 0.05F, .max_rings = 128, .max_step = 100});
    for (std::size_t ring = 1; ring < choice.elements.size(); ++ring)
        EXPECT_LE(choice.elements[ring] - choice.elements[ring - 1], 100U);
}

TEST(RingLod, TerminatesForOneElementNoneAndNanRadii) {
    EXPECT_TRUE(choose_rings({}, {}).elements.empty());
    const std::vector<float> one{60.0F};
    EXPECT_EQ(choose_rings(one, {}).elements, (std::vector<std::uint32_t>{0}));
    std::vector<float> bad(300, std::numeric_limits<float>::quiet_NaN());
    EXPECT_LE(choose_rings(bad, {.max_rings = 64}).elements.size(), 64U);
}

}  // namespace
}  // namespace onggi::render
