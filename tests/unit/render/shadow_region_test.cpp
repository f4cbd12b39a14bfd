#include "engine/render/shapes/frame_build.h"

#include <gtest/gtest.h>

namespace onggi::render {
namespace {

const DirectionalLight kLight{.towards_light = glm::normalize(vec3(-0.7F, 0.6F, 0.4F)),
                              .angular_radius_rad = 0.05F};

TEST(ShadowMask, FindsAGroundPointWhereItsOwnWayBackPutsIt) {
    const MaskPlacement mask = place_mask({.half_width_mm = 150.0F, .height_mm = 200.0F}, kLight);
    for (const vec2 uv : {vec2(0.0F), vec2(1.0F), vec2(0.3F, 0.8F)}) {
        const vec2 ground = mask.origin + uv.x * mask.axis_u + uv.y * mask.axis_v;
        const vec4 p(ground.x, 0.0F, ground.y, 1.0F);
        EXPECT_NEAR(glm::dot(mask.u, p), uv.x, 1e-5F);
        EXPECT_NEAR(glm::dot(mask.v, p), uv.y, 1e-5F);
    }
}

TEST(ShadowMask, LooksUpAPointBelowWhereTheLightToItPassesTheGround) {
    const MaskPlacement mask = place_mask({}, kLight);
    const vec3 ground(40.0F, 0.0F, -20.0F);
    const vec3 below = ground - kLight.towards_light * 90.0F;
    EXPECT_NEAR(glm::dot(mask.u, vec4(below, 1.0F)), glm::dot(mask.u, vec4(ground, 1.0F)), 1e-5F);
    EXPECT_NEAR(glm::dot(mask.v, vec4(below, 1.0F)), glm::dot(mask.v, vec4(ground, 1.0F)), 1e-5F);
}

TEST(ShadowMask, HoldsTheShadowOfTheTallestThing) {
    const ShadowRegion region{.half_width_mm = 150.0F, .height_mm = 230.0F};
    const MaskPlacement mask = place_mask(region, kLight);
    const vec3 top(0.0F, 230.0F, 0.0F);
    const vec3 shadow = top - kLight.towards_light * (top.y / kLight.towards_light.y);
    const float u = glm::dot(mask.u, vec4(shadow, 1.0F));
    EXPECT_GT(u, 0.0F);
    EXPECT_LT(u, 1.0F);
    EXPECT_NEAR(glm::dot(mask.v, vec4(shadow, 1.0F)), 0.5F, 1e-5F);
}

TEST(PixelsOf, AreInsideThePictureAndAllOfThemIfABoxReachesBehindTheEye) {
    const Camera camera{
        .eye_mm = {0.0F, 0.0F, 1000.0F}, .target_mm = {0.0F, 0.0F, 0.0F}, .vertical_fov_rad = 0.5F};
    const std::array small{Box{vec3(-10.0F), vec3(10.0F)}};
    const PixelRect rect = pixels_of(small, camera, 640, 480);
    EXPECT_GT(rect.width, 18);
    EXPECT_LT(rect.width, 30);
    EXPECT_NEAR(rect.x + rect.width / 2, 320, 1);
    const std::array huge{Box{vec3(-9000.0F), vec3(900.0F)}};
    EXPECT_EQ(pixels_of(huge, camera, 640, 480), (PixelRect{0, 0, 640, 480}));
    const std::array behind{Box{vec3(-1.0F, -1.0F, 900.0F), vec3(1.0F, 1.0F, 1100.0F)}};
    EXPECT_EQ(pixels_of(behind, camera, 640, 480), (PixelRect{0, 0, 640, 480}));
    EXPECT_EQ(pixels_of({}, camera, 640, 480), PixelRect{});
}

}  // namespace
}  // namespace onggi::render
