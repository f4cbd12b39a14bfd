#include "engine/asset/gltf_read.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/support/glb_builder.h"
#include "tests/support/places.h"
#include "tests/unit/asset/sample_mesh.h"

namespace onggi::asset {
namespace {

using nlohmann::json;

// One triangle in the plane z = 0, facing +Z, with what a test changes in it.
struct Sample {
    std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::vector<std::uint16_t> indices{0, 1, 2};
    json tree = json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "tool", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1,1,0]},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": 44}]})");

    [[nodiscard]] std::vector<std::byte> bytes() const {
        test::GlbBinary binary;
        binary.add(positions);
        binary.add(indices);
        return test::glb_of(tree.dump(), binary.bytes());
    }
};

GltfModel read(const Sample& sample) {
    auto model = decode_glb(sample.bytes(), "sample.glb");
    EXPECT_TRUE(model) << (model ? "" : model.error().message);
    return model ? std::move(*model) : GltfModel{};
}

void expect_refused(std::span<const std::byte> bytes, std::string_view words, const GltfLimits& limits = {}) {
    const auto model = decode_glb(bytes, "sample.glb", limits);
    ASSERT_FALSE(model) << "taken, where this was to be refused: " << words;
    EXPECT_EQ(model.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(model.error().message.find(words), std::string::npos) << model.error().message;
    EXPECT_EQ(model.error().message.rfind("sample.glb: ", 0), 0U) << model.error().message;
    EXPECT_EQ(model.error().message.find('\n'), std::string::npos) << model.error().message;
}
void expect_refused(const Sample& sample, std::string_view words, const GltfLimits& limits = {}) {
    expect_refused(sample.bytes(), words, limits);
}

struct GltfRead : testing::Test {
    Sample sample;
};

TEST_F(GltfRead, ReadsTheWritersFilesBack) {
    const Mesh mesh = tetrahedron();
    const auto bytes = encode_glb({.name = "pot",
                                   .generator = "test",
                                   .mesh = mesh,
                                   .material = {"clay", dvec3(0.5, 0.25, 0.125), 0.75, 0.5},
                                   .extras = {}});
    ASSERT_TRUE(bytes);
    const auto model = decode_glb(*bytes, "pot.glb");
    ASSERT_TRUE(model) << model.error().message;
    ASSERT_EQ(model->parts.size(), 1U);
    EXPECT_EQ(model->parts[0].node, "pot");
    EXPECT_EQ(model->parts[0].mesh.positions_m, mesh.positions_m);
    EXPECT_EQ(model->parts[0].mesh.indices, mesh.indices);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        EXPECT_LT(glm::distance(model->parts[0].mesh.normals[i], mesh.normals[i]), 1e-6F);
    ASSERT_EQ(model->materials.size(), 1U);
    EXPECT_EQ(model->materials[0].name, "clay");
    EXPECT_EQ(model->materials[0].base_colour_linear, dvec3(0.5, 0.25, 0.125));
    EXPECT_EQ(model->materials[0].roughness, 0.75);
    EXPECT_EQ(model->materials[0].metallic, 0.5);
}

TEST_F(GltfRead, ReadsTheWorkshop) {
    std::ifstream file(test::in_checkout("assets/workshop/room.glb"), std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    ASSERT_FALSE(text.empty());
    const auto model = decode_glb(std::as_bytes(std::span(text)), "room.glb");
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_GT(model->parts.size(), 10U);
    EXPECT_GT(model->materials.size(), 10U);
    for (const GltfPart& part : model->parts) {
        ASSERT_GE(part.material, 0) << part.node;
        for (const vec3& normal : part.mesh.normals)
            ASSERT_NEAR(glm::length(normal), 1.0F, 1e-3F) << part.node;
    }
}

TEST_F(GltfRead, ComputesMissingNormals) {
    const GltfModel model = read(Sample{});
    for (const vec3& normal : model.parts.at(0).mesh.normals)
        EXPECT_EQ(normal, vec3(0.0F, 0.0F, 1.0F));
}

TEST_F(GltfRead, PlacesAMeshByAllTheNodesAboveIt) {
    // A quarter turn about +Z, then ten along +X and twice as large; the mesh hangs below, one up.
    sample.tree["nodes"] = json::parse(R"([
        {"children": [1], "translation": [10, 0, 0], "rotation": [0, 0, 0.70710678, 0.70710678], "scale": [2, 2, 2]},
        {"mesh": 0, "name": "below", "translation": [0, 1, 0]}])");
    const GltfPart part = read(sample).parts.at(0);
    EXPECT_EQ(part.node, "below");
    EXPECT_LT(glm::distance(part.mesh.positions_m[0], vec3(8.0F, 0.0F, 0.0F)), 1e-5F);
    EXPECT_LT(glm::distance(part.mesh.positions_m[1], vec3(8.0F, 2.0F, 0.0F)), 1e-5F);
}

TEST_F(GltfRead, AcceptsAMatrixInsteadOfItsParts) {
    sample.tree["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1};
    EXPECT_EQ(read(sample).parts.at(0).mesh.positions_m[0], vec3(3.0F, 4.0F, 5.0F));
}

TEST_F(GltfRead, KeepsTrianglesFacingOutwardsBelowAMirror) {
    sample.tree["nodes"][0]["scale"] = {-1, 1, 1};
    const Mesh mesh = read(sample).parts.at(0).mesh;
    const vec3 a = mesh.positions_m[mesh.indices[0]];
    const vec3 b = mesh.positions_m[mesh.indices[1]];
    const vec3 c = mesh.positions_m[mesh.indices[2]];
    EXPECT_GT(glm::cross(b - a, c - a).z, 0.0F);
    EXPECT_GT(mesh.normals[0].z, 0.9F);
}

TEST_F(GltfRead, ReadsStripsAndFans) {
    sample.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    sample.indices = {0, 1, 2, 3};
    sample.tree["accessors"][0]["count"] = 4;
    sample.tree["accessors"][1]["count"] = 4;
    sample.tree["bufferViews"] = json::parse(
        R"([{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 8}])");
    sample.tree["buffers"][0]["byteLength"] = 56;
    sample.tree["meshes"][0]["primitives"][0]["mode"] = 5;
    const GltfModel strip = read(sample);
    EXPECT_EQ(strip.parts.at(0).mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
    for (const vec3& normal : strip.parts.at(0).mesh.normals)
        EXPECT_EQ(normal, vec3(0.0F, 0.0F, 1.0F));
    sample.tree["meshes"][0]["primitives"][0]["mode"] = 6;
    EXPECT_EQ(read(sample).parts.at(0).mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    sample.indices = {0, 1, 1, 2};  // a strip of two parts is joined by triangles without an area
    sample.tree["meshes"][0]["primitives"][0]["mode"] = 5;
    expect_refused(sample, "at least one triangle");
    sample.tree["meshes"][0]["primitives"][0]["mode"] = 7;
    expect_refused(sample, "expected triangles, found mode 7");
}

TEST_F(GltfRead, SkipsAndNamesPartsWithoutASurface) {
    sample.tree["nodes"].push_back({{"mesh", 1}});
    sample.tree["nodes"].push_back({{"mesh", 2}});
    sample.tree["scenes"][0]["nodes"] = {0, 1, 2, 1};
    sample.tree["meshes"].push_back(json::parse(R"({"name": "grid", "primitives": [
        {"attributes": {"POSITION": 0}, "mode": 1}, {"attributes": {"POSITION": 0}, "mode": 3}]})"));
    sample.tree["meshes"].push_back(
        json::parse(R"({"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]})"));
    const GltfModel model = read(sample);
    EXPECT_EQ(model.parts.size(), 1U);
    EXPECT_EQ(model.left_out, (std::vector<std::string>{"mesh 'grid': lines", "mesh 2: points"}));
    sample.tree["scenes"][0]["nodes"] = {1, 2};
    expect_refused(sample, "expected triangles, found none");
}

TEST_F(GltfRead, TakesAFileWithoutScenesByItsRootNodes) {
    sample.tree.erase("scene");
    sample.tree.erase("scenes");
    sample.tree["nodes"][0]["children"] = {1};
    sample.tree["nodes"].push_back({{"mesh", 0}});
    EXPECT_EQ(read(sample).parts.size(), 2U) << "a child once, by its parent";
}

TEST_F(GltfRead, DoesWithoutRequiredExtensionsOfTheSurfaceAlone) {
    for (const char* extension : {"KHR_materials_unlit", "KHR_texture_transform", "KHR_materials_clearcoat",
                                  "EXT_texture_webp", "KHR_lights_punctual"}) {
        sample.tree["extensionsUsed"] = sample.tree["extensionsRequired"] = {extension};
        EXPECT_EQ(read(sample).left_out, std::vector<std::string>{std::string("extension ") + extension});
    }
    for (const char* extension :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"}) {
        sample.tree["extensionsUsed"] = sample.tree["extensionsRequired"] = {extension};
        expect_refused(sample, "expected no required extension of the shape, found ");
    }
}

TEST_F(GltfRead, ReadsColoursAsLinearShares) {
    sample.tree["accessors"].push_back(
        {{"bufferView", 2}, {"componentType", 5121}, {"normalized", true}, {"count", 3}, {"type", "VEC4"}});
    sample.tree["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 44}, {"byteLength", 12}});
    sample.tree["buffers"][0]["byteLength"] = 56;
    sample.tree["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 2;
    test::GlbBinary binary;
    binary.add(sample.positions);
    binary.add(sample.indices);
    binary.add(std::vector<std::uint8_t>{255, 0, 51, 255, 1, 2, 3, 4, 5, 6, 7, 8});
    const auto model = decode_glb(test::glb_of(sample.tree.dump(), binary.bytes()), "sample.glb");
    ASSERT_TRUE(model) << model.error().message;
    ASSERT_EQ(model->parts[0].colours.size(), 3U);
    EXPECT_EQ(model->parts[0].colours[0], vec4(1.0F, 0.0F, 0.2F, 1.0F));
}

TEST_F(GltfRead, RejectsOtherFiles) {
    expect_refused(std::span<const std::byte>(), "binary glTF 2.0");
    expect_refused(std::as_bytes(std::span("{\"asset\": {\"version\": \"2.0\"}}")), "binary glTF 2.0");
    std::vector<std::byte> old = Sample{}.bytes();
    old[4] = std::byte{1};
    expect_refused(old, "binary glTF 2.0");
}

TEST_F(GltfRead, RejectsAFileCutAnywhere) {
    const std::vector<std::byte> whole = Sample{}.bytes();
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        expect_refused(std::span(whole).first(length), "expected");
    }
}

TEST_F(GltfRead, SurvivesAnyByteChanged) {
    const std::vector<std::byte> whole = Sample{}.bytes();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const auto value : {std::byte{0}, std::byte{'9'}, std::byte{'-'}, std::byte{0xFF}}) {
            std::vector<std::byte> changed = whole;
            changed[at] = value;
            const auto model = decode_glb(changed, "changed.glb");
            if (!model) {
                ASSERT_EQ(model.error().kind, ErrorKind::kBadInput);
                ASSERT_EQ(model.error().message.find('\n'), std::string::npos);
            }
        }
    }
}

TEST_F(GltfRead, RejectsFilesBeyondItsLimits) {
    expect_refused(Sample{}, "at most 100 bytes", {.max_bytes = 100});
    expect_refused(Sample{}, "1 to 2 elements", {.max_vertices = 2});
    Sample two;
    two.tree["nodes"][0]["children"] = {1, 1, 1};
    two.tree["nodes"].push_back({{"mesh", 0}});
    expect_refused(two, "nodes", {.max_nodes = 3});
    expect_refused(two, "elements", {.max_triangles = 2});
}

TEST_F(GltfRead, RejectsJsonAndNodesThatNestWithoutEnd) {
    expect_refused(test::glb_of(std::string(100'000, '['), {}), "levels");
    Sample circle;
    circle.tree["nodes"][0]["children"] = {0};
    expect_refused(circle, "deep");
}

TEST_F(GltfRead, RejectsAnAccessorThatReachesPastItsData) {
    for (const auto& [path, value] :
         std::vector<std::pair<std::string, json>>{{"/accessors/0/count", 4},
                                                   {"/accessors/0/byteOffset", 4},
                                                   {"/accessors/0/byteOffset", 18446744073709551612U},
                                                   {"/accessors/0/bufferView", 7},
                                                   {"/bufferViews/0/byteOffset", 18446744073709551612U},
                                                   {"/bufferViews/0/byteStride", 20},
                                                   {"/bufferViews/0/byteLength", 1'000'000},
                                                   {"/bufferViews/0/buffer", 3}}) {
        Sample damaged;
        damaged.tree[json::json_pointer(path)] = value;
        expect_refused(damaged, "expected");
    }
}

TEST_F(GltfRead, RejectsIndicesThatPointNowhere) {
    sample.indices = {0, 1, 3};
    expect_refused(sample, "past the last");
    sample = {};
    sample.tree["accessors"][1]["count"] = 2;
    expect_refused(sample, "three indices a triangle");
    sample = {};
    sample.tree["scenes"][0]["nodes"] = {5};
    expect_refused(sample, "node 5");
    sample = {};
    sample.tree["nodes"][0]["mesh"] = 5;
    expect_refused(sample, "mesh 5");
    sample = {};
    sample.tree["meshes"][0]["primitives"][0]["material"] = 5;
    expect_refused(sample, "material 5");
}

TEST_F(GltfRead, RejectsNumbersThatAreNotFinite) {
    sample.positions[4] = std::numeric_limits<float>::infinity();
    expect_refused(sample, "finite");
    sample = {};
    sample.tree["nodes"][0]["scale"] = {1e300, 1e300, 1e300};
    expect_refused(sample, "finite");
}

TEST_F(GltfRead, RejectsUnsupportedPrimitives) {
    sample.tree["meshes"][0]["primitives"][0]["mode"] = 1;
    expect_refused(sample, "triangles");
    sample = {};
    sample.tree["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    expect_refused(sample, "KHR_draco_mesh_compression");
    sample = {};
    sample.tree["accessors"][0]["sparse"] = json::parse(
        R"({"count": 1, "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 0}})");
    expect_refused(sample, "sparse");
    sample = {};
    sample.tree["nodes"][0].erase("mesh");
    expect_refused(sample, "triangles, found none");
    sample = {};
    sample.tree["meshes"][0]["primitives"][0]["attributes"] = json::object({{"NORMAL", 0}});
    expect_refused(sample, "positions");
}

TEST_F(GltfRead, RejectsReferencesOutOfTheFile) {
    sample.tree["buffers"].push_back({{"byteLength", 44}, {"uri", "/etc/passwd"}});
    expect_refused(sample, "expected");
}

}  // namespace
}  // namespace onggi::asset
