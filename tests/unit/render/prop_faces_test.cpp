#include "engine/render/shapes/prop_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/render/lathe_samples.h"
#include "tests/unit/render/prop_samples.h"

namespace onggi::render {
namespace {

std::vector<std::uint32_t> chosen(const PropMesh& mesh, const mat4& place, vec3 eye_mm,
                                  const InsidePot* pot = nullptr) {
    const std::vector<vec4> planes = face_planes(mesh);
    std::vector<std::uint32_t> indices;
    const PlacedMesh placed{mesh, planes, place};
    choose_prop_faces(placed, faces_towards(placed, eye_mm), pot, indices);
    return indices;
}

// Whether the face is front-facing for the eye.
bool looks_at(const PropMesh& mesh, std::size_t first, const mat4& place, vec3 eye_mm) {
    const auto corner = [&](std::size_t i) {
        return vec3(place * vec4(mesh.vertices[mesh.indices[first + i]].position_mm, 1.0F));
    };
    const vec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    return glm::dot(normal, eye_mm - corner(0)) > 0.0F;
}

TEST(PropFaces, AreThoseThatLookAtTheEye) {
    const PropMesh mesh = ball(20.0F, 12, 20);
    const vec3 eye_mm(200.0F, 350.0F, 900.0F);
    const mat4 turned = glm::rotate(glm::translate(mat4(1.0F), vec3(90.0F, 70.0F, -20.0F)), 0.7F,
                                    glm::normalize(vec3(0.3F, 0.8F, -0.2F)));
    const mat4 mirrored = glm::scale(turned, vec3(1.0F, 1.0F, -1.0F));
    for (const mat4& place : {turned, mirrored}) {
        std::vector<std::uint32_t> wanted;
        for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
            if (looks_at(mesh, first, place, eye_mm))
                wanted.insert(wanted.end(),
                              {mesh.indices[first], mesh.indices[first + 1], mesh.indices[first + 2]});
        }
        EXPECT_EQ(chosen(mesh, place, eye_mm), wanted);
        EXPECT_LT(wanted.size(), mesh.indices.size() * 6 / 10);
        EXPECT_GT(wanted.size(), mesh.indices.size() * 3 / 10);
    }
}

TEST(PropFaces, LeaveOutAHandThatThePotIsAround) {
    const Cylinder pot(50.0F, 5.0F, 10.0F, 150.0F);
    const LatheSamples samples = samples_of(pot.profile());
    const PropMesh mesh = ball(20.0F, 12, 20);
    const vec3 eye_mm(0.0F, 350.0F, 1100.0F);
    const InsidePot inside(pot.lathe(), samples, eye_mm);
    const auto left_out = [&](vec3 place_mm) {
        const mat4 place = glm::translate(mat4(1.0F), place_mm);
        const std::size_t all = chosen(mesh, place, eye_mm).size();
        return static_cast<double>(all - chosen(mesh, place, eye_mm, &inside).size()) /
               static_cast<double>(all);
    };
    EXPECT_EQ(left_out({0.0F, 60.0F, 0.0F}), 1.0);
    EXPECT_EQ(left_out({0.0F, 60.0F, 120.0F}), 0.0);
    EXPECT_EQ(left_out({0.0F, 60.0F, -120.0F}), 0.0) << "parts behind the pot are not inside it";
    EXPECT_EQ(left_out({0.0F, 175.0F, 0.0F}), 0.0);
    const double half = left_out({0.0F, 140.0F, 0.0F});
    EXPECT_GT(half, 0.2);
    EXPECT_LT(half, 0.8) << "its upper half looks out of the mouth";
}

class APot : public testing::Test {
  protected:
    // A belly under a neck.
    APot() {
        for (std::size_t i = 0; i < pot_.outer.size(); ++i) {
            const float y_mm = 0.15F * static_cast<float>(i);
            pot_.outer[i] = 45.0F + 20.0F * std::sin(0.03F * y_mm);
            if (pot_.inner[i] > 0.0F) pot_.inner[i] = pot_.outer[i] - 5.0F;
        }
        sample_profile(built(), samples_);
    }
    [[nodiscard]] LatheProfile built() const { return pot_.profile(); }
    // Steps along the ray.
    [[nodiscard]] bool is_behind_the_wall(vec3 point_mm) const {
        for (float fraction = 0.0F; fraction < 0.2F; fraction += 0.0002F) {
            const vec3 at = point_mm + (eye_mm_ - point_mm) * fraction;
            if (at.y >= pot_.top.back()) return false;
            const auto ring = static_cast<std::size_t>(at.y / 0.15F);
            const float radius_mm = std::hypot(at.x, at.z);
            if (radius_mm < pot_.outer[ring] && radius_mm > pot_.inner[ring]) return true;
        }
        return false;
    }
    Cylinder pot_{50.0F, 5.0F, 10.0F, 150.0F};
    LatheSamples samples_;
    vec3 eye_mm_{0.0F, 350.0F, 1100.0F};
};

TEST_F(APot, HidesOnlyAndMostlyTrianglesBehindItsWall) {
    const InsidePot inside(pot_.lathe(), samples_, eye_mm_);
    std::mt19937 random(11);
    std::uniform_real_distribution<float> wide_mm(-80.0F, 80.0F);
    std::uniform_real_distribution<float> high_mm(-10.0F, 170.0F);
    int hidden = 0;
    int inside_and_behind = 0;
    for (int round = 0; round < 20000; ++round) {
        const vec3 point{wide_mm(random), high_mm(random), wide_mm(random)};
        if (inside.hides(point)) {
            ++hidden;
            ASSERT_TRUE(is_behind_the_wall(point)) << point.x << ", " << point.y << ", " << point.z;
        }
        if (point.y <= 10.0F || point.y >= 150.0F) continue;
        const float inner_mm = pot_.inner[static_cast<std::size_t>(point.y / 0.15F)];
        if (std::hypot(point.x, point.z) < inner_mm && is_behind_the_wall(point)) ++inside_and_behind;
    }
    EXPECT_GT(inside_and_behind, 1000);
    EXPECT_GT(hidden, inside_and_behind * 8 / 10);
}

TEST_F(APot, HidesLessWhereItsWallIsDented) {
    const vec3 close_to_the_wall(0.0F, 50.0F, 55.0F);
    EXPECT_TRUE(InsidePot(pot_.lathe(), samples_, eye_mm_).hides(close_to_the_wall));
    const std::vector<float> dents_mm(kDentSectors * 4, -12.0F);
    Lathe dented = pot_.lathe();
    dented.dents_mm = dents_mm;
    EXPECT_FALSE(InsidePot(dented, samples_, eye_mm_).hides(close_to_the_wall));
}

TEST_F(APot, HidesNoTriangleIfCutOpenOrSeenFromBelowItsRim) {
    const vec3 within(0.0F, 50.0F, 0.0F);
    EXPECT_TRUE(InsidePot(pot_.lathe(), samples_, eye_mm_).hides(within));
    Lathe open = pot_.lathe();
    open.cut = LatheCut{};
    EXPECT_FALSE(InsidePot(open, samples_, eye_mm_).hides(within));
    EXPECT_FALSE(InsidePot(pot_.lathe(), samples_, {0.0F, 100.0F, 1100.0F}).hides(within));
}

}  // namespace
}  // namespace onggi::render
