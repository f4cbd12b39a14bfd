#include "engine/render/shapes/lathe_edges.h"

#include <gtest/gtest.h>

#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_mesh.h"
#include "tests/unit/render/lathe_samples.h"

namespace onggi::render {
namespace {

constexpr int kEdgesWidth = 1280;
constexpr int kEdgesHeight = 720;

struct Outlines {
    explicit Outlines(vec3 eye_mm) : camera{.eye_mm = eye_mm, .target_mm = {0.0F, 50.0F, 0.0F}} {
        const Cylinder pot;
        const Lathe lathe = pot.lathe();
        LatheProfile profile;
        build_profile(lathe, profile);
        const LatheSamples samples = samples_of(profile);
        const LatheRows chosen =
            choose_rows(profile, points_seen(profile, eye_mm, 0.0F), {.tolerance_mm = 0.05F});
        std::vector<shaders::RowData> rows;
        fill_rows(lathe, profile, samples, chosen, rows);
        fill_vertices(
            {.lathe = lathe, .profile = profile, .samples = samples, .chosen = chosen, .rows = rows}, {},
            even_sectors(lathe, kSectors), vertices);
        add_grid_edges(vertices, kSectors, false, {camera, kEdgesWidth, kEdgesHeight}, edges);
    }
    Camera camera;
    std::vector<shaders::VertexData> vertices;
    std::vector<OutlinePiece> edges;
};

TEST(LatheEdges, RunUpBothSidesOfAWallRoundItsFootAndRoundItsRim) {
    const Outlines outlines({0.0F, 300.0F, 900.0F});
    const auto left = project(outlines.camera, kEdgesWidth, kEdgesHeight, {-50.0, 50.0, 0.0});
    const auto foot = project(outlines.camera, kEdgesWidth, kEdgesHeight, {0.0, 0.0, 50.0});
    const auto rim = project(outlines.camera, kEdgesWidth, kEdgesHeight, {0.0, 100.0, -47.5});
    ASSERT_TRUE(left && foot && rim);
    const auto distance_to = [&](const dvec2& pixel) {
        double least = 1e9;
        for (const OutlinePiece& edge : outlines.edges) {
            const dvec2 a(edge.from.x, edge.from.y);
            const dvec2 b(edge.to.x, edge.to.y);
            const double fraction = std::clamp(glm::dot(pixel - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            least = std::min(least, glm::length(pixel - a - fraction * (b - a)));
        }
        return least;
    };
    EXPECT_LT(distance_to(left->pixel), 1.0);
    EXPECT_LT(distance_to(foot->pixel), 1.0);
    EXPECT_LT(distance_to(rim->pixel), 1.5);
    const auto middle = project(outlines.camera, kEdgesWidth, kEdgesHeight, {0.0, 50.0, 50.0});
    EXPECT_GT(distance_to(middle->pixel), 20.0) << "no outline across the face of the pot";
    EXPECT_LT(outlines.edges.size(), 400U);
}

TEST(LatheEdges, LieALittleNearerThanTheFacesTheyBelongTo) {
    const Outlines outlines({0.0F, 300.0F, 900.0F});
    const mat4 matrix = view_projection(outlines.camera, kEdgesWidth, kEdgesHeight);
    float nearest = 1.0F;
    float furthest = 0.0F;
    for (const shaders::VertexData& vertex : outlines.vertices) {
        const vec4 clip = matrix * vec4(vec3(vertex.place), 1.0F);
        nearest = std::min(nearest, clip.z / clip.w);
        furthest = std::max(furthest, clip.z / clip.w);
    }
    for (const OutlinePiece& edge : outlines.edges) {
        EXPECT_GT(edge.from.z, nearest - 0.01F);
        EXPECT_LT(edge.from.z, furthest);
    }
}

TEST(LatheEdges, AreNoMoreThanAFrameHasTimeFor) {
    const Outlines outlines({0.0F, 300.0F, 900.0F});
    ASSERT_GT(outlines.edges.size(), 3U);
    std::vector<OutlinePiece> edges(kMaxEdges - 3);
    add_grid_edges(outlines.vertices, kSectors, false, {outlines.camera, kEdgesWidth, kEdgesHeight}, edges);
    EXPECT_EQ(edges.size(), kMaxEdges);
}

}  // namespace
}  // namespace onggi::render
