#include "engine/render/shapes/lathe_mesh.h"

#include <gtest/gtest.h>

#include "tests/unit/render/lathe_samples.h"

namespace onggi::render {
namespace {

// 45 degrees up, from +X; a light of two degrees.
const KeyRay kKey{.towards_light = glm::normalize(vec3(1.0F, 1.0F, 0.0F)), .tangent = 0.0175F};

KeyColumns columns(const LatheSamples& samples, LatheFace face, vec2 place, vec2 normal) {
    KeyColumns ring{};
    key_columns(samples, face, place, normal, kKey, ring);
    return ring;
}

// The light inside a wall of 45 mm inner radius.
KeyColumns inside(const LatheSamples& samples, float y_mm) {
    return columns(samples, LatheFace::kInner, {45.0F, y_mm}, {-1.0F, 0.0F});
}

TEST(LatheLight, SeesTheWholeSkyFromAStraightWallAndHalfFromUnderALedge) {
    const LatheSamples straight = samples_of(Cylinder().profile());
    for (const float y : {5.0F, 50.0F, 90.0F})
        EXPECT_FLOAT_EQ(open_outside(straight, 50.0F, y), 1.0F);

    Cylinder ledge(30.0F);
    std::fill(ledge.outer.begin() + 500, ledge.outer.end(), 60.0F);
    const LatheSamples samples = samples_of(ledge.profile());
    EXPECT_LT(open_outside(samples, 30.0F, 46.0F), 0.6F);
    EXPECT_GT(open_outside(samples, 30.0F, 2.0F), 0.9F);
}

TEST(LatheLight, SeesTheSkyThroughTheMouthFromInside) {
    const Cylinder pot(50.0F, 5.0F, 10.0F, 100.0F);
    const LatheSamples samples = samples_of(pot.profile(0.0F));
    // The middle of the floor looks at a disc of 45 mm radius 90 mm above: R^2 / (R^2 + h^2) = 0.2.
    EXPECT_NEAR(open_inside(samples, 0.1F, 10.1F, {0.0F, 1.0F}), 0.2F, 0.05F);
    // A wall's place just under the rim looks at nearly half the sky; half of its view lies below it.
    EXPECT_NEAR(open_inside(samples, 44.6F, 98.0F, {-1.0F, 0.0F}), 0.45F, 0.08F);
    EXPECT_LT(open_inside(samples, 44.6F, 20.0F, {-1.0F, 0.0F}), 0.12F);
}

TEST(LatheLight, ShadesTheNearInsideAndLightsTheFarWallDownToTheRimsShadow) {
    const LatheSamples samples = samples_of(Cylinder(50.0F, 5.0F, 10.0F, 200.0F).profile(0.0F));
    // At 45 degrees the rim at the light's side throws its shadow 90 mm down the far wall.
    const auto far_wall = [&](float y) { return inside(samples, y).back(); };
    EXPECT_GT(far_wall(195.0F), 0.99F);
    EXPECT_GT(far_wall(120.0F), 0.99F);
    EXPECT_LT(far_wall(95.0F), 0.01F);
    EXPECT_EQ(inside(samples, 150.0F).front(), 0.0F) << "under the rim at the light's side";
}

TEST(LatheLight, ShadesANeckUnderAWiderRim) {
    Cylinder pot(30.0F);
    std::fill(pot.outer.begin() + 900, pot.outer.end(), 60.0F);
    const LatheSamples samples = samples_of(pot.profile());
    const auto lit_side = [&](float y) {
        return columns(samples, LatheFace::kOuter, {30.0F, y}, {1.0F, 0.0F}).front();
    };
    EXPECT_LT(lit_side(80.0F), 0.01F);
    EXPECT_GT(lit_side(20.0F), 0.99F);
}

TEST(LatheLight, GivesAWholeRingItsColumnsFromTheLightsSideToTheFarOne) {
    const LatheSamples samples = samples_of(Cylinder(50.0F, 5.0F, 10.0F, 200.0F).profile(0.0F));
    const KeyColumns ring = inside(samples, 170.0F);
    EXPECT_EQ(ring.front(), 0.0F);
    EXPECT_GT(ring.back(), 0.99F);
    for (std::size_t i = 1; i < ring.size(); ++i)
        EXPECT_GE(ring[i], ring[i - 1] - 1e-6F);
}

}  // namespace
}  // namespace onggi::render
