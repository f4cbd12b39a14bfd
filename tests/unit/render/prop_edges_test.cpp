#include "engine/render/shapes/prop_models.h"

#include <gtest/gtest.h>

#include "engine/render/profile_mesh.h"
#include "tests/unit/render/prop_samples.h"

namespace onggi::render {
namespace {

constexpr int kOutlineWidth = 640;
constexpr int kOutlineHeight = 360;
constexpr float kBallMm = 40.0F;

// A square of two triangles that share positions but no vertices.
PropMesh square() {
    PropMesh mesh;
    for (const vec3 at :
         {vec3(0, 0, 0), vec3(60, 0, 0), vec3(60, 60, 0), vec3(0, 0, 0), vec3(60, 60, 0), vec3(0, 60, 0)})
        mesh.vertices.push_back({.position_mm = at});
    mesh.indices = {0, 1, 2, 3, 4, 5};
    return mesh;
}

class PropEdges : public testing::Test {
  protected:
    std::vector<OutlinePiece> outline(const PropMesh& mesh, const mat4& place) const {
        const std::vector<vec4> planes = face_planes(mesh);
        const PlacedMesh placed{mesh, planes, place};
        std::vector<OutlinePiece> pieces;
        add_prop_edges(placed, faces_towards(placed, camera_.eye_mm), mesh_edges(mesh), nullptr,
                       {camera_, kOutlineWidth, kOutlineHeight}, pieces);
        return pieces;
    }
    static float length(const std::vector<OutlinePiece>& pieces) {
        float sum = 0.0F;
        for (const OutlinePiece& piece : pieces)
            sum += glm::length(vec2(piece.to) - vec2(piece.from));
        return sum;
    }
    Camera camera_{
        .eye_mm = {0.0F, 0.0F, 1000.0F}, .target_mm = {0.0F, 0.0F, 0.0F}, .vertical_fov_rad = 0.3F};
};

TEST_F(PropEdges, GoOnceRoundABallAndNowhereElse) {
    const std::vector<OutlinePiece> pieces = outline(ball(kBallMm, 24, 40), mat4(1.0F));
    ASSERT_FALSE(pieces.empty());
    const double px_per_mm = pixels_per_mm(camera_, kOutlineHeight);
    const auto radius_px = static_cast<float>(kBallMm * px_per_mm);
    for (const OutlinePiece& piece : pieces) {
        for (const vec4& end : {piece.from, piece.to})
            EXPECT_NEAR(glm::length(vec2(end) - vec2(kOutlineWidth / 2, kOutlineHeight / 2)), radius_px,
                        0.05F * radius_px);
    }
    // A polygon of the mesh's own edges zigzags about the circle.
    EXPECT_NEAR(length(pieces), 6.2832F * radius_px, 0.12F * 6.2832F * radius_px);
}

TEST_F(PropEdges, AreTheBorderOfASheetAndNotItsDiagonal) {
    const std::vector<OutlinePiece> pieces = outline(square(), mat4(1.0F));
    EXPECT_EQ(pieces.size(), 4U);
    EXPECT_NEAR(length(pieces), 4.0F * 60.0F * static_cast<float>(pixels_per_mm(camera_, kOutlineHeight)),
                0.5F);
    const mat4 turned = glm::rotate(mat4(1.0F), 3.14159265F, vec3(0.0F, 1.0F, 0.0F));
    EXPECT_TRUE(outline(square(), turned).empty()) << "its back is not drawn";
}

TEST_F(PropEdges, PassAllCornersOfAFineMeshInFewerPieces) {
    const Mesh fine = sphere_mesh(120, 200);
    PropMesh mesh;
    for (const Mesh::Vertex& vertex : fine.vertices)
        mesh.vertices.push_back({.position_mm = kBallMm * vertex.position_mm, .normal = vertex.normal});
    mesh.indices = fine.indices;
    const std::vector<OutlinePiece> pieces = outline(mesh, mat4(1.0F));
    EXPECT_LT(pieces.size(), 120U);
    const float px_per_mm = static_cast<float>(pixels_per_mm(camera_, kOutlineHeight));
    for (const OutlinePiece& piece : pieces) {
        const vec2 middle = 0.5F * (vec2(piece.from) + vec2(piece.to));
        EXPECT_NEAR(glm::length(middle - vec2(kOutlineWidth / 2, kOutlineHeight / 2)), kBallMm * px_per_mm,
                    0.6F);
    }
}

TEST_F(PropEdges, OfAHandInsideThePotAreLeftOut) {
    const std::vector<float> radii(200, 80.0F);
    const std::vector<float> inner(200, 75.0F);
    const Lathe lathe{.radii_mm = radii, .inner_mm = inner, .element_height_mm = 1.0F};
    LatheProfile profile;
    build_profile(lathe, profile);
    LatheSamples samples;
    sample_profile(profile, samples);
    camera_.eye_mm = {0.0F, 300.0F, 900.0F};
    const InsidePot inside(lathe, samples, camera_.eye_mm);
    const PropMesh mesh = ball(kBallMm, 24, 40);
    const std::vector<vec4> planes = face_planes(mesh);
    const mat4 place = glm::translate(mat4(1.0F), vec3(0.0F, 45.0F, 30.0F));
    const PlacedMesh placed{mesh, planes, place};
    const std::vector<std::uint8_t> towards = faces_towards(placed, camera_.eye_mm);
    std::vector<OutlinePiece> all;
    std::vector<OutlinePiece> seen;
    add_prop_edges(placed, towards, mesh_edges(mesh), nullptr, {camera_, kOutlineWidth, kOutlineHeight}, all);
    add_prop_edges(placed, towards, mesh_edges(mesh), &inside, {camera_, kOutlineWidth, kOutlineHeight},
                   seen);
    EXPECT_FALSE(all.empty());
    EXPECT_LT(length(seen), 0.5F * length(all));
}

}  // namespace
}  // namespace onggi::render
