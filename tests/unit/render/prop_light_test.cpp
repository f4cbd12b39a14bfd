// tests/golden/backends_agree_test.cpp compares with the shader; here, cases of light with known results.
#include "engine/render/pixels/prop_pixels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "engine/render/shapes/lathe_edges.h"
#include "shaders/transfer.h"

namespace onggi::render {
namespace {

// formula_test.cpp tests the transfer function against the standard.
float lit(float light) {
    return 255.0F * shaders::transferred(std::min(light / (0.8F * light + 0.35F), 1.0F));
}

// The indices of all vertices of a mesh.
std::vector<std::uint32_t> numbers_of(const PropMesh& mesh) {
    std::vector<std::uint32_t> numbers(mesh.vertices.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    return numbers;
}

class PropLight : public testing::Test {
  protected:
    PropLight() {
        const vec3 eye(0.0F, 0.0F, 1000.0F);
        camera_ = {.eye_mm = eye, .target_mm = vec3(0.0F), .vertical_fov_rad = 0.4F};
        frame_.view_projection = view_projection(camera_, kWidth, kHeight);
        frame_.picture = vec4(kWidth, kHeight, 1.0F / kWidth, 1.0F / kHeight);
        frame_.eye = vec4(eye, 0.0F);
        frame_.key_direction = vec4(0.0F, 0.0F, 1.0F, 0.05F);
        for (vec4& panel : frame_.panel_direction)
            panel = vec4(0.0F, 1.0F, 0.0F, 4.0F);
        // In the middle of the picture, facing the eye, without colour of its own.
        mesh_.vertices = {{.position_mm = vec3(0.0F), .normal = {0.0F, 0.0F, 1.0F}, .tone = 128}};
        mesh_.albedo = vec3(0.0F);
        mesh_.roughness = 1.0F;
    }
    [[nodiscard]] std::vector<PropCorner> corners(ByteOrder order = ByteOrder::kRedFirst) const {
        std::vector<PropCorner> lit;
        light_corners(mesh_, numbers_of(mesh_), prop_, {frame_, samples_, order}, lit);
        return lit;
    }
    [[nodiscard]] std::array<float, 3> colour() const { return corners().at(0).values; }

    static constexpr int kWidth = 640;
    static constexpr int kHeight = 360;
    Camera camera_;
    shaders::FrameData frame_{};
    LatheSamples samples_;
    PropMesh mesh_;
    Prop prop_;
};

constexpr float kTone = 0.5F + 128.0F / 255.0F;  // of the middle one

TEST_F(PropLight, OfTheSkyIsProportionalToTheAlbedo) {
    frame_.irradiance[0] = vec4(0.8F, 0.6F, 0.4F, 0.0F);
    mesh_.albedo = vec3(0.5F, 0.3F, 0.1F);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(colour()[static_cast<std::size_t>(channel)],
                    lit(frame_.irradiance[0][channel] * mesh_.albedo[channel] * kTone), 0.02F);
    }
    const auto red_first = colour();
    const auto blue_first = corners(ByteOrder::kBlueFirst).at(0).values;
    EXPECT_EQ(blue_first[0], red_first[2]);
    EXPECT_EQ(blue_first[2], red_first[0]);
    mesh_.vertices[0].open_sky = 0;
    EXPECT_EQ(colour()[0], 0.0F) << "in the deepest corner";
}

TEST_F(PropLight, IsMirroredByAPolishedSkinOfNoColour) {
    frame_.sky_horizon = vec4(1.0F, 1.0F, 1.0F, 0.0F);
    EXPECT_NEAR(colour()[0], lit(0.04F), 0.02F);
    // One soft panel: straight in the mirror, and sixty degrees beside it.
    frame_.sky_horizon = vec4(0.0F);
    mesh_.roughness = 0.5F;
    frame_.panel_radiance[0] = vec4(3.0F);
    const float blur = 2.0F / 0.0625F;
    const float soft = 4.0F * blur / (4.0F + blur);
    for (const float cosine : {1.0F, 0.5F, -1.0F}) {
        frame_.panel_direction[0] = vec4(std::sqrt(1.0F - cosine * cosine), 0.0F, cosine, 4.0F);
        const float seen = 0.04F * 3.0F * soft / 4.0F * std::exp(soft * (cosine - 1.0F));
        EXPECT_NEAR(colour()[0], lit(seen), 0.02F) << cosine;
    }
}

TEST_F(PropLight, OfTheKeyIsTheColoursAndAGleam) {
    frame_.key_radiance = vec4(2.0F);
    mesh_.albedo = vec3(0.3F);
    // At normal incidence and full roughness the highlight is a quarter of the mirror reflectance.
    EXPECT_NEAR(colour()[0], lit(2.0F * (0.3F * kTone + 0.25F * 0.04F)), 0.02F);
    mesh_.vertices[0].open_sky = 0;
    EXPECT_NEAR(colour()[0], lit(0.55F * 2.0F * (0.3F * kTone + 0.25F * 0.04F)), 0.02F) << "in a corner";
    frame_.key_direction = vec4(0.0F, 0.0F, -1.0F, 0.05F);
    EXPECT_EQ(colour()[0], 0.0F) << "from behind";
}

TEST_F(PropLight, IsTheClaysWhereClayLies) {
    frame_.irradiance[0] = vec4(1.0F);
    mesh_.albedo = vec3(0.9F);
    mesh_.vertices[0].smear = 255;
    prop_.smear = vec3(0.2F, 0.1F, 0.05F);
    EXPECT_NEAR(colour()[0], lit(0.2F), 0.02F);
    EXPECT_NEAR(colour()[2], lit(0.05F), 0.02F);
}

TEST_F(PropLight, OfTheKeyStaysAwayBehindThePot) {
    frame_.key_radiance = vec4(2.0F);
    frame_.key_direction = vec4(glm::normalize(vec3(-1.0F, 1.0F, 0.0F)), 0.05F);
    mesh_.albedo = vec3(0.3F);
    mesh_.vertices[0].normal = {0.0F, 1.0F, 0.0F};
    samples_.outer_mm.fill(60.0F);
    frame_.lathe = vec4(200.0F, LatheSamples::kCount / 200.0F, LatheSamples::kCount, 60.0F);
    const auto at = [&](float x_mm) {
        prop_.place = glm::translate(mat4(1.0F), vec3(x_mm, 10.0F, 0.0F));
        return colour()[0];
    };
    EXPECT_EQ(at(100.0F), 0.0F) << "the light comes from the left, at 45 degrees";
    EXPECT_GT(at(-100.0F), 50.0F);
    EXPECT_EQ(at(300.0F), at(-100.0F)) << "beyond its shadow";
    frame_.lathe = vec4(0.0F);
    EXPECT_EQ(at(100.0F), at(-100.0F)) << "there is no pot";
}

TEST_F(PropLight, FindsEachCornerWhereTheCameraSeesIt) {
    mesh_.vertices.assign(150, mesh_.vertices[0]);
    for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
        const auto number = static_cast<float>(i);
        mesh_.vertices[i].position_mm = {number, 0.4F * number, -0.3F * number};
        mesh_.vertices[i].tone = static_cast<std::uint8_t>(i);
    }
    prop_.place = glm::rotate(glm::translate(mat4(1.0F), vec3(-40.0F, 20.0F, 5.0F)), 0.4F,
                              glm::normalize(vec3(0.2F, 0.9F, 0.1F)));
    frame_.irradiance[0] = vec4(1.0F);
    mesh_.albedo = vec3(0.5F);
    const std::vector<PropCorner> lit = corners();
    ASSERT_EQ(lit.size(), mesh_.vertices.size());
    const Projector project({camera_, kWidth, kHeight});
    for (std::size_t i = 0; i < lit.size(); ++i) {
        const vec4 expected = project(vec3(prop_.place * vec4(mesh_.vertices[i].position_mm, 1.0F)));
        EXPECT_NEAR(lit[i].at_px.x, expected.x, 0.003F);
        EXPECT_NEAR(lit[i].at_px.y, expected.y, 0.003F);
        EXPECT_NEAR(lit[i].away_mm, expected.w, 0.01F);
        EXPECT_GT(lit[i].depth, expected.z) << "which is a little nearer";
        if (i > 0) {
            EXPECT_GT(lit[i].values[0], lit[i - 1].values[0]) << "its own tone";
        }
    }
    prop_.place = glm::translate(mat4(1.0F), vec3(0.0F, 0.0F, 1200.0F));
    EXPECT_EQ(corners().at(0).away_mm, 0.0F) << "behind the eye";
    const std::size_t before = mesh_.vertices.size();
    std::vector<PropCorner> more = corners();
    light_corners(mesh_, numbers_of(mesh_), prop_, {frame_, samples_}, more);
    EXPECT_EQ(more.size(), 2 * before);
    // Only the requested vertices.
    std::vector<PropCorner> few;
    light_corners(mesh_, std::array<std::uint32_t, 3>{149, 2, 2}, prop_, {frame_, samples_}, few);
    ASSERT_EQ(few.size(), before);
    EXPECT_EQ(few[149].at_px, more[149].at_px);
    EXPECT_EQ(few[2].values, more[2].values);
    EXPECT_EQ(few[3].values, PropCorner{}.values);
    mesh_.vertices.clear();
    EXPECT_TRUE(corners().empty());
}

}  // namespace
}  // namespace onggi::render
