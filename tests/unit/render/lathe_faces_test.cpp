#include "engine/render/shapes/frame_build.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "tests/unit/render/lathe_samples.h"

namespace onggi::render {
namespace {

constexpr std::size_t kRows = 30;
using Triangle = std::array<std::uint16_t, 3>;

// A bellied wall of 200 mm, seen from the front and a little above.
class Faces : public testing::Test {
  protected:
    Faces() {
        for (std::size_t row = 0; row < kRows; ++row) {
            const float y = 200.0F * static_cast<float>(row) / (kRows - 1);
            const float radius = 50.0F + 20.0F * std::sin(y * 0.02F);
            for (int s = 0; s <= kSectors; ++s) {
                const float angle = 6.2831853F * static_cast<float>(s % kSectors) / kSectors;
                vertices_.push_back(
                    {.place = vec4(radius * std::cos(angle), y, radius * std::sin(angle), 1.0F),
                     .lean = vec4(std::cos(angle), 0.0F, std::sin(angle), 0.0F)});
            }
        }
        frame_.key_direction = vec4(glm::normalize(vec3(-0.7F, 0.6F, 0.4F)), 0.1F);
        for (vec4& sphere : frame_.spheres)
            sphere = vec4(0.0F, -1e6F, 0.0F, 1e-3F);
    }
    const LatheFaces& choose() {
        choose_faces(vertices_, kSectors, frame_, {camera_, 1280, 720}, faces_);
        return faces_;
    }
    [[nodiscard]] vec3 at(std::uint16_t index) const { return vec3(vertices_[index].place); }
    [[nodiscard]] bool looks_at_the_eye(const Triangle& t) const {
        const vec3 normal = glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
        return glm::dot(normal, camera_.eye_mm - at(t[0])) > 0.0F;
    }
    static std::set<Triangle> triangles(std::span<const std::uint16_t> indices) {
        std::set<Triangle> found;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            found.insert({indices[i], indices[i + 1], indices[i + 2]});
        return found;
    }

    Camera camera_{.eye_mm = {0.0F, 285.0F, 805.0F}, .target_mm = {0.0F, 82.0F, 0.0F}};
    std::vector<shaders::VertexData> vertices_;
    shaders::FrameData frame_{};
    LatheFaces faces_;
};

TEST_F(Faces, OmitOnlyTrianglesFacingAway) {
    LatheFaces all;
    take_all_faces(kRows, kSectors, all);
    const auto chosen = triangles(choose().indices);
    std::size_t seen = 0;
    for (const Triangle& triangle : triangles(all.indices)) {
        if (!looks_at_the_eye(triangle)) continue;
        ++seen;
        EXPECT_TRUE(chosen.contains(triangle));
    }
    EXPECT_GT(seen, 1000U);
    EXPECT_LT(chosen.size(), seen + seen / 8) << "hardly any others";
}

TEST_F(Faces, AreAllPlainWithoutASphere) {
    const LatheFaces& chosen = choose();
    EXPECT_FALSE(chosen.indices.empty());
    EXPECT_EQ(chosen.plain, chosen.indices.size());
}

TEST_F(Faces, AskForAShadowWhereverOneFalls) {
    const vec4 sphere(-90.0F, 190.0F, 60.0F, 15.0F);
    frame_.spheres[1] = sphere;
    choose();
    EXPECT_GT(faces_.plain, faces_.indices.size() / 2) << "most of the pot is out of its reach";
    EXPECT_LT(faces_.plain, faces_.indices.size());
    // Inside the sphere's cylinder along the light, or within its penumbra.
    const auto is_in_shadow = [&](vec3 point) {
        const vec3 to = vec3(sphere) - point;
        const float along = glm::dot(to, vec3(frame_.key_direction));
        const float gap = std::sqrt(std::max(glm::dot(to, to) - along * along, 0.0F)) - sphere.w;
        return along > 0.0F && gap < along * frame_.key_direction.w;
    };
    int in_shadow = 0;
    for (std::uint32_t i = 0; i + 2 < faces_.indices.size(); i += 3) {
        const std::array corners{at(faces_.indices[i]), at(faces_.indices[i + 1]), at(faces_.indices[i + 2])};
        const vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0F;
        for (const vec3 point : {corners[0], corners[1], corners[2], middle, 0.5F * (corners[0] + corners[1]),
                                 0.5F * (corners[1] + corners[2]), 0.5F * (corners[2] + corners[0])}) {
            if (!is_in_shadow(point)) continue;
            ++in_shadow;
            EXPECT_GE(i, faces_.plain);
        }
    }
    EXPECT_GT(in_shadow, 0);
}

TEST_F(Faces, AskForNoShadowWhereItIsDarkAnyway) {
    frame_.spheres[1] = vec4(-90.0F, 190.0F, 60.0F, 15.0F);
    for (shaders::VertexData& vertex : vertices_)
        vertex.place.w = 0.0F;
    choose();
    EXPECT_FALSE(faces_.indices.empty());
    EXPECT_EQ(faces_.plain, faces_.indices.size());
}

TEST_F(Faces, AreCompleteIfTheEyeIsAmongThem) {
    camera_ = {.eye_mm = {0.0F, 100.0F, 40.0F}, .target_mm = {0.0F, 80.0F, 0.0F}, .near_mm = 500.0F};
    EXPECT_EQ(choose().indices.size(), 6 * (kRows - 1) * kSectors);
}

TEST_F(Faces, AreEmptyWithoutTwoRows) {
    vertices_.resize(kSectors + 1);
    EXPECT_TRUE(choose().indices.empty());
    EXPECT_EQ(faces_.plain, 0U);
}

}  // namespace
}  // namespace onggi::render
