#include "engine/render/shadow_region.h"

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

TEST(ConvexHull, KeepsTheCornersAndNothingElse) {
    const std::vector<dvec2> hull =
        convex_hull({{0, 0}, {4, 0}, {2, 1}, {4, 4}, {2, 0}, {0, 4}, {1, 3}, {4, 4}});
    EXPECT_EQ(hull, (std::vector<dvec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
}

bool holds(const std::vector<dvec2>& polygon, dvec2 point) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2 a = polygon[i];
        const dvec2 b = polygon[(i + 1) % polygon.size()];
        if ((b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x) < 0.0) return false;
    }
    return polygon.size() >= 3;
}

TEST(ShadeOutline, HoldsTheShadowOfEveryPointOfTheLatheAndTheTool) {
    std::vector<float> radii;
    for (int i = 0; i < 200; ++i)
        radii.push_back(i < 100 ? 30.0F : 60.0F);
    Scene scene;
    scene.camera = {
        .eye_mm = {0.0F, 350.0F, 1100.0F}, .target_mm = {0.0F, 60.0F, 0.0F}, .vertical_fov_rad = 0.3F};
    scene.key = kLight;
    scene.lathe = Lathe{.radii_mm = radii, .element_height_mm = 1.0F};
    scene.spheres = {{.centre_mm = {90.0F, 120.0F, 0.0F}, .radius_mm = 20.0F}};
    const std::vector<dvec2> outline = shade_outline(scene, -100.0F, 1280, 720, 32);
    ASSERT_LE(outline.size(), 32U);
    const auto check = [&](vec3 point) {
        for (const float ground : {0.0F, -40.0F, -100.0F}) {
            const vec3 shadow = point - kLight.towards_light * ((point.y - ground) / kLight.towards_light.y);
            const auto pixel = project(scene.camera, 1280, 720, dvec3(shadow));
            ASSERT_TRUE(pixel);
            EXPECT_TRUE(holds(outline, pixel->pixel)) << point.x << " " << point.y << " " << point.z;
        }
    };
    for (int i = 0; i < 200; i += 20) {
        for (int s = 0; s < 16; ++s) {
            const float angle = static_cast<float>(s) * 0.3927F;
            const float r = radii[static_cast<std::size_t>(i)];
            check({r * std::cos(angle), static_cast<float>(i), r * std::sin(angle)});
        }
    }
    check({110.0F, 120.0F, 0.0F});
    check({90.0F, 140.0F, 0.0F});
}

TEST(ShadeOutline, IsEmptyWhereNothingCasts) {
    Scene scene;
    scene.key = kLight;
    EXPECT_TRUE(shade_outline(scene, -100.0F, 1280, 720, 32).empty());
}

TEST(PixelsOf, StaysInsideThePictureAndTakesAllOfItWhenABoxReachesBehindTheEye) {
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
