// tests/golden/backends_agree_test.cpp compares with the shader; here, cases of light with known results.
#include "engine/render/pixels/lathe_pixels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "engine/render/shapes/lathe_edges.h"

namespace onggi::render {
namespace {

namespace value = lathe_value;

class LatheCorners : public testing::Test {
  protected:
    // Two rows of two vertices, in front of the axis and behind it; the wall is upright.
    LatheCorners() {
        const vec3 eye(0.0F, 100.0F, 1000.0F);
        camera_ = {.eye_mm = eye, .target_mm = vec3(0.0F, 100.0F, 0.0F), .vertical_fov_rad = 0.4F};
        frame_.view_projection = view_projection(camera_, kWidth, kHeight);
        frame_.picture = vec4(kWidth, kHeight, 1.0F / kWidth, 1.0F / kHeight);
        frame_.eye = vec4(eye, 0.0F);
        frame_.key_direction = vec4(0.0F, 0.0F, 1.0F, 0.05F);
        for (vec4& sphere : frame_.spheres)
            sphere = vec4(0.0F, -1e6F, 0.0F, 1e-3F);
        for (vec4& panel : frame_.panel_direction)
            panel = vec4(0.0F, 1.0F, 0.0F, 4.0F);
        draw_.turn.y = 2.0F;
        for (const float y : {100.0F, 150.0F}) {
            rows_.push_back({.place = vec4(40.0F, y, 0.25F, y),
                             .light = vec4(1.0F, 0.0F, 1.0F, 0.0F),
                             .water = vec4(0.0F)});
            for (const float side : {1.0F, -1.0F}) {
                vertices_.push_back({.place = vec4(0.0F, y, 40.0F * side, 0.7F),
                                     .lean = vec4(0.0F, 0.0F, side, side > 0.0F ? 0.25F : 0.75F)});
            }
        }
    }
    [[nodiscard]] std::vector<LatheCorner> corners(
        std::span<const std::uint16_t> indices = std::array<std::uint16_t, 4>{0, 1, 2, 3}) const {
        std::vector<LatheCorner> lit;
        light_corners(
            {.frame = frame_, .draw = draw_, .rows = rows_, .vertices = vertices_, .streaks = {256, 128}},
            indices, lit);
        return lit;
    }
    [[nodiscard]] vec3 three(std::size_t corner, std::size_t number) const {
        const auto values = corners().at(corner).values;
        return {values[number], values[number + 1], values[number + 2]};
    }

    static constexpr int kWidth = 640;
    static constexpr int kHeight = 360;
    Camera camera_;
    shaders::FrameData frame_{};
    shaders::LatheDraw draw_{};
    std::vector<shaders::RowData> rows_;
    std::vector<shaders::VertexData> vertices_;
};

void expect_near(const vec3& found, const vec3& wanted, float most = 1e-4F) {
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found[axis], wanted[axis], most) << axis;
}

TEST_F(LatheCorners, LieWhereTheCameraSeesThem) {
    const auto lit = corners();
    ASSERT_EQ(lit.size(), vertices_.size());
    const Projector project({camera_, kWidth, kHeight});
    for (std::size_t i = 0; i < lit.size(); ++i) {
        const vec3 place(vertices_[i].place);
        const vec4 wanted = project(place);
        EXPECT_NEAR(lit[i].at_px.x, wanted.x, 0.003F) << i;
        EXPECT_NEAR(lit[i].at_px.y, wanted.y, 0.003F) << i;
        EXPECT_NEAR(lit[i].away_mm, wanted.w, 0.01F) << i;
        EXPECT_EQ(lit[i].values[value::kDepth], lit[i].depth);
        expect_near(three(i, value::kPlace), place);
        expect_near(three(i, value::kToEye), glm::normalize(vec3(frame_.eye) - place));
        EXPECT_EQ(lit[i].values[value::kSeen], 0.7F);
        EXPECT_EQ(lit[i].values[value::kNormal], 0.25F * shaders::kProfileTexels);
    }
    EXPECT_NEAR(lit[0].values[value::kHalf], 0.5F, 1e-5F) << "light from the eye";
    const auto few = corners(std::array<std::uint16_t, 3>{3, 1, 3});
    ASSERT_EQ(few.size(), lit.size()) << "of those that are asked for";
    EXPECT_EQ(few[3].values, lit[3].values);
    EXPECT_EQ(few[1].at_px, lit[1].at_px);
    EXPECT_EQ(few[2].away_mm, 0.0F);
}

TEST_F(LatheCorners, SayWhichTexelOfTheStreaksLiesThere) {
    draw_.turn.x = 0.5F;
    const auto lit = corners();
    EXPECT_EQ(lit[1].values[value::kNear], 1.0F / lit[1].away_mm);
    const auto texel = [&](std::size_t corner, std::size_t axis) {
        return lit[corner].values[value::kStreak + axis] / lit[corner].values[value::kNear];
    };
    // Twice round, and half a width for the turn; up by 67 mm.
    EXPECT_NEAR(std::fmod(texel(0, 0), 256.0F), 0.0F, 0.01F);
    EXPECT_NEAR(texel(1, 0) - texel(0, 0), 256.0F, 0.01F);
    EXPECT_NEAR(texel(0, 1), 128.0F * 100.0F / 67.0F, 0.01F);
    EXPECT_NEAR(texel(2, 1), 128.0F * 150.0F / 67.0F, 0.01F);
}

TEST_F(LatheCorners, GetTheAlbedosShareOfTheSky) {
    frame_.irradiance[0] = vec4(0.8F, 0.6F, 0.4F, 0.0F);
    draw_.dry = vec4(0.5F, 0.4F, 0.3F, 0.0F);
    draw_.wet = vec4(0.3F, 0.2F, 0.1F, 0.0F);
    expect_near(three(2, value::kAmbient), vec3(0.40F, 0.24F, 0.12F), 1e-3F);
    rows_[1].water.x = 0.5F;
    expect_near(three(2, value::kAmbient), vec3(0.32F, 0.18F, 0.08F), 1e-3F);
    // In a hollow half of the light, plus the hollow's own reflection.
    rows_[1].water.x = 0.0F;
    rows_[1].light.z = 0.5F;
    EXPECT_NEAR(three(2, value::kAmbient).x, 0.40F * 0.5F * (1.0F + 0.5F * 0.5F * 1.6F), 1e-3F);
    // At the foot a wall receives less.
    rows_[1] = rows_[0];
    rows_[1].place.y = 0.0F;
    const float open = 0.45F;
    EXPECT_NEAR(three(2, value::kAmbient).x, 0.40F * open * (1.0F + 0.5F * (1.0F - open) * 1.6F), 1e-3F);
}

TEST_F(LatheCorners, LoseTheSkyToASphereBeforeThem) {
    frame_.irradiance[0] = vec4(1.0F);
    draw_.dry = vec4(0.5F);
    const float free = three(0, value::kAmbient).x;
    frame_.spheres[2] = vec4(0.0F, 100.0F, 60.0F, 10.0F);  // covers a quarter of the wall's view
    const float open = 0.75F;
    EXPECT_NEAR(three(0, value::kAmbient).x, free * open * (1.0F + 0.5F * (1.0F - open) * 1.6F), 1e-3F);
    EXPECT_NEAR(three(1, value::kAmbient).x, free, 1e-3F) << "it is behind this one";
}

TEST_F(LatheCorners, LookUpThroughTheMouthFromDeepInside) {
    frame_.irradiance[1] = vec4(1.0F);  // as much as the normal looks up
    draw_.dry = vec4(1.0F);
    EXPECT_NEAR(three(0, value::kAmbient).x, 0.0F, 1e-4F);
    rows_[0].light.z = 0.2F;
    rows_[0].light.w = 1.0F;
    const float upward = 0.75F * 0.8F;
    const float up = upward / std::hypot(upward, 1.0F - upward);
    EXPECT_NEAR(three(0, value::kAmbient).x, up * 0.2F * (1.0F + 0.8F * 1.6F), 1e-3F);
}

TEST_F(LatheCorners, MirrorTheSkyThatLiesInTheMirror) {
    frame_.panel_radiance[0] = vec4(2.0F, 3.0F, 4.0F, 0.0F);
    frame_.panel_direction[0] = vec4(0.0F, 0.0F, 1.0F, 4.0F);
    rows_[0].light.z = 0.5F;
    // Straight back to the eye, blurred by a film's roughness.
    const float blur = 2.0F / (0.3F * 0.3F * 0.3F * 0.3F);
    const float fraction = blur / (4.0F + blur);
    expect_near(three(0, value::kMirrored), 0.5F * fraction * vec3(2.0F, 3.0F, 4.0F), 1e-2F);
    frame_.panel_direction[0] = vec4(0.0F, 0.0F, -1.0F, 4.0F);
    EXPECT_LT(three(0, value::kMirrored).x, 0.01F);
}

TEST_F(LatheCorners, LeanAsTheDentsSay) {
    frame_.irradiance[1] = vec4(1.0F);
    draw_.dry = vec4(1.0F);
    vertices_[0].lean.y = -1.0F;  // looks up by 45 degrees
    EXPECT_NEAR(three(0, value::kAmbient).x, std::sqrt(0.5F), 1e-3F);
    EXPECT_EQ(corners()[0].values[value::kLean], -1.0F);
    EXPECT_EQ(corners()[0].values[value::kOutward], 0.0F);
    EXPECT_EQ(corners()[0].values[value::kOutward + 1], 1.0F);
}

}  // namespace
}  // namespace onggi::render
