#include "engine/asset/gltf.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/mesh_check.h"
#include "tests/unit/asset/sample_mesh.h"

namespace onggi::asset {
namespace {

GltfContent content() {
    GltfContent content;
    content.name = "pot";
    content.generator = "test 1";
    content.mesh = tetrahedron();
    content.material = {"clay", dvec3(0.5, 0.25, 0.125), 0.75, 0.0};
    content.extras = {{"height_mm", 100.0}, {"title", std::string("first")}};
    return content;
}

support::GlbFile written(const GltfContent& content) {
    const Result<std::vector<std::byte>> bytes = encode_glb(content);
    EXPECT_TRUE(bytes) << (bytes ? "" : bytes.error().message);
    if (!bytes) return {};
    const Result<support::GlbFile> file = support::read_glb(*bytes);
    EXPECT_TRUE(file) << (file ? "" : file.error().message);
    return file ? *file : support::GlbFile{};
}

TEST(Glb, HoldsTheMeshBitForBit) {
    const support::GlbFile file = written(content());
    const Mesh mesh = tetrahedron();
    ASSERT_EQ(file.mesh.positions_m.size(), mesh.positions_m.size());
    for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
        EXPECT_EQ(file.mesh.positions_m[i], dvec3(mesh.positions_m[i]));
        EXPECT_EQ(file.mesh.normals[i], dvec3(mesh.normals[i]));
    }
    EXPECT_EQ(file.mesh.indices, mesh.indices);
    EXPECT_EQ(file.stated_min_m, dvec3(vec3(0.0F)));
    EXPECT_EQ(file.stated_max_m, dvec3(vec3(0.1F)));
}

TEST(Glb, HoldsNamesMaterialAndExtras) {
    const nlohmann::json json = written(content()).json;
    EXPECT_EQ(json.at("asset").at("generator"), "test 1");
    EXPECT_EQ(json["asset"].at("extras"), nlohmann::json({{"height_mm", 100.0}, {"title", "first"}}));
    EXPECT_EQ(json.at("nodes").at(0).at("name"), "pot");
    const nlohmann::json& material = json.at("materials").at(0);
    EXPECT_EQ(material.at("name"), "clay");
    EXPECT_EQ(material.at("pbrMetallicRoughness").at("baseColorFactor"),
              nlohmann::json({0.5, 0.25, 0.125, 1.0}));
    EXPECT_EQ(material["pbrMetallicRoughness"].at("roughnessFactor"), 0.75);
    EXPECT_EQ(material["pbrMetallicRoughness"].at("metallicFactor"), 0.0);
}

TEST(Glb, LeavesOutAnEmptyList) {
    GltfContent bare = content();
    bare.extras.emplace_back("marks_mm", std::vector<double>());
    EXPECT_EQ(written(bare).json, written(content()).json);
}

TEST(Glb, TellsEachViewsTarget) {
    const nlohmann::json json = written(content()).json;
    for (const nlohmann::json& view : json.at("bufferViews"))
        EXPECT_TRUE(view.contains("target")) << view;
}

TEST(Glb, TakesWideIndicesOnlyWhereNarrowOnesDoNotReach) {
    GltfContent many = content();
    EXPECT_EQ(written(many).index_bytes, 2U);
    const auto fill_to = [&many](std::size_t vertices) {
        many.mesh.positions_m.resize(vertices, vec3(0.05F));
        many.mesh.normals.resize(vertices, vec3(0.0F, 1.0F, 0.0F));
        many.mesh.indices.back() = static_cast<std::uint32_t>(vertices - 1);
    };
    fill_to(65535);
    EXPECT_EQ(written(many).index_bytes, 2U);
    fill_to(65536);
    const support::GlbFile wide = written(many);
    EXPECT_EQ(wide.index_bytes, 4U);
    EXPECT_EQ(wide.mesh.indices.back(), 65535U);
}

TEST(Glb, SurvivesNamesThatAreNoUtf8) {
    GltfContent odd = content();
    odd.name = "caf\xE9";
    odd.generator = "\xFF\xFE";
    odd.material.name = "\xC0\x80";
    odd.extras = {{"\xED\xA0\x80", std::string("\xF5")}};
    const nlohmann::json json = written(odd).json;
    EXPECT_EQ(json.at("nodes").at(0).at("name"), "caf\xEF\xBF\xBD");
}

void expect_refused(const GltfContent& content, const std::string& words) {
    const Result<std::vector<std::byte>> bytes = encode_glb(content);
    ASSERT_FALSE(bytes) << words;
    EXPECT_EQ(bytes.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(bytes.error().message.find(words), std::string::npos) << bytes.error().message;
}

TEST(Glb, RejectsAnInvalidMesh) {
    GltfContent bad = content();
    bad.mesh.indices.clear();
    expect_refused(bad, "at least one triangle");
    bad = content();
    bad.mesh.indices.pop_back();
    expect_refused(bad, "three indices a triangle");
    bad = content();
    bad.mesh.indices[5] = 4;
    expect_refused(bad, "triangle 1: expected an index below 4, found 4");
    bad = content();
    bad.mesh.normals.pop_back();
    expect_refused(bad, "a normal for each of 4 vertices, found 3");
}

TEST(Glb, RejectsNumbersThatJsonHasNoWordFor) {
    GltfContent bad = content();
    bad.mesh.positions_m[2].y = std::numeric_limits<float>::quiet_NaN();
    expect_refused(bad, "vertex 2: expected finite");
    bad = content();
    bad.mesh.normals[1].x = std::numeric_limits<float>::infinity();
    expect_refused(bad, "vertex 1: expected finite");
    bad = content();
    bad.extras[0].second = std::numeric_limits<double>::quiet_NaN();
    expect_refused(bad, "field height_mm");
    bad = content();
    bad.material.roughness = 1.5;
    expect_refused(bad, "within 0 to 1");
    bad.material.roughness = std::numeric_limits<double>::quiet_NaN();
    expect_refused(bad, "within 0 to 1");
}

}  // namespace
}  // namespace onggi::asset
