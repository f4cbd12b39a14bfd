#include "engine/render/shapes/frame_build.h"

#include <gtest/gtest.h>

#include <set>

namespace onggi::render {
namespace {

class FrameBuild : public testing::Test {
  protected:
    FrameBuild() {
        scene_.camera = {
            .eye_mm = {0.0F, 350.0F, 1100.0F}, .target_mm = {0.0F, 70.0F, 0.0F}, .vertical_fov_rad = 0.3F};
        scene_.key.towards_light = glm::normalize(vec3(-0.7F, 0.6F, 0.4F));
        scene_.lathe = Lathe{.radii_mm = radii_, .element_height_mm = 0.1F, .edge_rounding_mm = 2.0F};
        scene_.spheres = {{.centre_mm = {80.0F, 100.0F, 0.0F}, .radius_mm = 10.0F}};
    }
    const BuiltFrame& build() {
        build_frame(scene_, {.lowest_mm = -100.0F}, desc_, 1280, 720, built_);
        return built_;
    }

    std::vector<float> radii_ = std::vector<float>(2000, 60.0F);
    RendererDesc desc_ = live_desc(VK_FORMAT_R8G8B8A8_UNORM, true, 720);
    Scene scene_;
    BuiltFrame built_;
};

TEST_F(FrameBuild, NeverDrawsMoreRingsThanTheCap) {
    for (std::size_t i = 0; i < radii_.size(); ++i)
        radii_[i] = 50.0F + static_cast<float>((i * 2654435761U >> 7U) % 100U) * 0.05F;
    const BuiltFrame& built = build();
    EXPECT_LE(built.rows.size(), static_cast<std::size_t>(desc_.max_rings));
    EXPECT_GT(built.ring_error_px, desc_.ring_error_px);
}

TEST_F(FrameBuild, DrawsAStripBetweenEachTwoRows) {
    const BuiltFrame& built = build();
    const auto sectors = static_cast<std::size_t>(built.sectors);
    EXPECT_EQ(built.vertices.size(), built.rows.size() * (sectors + 1));
    LatheFaces all;
    take_all_faces(built.rows.size(), built.sectors, all);
    EXPECT_EQ(all.indices.size(), (built.rows.size() - 1) * sectors * 6);
    EXPECT_EQ(*std::max_element(all.indices.begin(), all.indices.end()),
              built.rows.size() * (sectors + 1) - 1);
}

TEST_F(FrameBuild, IndexesTheLargestLatheWithSixteenBits) {
    const RendererDesc still = still_desc(VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_LE(static_cast<std::size_t>(kMaxRings) * static_cast<std::size_t>(still.sectors + 1), 65536U);
}

TEST_F(FrameBuild, SmoothsOutlinesOnlyWhereThePictureHasOneSampleAPixel) {
    EXPECT_FALSE(build().edges.empty());
    desc_ = still_desc(VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_TRUE(build().edges.empty());
}

TEST_F(FrameBuild, DrawsNoMissingLathe) {
    scene_.lathe.reset();
    EXPECT_TRUE(build().faces.indices.empty());
    scene_.lathe = Lathe{};
    EXPECT_TRUE(build().faces.indices.empty());
}

TEST_F(FrameBuild, CastsShadowsOfNoMoreSpheresThanTheShaderKnows) {
    scene_.spheres.assign(5, {.centre_mm = {80.0F, 100.0F, 0.0F}, .radius_mm = 10.0F});
    const BuiltFrame& built = build();
    EXPECT_EQ(built.frame.spheres[shaders::kSpheres - 1].w, 10.0F);
}

TEST_F(FrameBuild, DarkensAndSaturatesABodyFullOfWater) {
    scene_.lathe->material = {.albedo = vec3(0.4F, 0.2F, 0.1F)};
    const BuiltFrame& built = build();
    EXPECT_EQ(vec3(built.lathe.dry), vec3(0.4F, 0.2F, 0.1F));
    // A' = A (1 - p) / (1 - p A), p = 0.66.
    EXPECT_NEAR(built.lathe.wet.x, 0.4F * 0.34F / (1.0F - 0.66F * 0.4F), 1e-6F);
    EXPECT_GT(built.lathe.wet.x / built.lathe.wet.z, 4.0F);
}

TEST_F(FrameBuild, MirrorsAGlazeMoreThanWater) {
    const float water = build().lathe.turn.z;
    const float glaze_of_water = build().lathe.gloss.z;
    EXPECT_FLOAT_EQ(water, 0.02F);  // at normal incidence, of n = 1.33
    scene_.lathe->material.coat = 1.0F;
    EXPECT_FLOAT_EQ(build().lathe.turn.z, 0.04F);  // n = 1.5
    EXPECT_LT(build().lathe.gloss.z, glaze_of_water);
}

TEST_F(FrameBuild, RepeatsTheStreaksTextureTwicePerTurn) {
    scene_.lathe->turn = {0.0F, 1.0F};  // a quarter
    EXPECT_NEAR(build().lathe.turn.x, 0.5F, 1e-6F);
}

TEST_F(FrameBuild, RedrawsTheStillLifeOnlyForItsOwnInputs) {
    const std::uint64_t before = still_hash(scene_, 1280, 720);
    radii_[5] = 1.0F;
    scene_.spheres[0].centre_mm.x += 1.0F;
    scene_.lathe->turn = {0.0F, 1.0F};
    scene_.levels.key = 0.5F;
    EXPECT_EQ(still_hash(scene_, 1280, 720), before);
    std::set<std::uint64_t> hashes{before};
    hashes.insert(still_hash(scene_, 1281, 720));
    scene_.camera.eye_mm.x += 1.0F;
    hashes.insert(still_hash(scene_, 1280, 720));
    scene_.key.radiance.x *= 0.99F;
    hashes.insert(still_hash(scene_, 1280, 720));
    scene_.environment.panels[2].sharpness += 1.0F;
    hashes.insert(still_hash(scene_, 1280, 720));
    scene_.backdrop.glow.z += 0.1F;
    hashes.insert(still_hash(scene_, 1280, 720));
    scene_.irradiance.emplace();
    hashes.insert(still_hash(scene_, 1280, 720));
    EXPECT_EQ(hashes.size(), 7U);
}

TEST_F(FrameBuild, DimsEveryLightOfTheClayWithTheRoom) {
    scene_.key.radiance = vec3(2.0F, 1.5F, 1.0F);
    scene_.irradiance.emplace().fill(vec3(0.5F));
    scene_.environment.panels[1].radiance = vec3(1.0F);
    scene_.levels = {.ambient = vec3(0.5F, 0.25F, 0.125F), .key = 0.0F};
    const shaders::FrameData& frame = build().frame;
    EXPECT_EQ(vec3(frame.key_radiance), vec3(0.0F));
    EXPECT_EQ(vec3(frame.irradiance[4]), vec3(0.25F, 0.125F, 0.0625F));
    EXPECT_EQ(vec3(frame.panel_radiance[1]), vec3(0.5F, 0.25F, 0.125F));
    EXPECT_EQ(frame.levels, vec4(0.5F, 0.25F, 0.125F, 0.0F));
}

TEST_F(FrameBuild, RedrawsTheShadowForOutlineToolAndLight) {
    std::set<std::uint64_t> hashes{shadow_hash(scene_)};
    scene_.lathe->turn = {0.0F, 1.0F};
    EXPECT_TRUE(hashes.contains(shadow_hash(scene_))) << "a turning pot casts the same shadow";
    radii_[1999] -= 0.01F;
    hashes.insert(shadow_hash(scene_));
    scene_.spheres[0].centre_mm.y += 0.01F;
    hashes.insert(shadow_hash(scene_));
    scene_.key.angular_radius_rad *= 2.0F;
    hashes.insert(shadow_hash(scene_));
    EXPECT_EQ(hashes.size(), 4U);
}

TEST(StillBounds, KnowTheGroundAndTheShadowCasters) {
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {{.position_mm = {-10, -5, 0}, .normal = {0, 1, 0}},
                      {.position_mm = {10, 5, 0}, .normal = {0, 1, 0}}};
    auto ground = std::make_shared<Mesh>();
    ground->vertices = {{.position_mm = {5000, -80, 0}, .normal = {0, 1, 0}}};
    StillLife still_life;
    still_life.parts = {{.mesh = mesh, .material = {}},
                        {.mesh = ground, .material = {}, .casts_shadow = false}};
    const StillBounds bounds = bounds_of(still_life);
    EXPECT_EQ(bounds.lowest_mm, -80.0F);
    EXPECT_EQ(bounds.centre_mm, vec3(0.0F));
    EXPECT_NEAR(bounds.radius_mm, std::sqrt(125.0F), 1e-4F);
}

}  // namespace
}  // namespace onggi::render
