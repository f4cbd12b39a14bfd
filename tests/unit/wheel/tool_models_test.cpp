#include "game/wheel/tool_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::wheel {
namespace {

TEST(ToolModels, AreCompleteForBothHands) {
    const auto library = load_tool_models(test::in_checkout("assets/tools"));
    ASSERT_TRUE(library) << library.error().message;
    ASSERT_EQ((*library)->size(), 2 * kToolModels);
    for (const render::PropModel& model : **library) {
        std::size_t triangles = 0;
        for (const render::PropMesh& mesh : model.meshes)
            triangles += mesh.indices.size() / 3;
        EXPECT_GT(triangles, 60U);
        EXPECT_LT(triangles, 5000U) << "more than a software renderer has time for";
    }
}

TEST(ToolModels, TouchTheClayAtTheirOriginAndStayOnTheirSide) {
    const auto library = load_tool_models(test::in_checkout("assets/tools"));
    ASSERT_TRUE(library) << library.error().message;
    for (const ToolModel tool : {ToolModel::kHandOuter, ToolModel::kHandInner, ToolModel::kRib,
                                 ToolModel::kSponge, ToolModel::kTrimmer, ToolModel::kStick}) {
        const render::PropModel& model = (**library)[library_place(tool, false)];
        float leftmost_mm = 1e9F;
        for (const render::Box& box : model.boxes_mm)
            leftmost_mm = std::min(leftmost_mm, box.low.x);
        EXPECT_NEAR(leftmost_mm, 0.0F, 6.0F) << static_cast<std::size_t>(tool);
        float nearest = 1e9F;
        for (const render::PropMesh& mesh : model.meshes) {
            for (const render::PropMesh::Vertex& vertex : mesh.vertices)
                nearest = std::min(nearest, glm::length(vertex.position_mm));
        }
        EXPECT_LT(nearest, 8.0F) << static_cast<std::size_t>(tool);
    }
}

TEST(ToolModels, AreWholeToTheEndsOfTheirHandles) {
    const auto library = load_tool_models(test::in_checkout("assets/tools"));
    ASSERT_TRUE(library) << library.error().message;
    const auto reach_mm = [&](ToolModel tool) {
        float farthest = 0.0F;
        for (const render::PropMesh& mesh : (**library)[library_place(tool, false)].meshes) {
            for (const render::PropMesh::Vertex& vertex : mesh.vertices)
                farthest = std::max(farthest, glm::length(vertex.position_mm));
        }
        return farthest;
    };
    EXPECT_GT(reach_mm(ToolModel::kTrimmer), 155.0F);
    EXPECT_GT(reach_mm(ToolModel::kStick), 290.0F);
    EXPECT_GT(reach_mm(ToolModel::kWire), 190.0F);
}

TEST(ToolModels, HaveNormalsThatFaceAsTheirTrianglesDoAlsoMirrored) {
    const auto library = load_tool_models(test::in_checkout("assets/tools"));
    ASSERT_TRUE(library) << library.error().message;
    for (const render::PropModel& model : **library) {
        for (const render::PropMesh& mesh : model.meshes) {
            std::size_t against = 0;
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
                const vec3 face = glm::cross(corner(1).position_mm - corner(0).position_mm,
                                             corner(2).position_mm - corner(0).position_mm);
                if (glm::dot(face, corner(0).normal + corner(1).normal + corner(2).normal) < 0.0F) ++against;
            }
            // A sponge is rough, and thinned out: a few of its slivers stand across. None of the rest may.
            EXPECT_LE(against * 50, mesh.indices.size() / 3) << "more than one in fifty is inside out";
        }
    }
}

std::size_t triangles_of(const render::PropModel& model) {
    std::size_t corners = 0;
    for (const render::PropMesh& mesh : model.meshes)
        corners += mesh.indices.size();
    return corners / 3;
}

// Small pictures show hands of about half the triangles, in the same outline.
TEST(ToolModels, HandsHaveAboutHalfOfTheirTrianglesInSmallPicturesAlone) {
    const auto library = load_tool_models(test::in_checkout("assets/tools"));
    ASSERT_TRUE(library) << library.error().message;
    constexpr double kPxPerMm720 = 1.81;  // on the wheel, at 1280x720
    constexpr double kPxPerMm1080 = 2.71;
    for (const ToolModel hand : {ToolModel::kHandOuter, ToolModel::kHandInner}) {
        EXPECT_EQ(model_at_scale(hand, kPxPerMm1080), hand);
        const ToolModel far = model_at_scale(hand, kPxPerMm720);
        for (const bool left : {false, true}) {
            const render::PropModel& whole = (**library)[library_place(hand, left)];
            const render::PropModel& thin = (**library)[library_place(far, left)];
            const auto ratio =
                static_cast<double>(triangles_of(thin)) / static_cast<double>(triangles_of(whole));
            EXPECT_GT(ratio, 0.45);
            EXPECT_LT(ratio, 0.65);
            ASSERT_EQ(whole.boxes_mm.size(), thin.boxes_mm.size());
        }
    }
    EXPECT_EQ(model_at_scale(ToolModel::kSponge, kPxPerMm720), ToolModel::kSponge);
}

TEST(ToolModels, RejectsAFolderWithoutModelsAndAnInvalidFile) {
    test::TemporaryFolder folder;
    auto library = load_tool_models(folder.path());
    ASSERT_FALSE(library);
    EXPECT_NE(library.error().message.find("hand_outer.glb"), std::string::npos) << library.error().message;
    std::ofstream(folder.path() / "hand_outer.glb") << "not a model";
    library = load_tool_models(folder.path());
    ASSERT_FALSE(library);
    EXPECT_EQ(library.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(library.error().message.find("glTF"), std::string::npos) << library.error().message;
}

}  // namespace
}  // namespace onggi::wheel
