#include "engine/render/profile_mesh.h"

#include <gtest/gtest.h>

namespace onggi::render {
namespace {

Profile drum() {
    return {.points = {{0.0F, 0.0F}, {50.0F, 0.0F}, {50.0F, 100.0F}, {0.0F, 100.0F}}};
}

double volume_of(const Mesh& mesh) {
    double six = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const dvec3 a(mesh.vertices[mesh.indices[i]].position_mm);
        const dvec3 b(mesh.vertices[mesh.indices[i + 1]].position_mm);
        const dvec3 c(mesh.vertices[mesh.indices[i + 2]].position_mm);
        six += glm::dot(a, glm::cross(b, c));
    }
    return six / 6.0;
}

TEST(ProfileMesh, EnclosesTheSolidItWasTurnedFrom) {
    // Positive only if every triangle is wound to face outwards; 64 corners hold 99.84 % of the circle.
    EXPECT_NEAR(volume_of(turned_mesh(drum(), 64)), 3.14159265 * 50 * 50 * 100 * 0.9984, 300.0);
    EXPECT_NEAR(volume_of(sphere_mesh(32, 64)), 4.18879 * 0.995, 0.01);
}

TEST(ProfileMesh, FacesItsNormalsTheWayItsTrianglesFace) {
    for (const Mesh& mesh : {turned_mesh(drum(), 24), sphere_mesh(12, 24)}) {
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto& a = mesh.vertices[mesh.indices[i]];
            const auto& b = mesh.vertices[mesh.indices[i + 1]];
            const auto& c = mesh.vertices[mesh.indices[i + 2]];
            const vec3 face = glm::cross(b.position_mm - a.position_mm, c.position_mm - a.position_mm);
            EXPECT_GT(glm::dot(face, a.normal), 0.0F);
        }
    }
}

TEST(ProfileMesh, KeepsCornersSharpAndCurvesSmooth) {
    // A drum's four points: the two rims become two rows each.
    EXPECT_EQ(turned_mesh(drum(), 8).vertices.size(), 6U * 9U);
    Profile rounded = drum();
    rounded.points = {{0.0F, 0.0F}, {50.0F, 0.0F}};
    add_rounded(rounded, {50.0F, 0.0F}, {50.0F, 100.0F}, {0.0F, 100.0F}, 10.0F, 8);
    rounded.points.push_back({0.0F, 100.0F});
    EXPECT_EQ(turned_mesh(rounded, 8).vertices.size(), (2U + 9U + 2U) * 9U);
}

TEST(ProfileMesh, RoundsACornerBetweenItsSides) {
    Profile profile;
    add_rounded(profile, {50.0F, 0.0F}, {50.0F, 100.0F}, {0.0F, 100.0F}, 10.0F, 4);
    EXPECT_NEAR(profile.points.front().x, 50.0F, 1e-4F);
    EXPECT_NEAR(profile.points.front().y, 90.0F, 1e-4F);
    EXPECT_NEAR(profile.points.back().x, 40.0F, 1e-4F);
    EXPECT_NEAR(profile.points.back().y, 100.0F, 1e-4F);
    for (const vec2& point : profile.points)
        EXPECT_NEAR(glm::length(point - vec2(40.0F, 90.0F)), 10.0F, 1e-4F);
}

TEST(ProfileMesh, SeesTheWholeSkyAloneAndLessBesideAWall) {
    const std::array alone{drum()};
    std::array mesh{turned_mesh(drum(), 8)};
    set_open_sky(alone, mesh, 8);
    for (const Mesh::Vertex& vertex : mesh[0].vertices)
        EXPECT_EQ(vertex.open_sky, 1.0F);

    // The same drum in a deep pan: its side sees less, its top as much.
    const Profile pan{.points = {{60.0F, 100.0F}, {60.0F, -1.0F}, {0.0F, -1.0F}}};
    const std::array both{drum(), pan};
    std::array meshes{turned_mesh(drum(), 8), turned_mesh(pan, 8)};
    set_open_sky(both, meshes, 8);
    float least = 1.0F;
    for (const Mesh::Vertex& vertex : meshes[0].vertices)
        least = std::min(least, vertex.open_sky);
    EXPECT_LT(least, 0.3F);
    EXPECT_EQ(meshes[0].vertices.back().open_sky, 1.0F);
}

}  // namespace
}  // namespace onggi::render
