// USDZ by the rules of its specification, read by libarchive: stored, aligned, and the scene of the content.
#include "engine/asset/usdz.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "engine/core/little_endian.h"
#include "engine/files/archive.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/asset/sample_mesh.h"

namespace onggi::asset {
namespace {

std::vector<std::byte> like(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    return {bytes.begin(), bytes.end()};
}

GltfContent plain_content() {
    GltfContent content;
    content.name = "Moon \"jar\"";
    content.generator = "test 1";
    content.mesh = tetrahedron();
    content.material = {"clay", dvec3(0.5, 0.25, 0.125), 0.75, 0.0};
    content.extras = {{"height_mm", 100.0}, {"glaze", std::string("celadon")}};
    return content;
}

GltfContent pictured() {
    GltfContent textured = plain_content();
    textured.mesh.uvs = {{0, 0}, {1, 0}, {0, 1}, {0.25F, 0.25F}};
    textured.mesh.tangents.assign(4, vec4(1, 0, 0, 1));
    textured.material.clearcoat = {.factor = 0.5, .roughness = 0.1};
    textured.material.textures = {.base_colour = like("\xff\xd8\xff colour"),
                                  .normal = like("\xff\xd8\xff normals"),
                                  .surface = like("\x89PNG surface"),
                                  .clearcoat = like("\xff\xd8\xff coat")};
    return textured;
}

std::map<std::string, std::string> files_of(const std::vector<std::byte>& usdz) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "pot.usdz",
                   std::string_view(reinterpret_cast<const char*>(usdz.data()), usdz.size()));
    std::map<std::string, std::string> files;
    auto archive = files::ArchiveReader::open(folder / "pot.usdz");
    EXPECT_TRUE(archive);
    while (archive) {
        const auto name = archive->next();
        EXPECT_TRUE(name) << name.error().message;
        if (!name || !*name) break;
        const auto text = archive->read(1'000'000);
        EXPECT_TRUE(text) << text.error().message;
        files[**name] = text ? *text : "";
    }
    return files;
}

std::string scene_of(const GltfContent& content) {
    const auto usdz = encode_usdz(content);
    EXPECT_TRUE(usdz) << usdz.error().message;
    return usdz ? files_of(*usdz)["pot.usda"] : "";
}

TEST(Usdz, StoresItsFilesAtMultiplesOf64BytesTheSceneFirst) {
    const auto usdz = encode_usdz(pictured());
    ASSERT_TRUE(usdz) << usdz.error().message;
    std::vector<std::string> names;
    std::size_t at = 0;
    while (little_endian::get<std::uint32_t>(usdz->data() + at) == 0x04034b50) {
        const std::byte* const head = usdz->data() + at;
        const auto number = [&](std::size_t place) {
            return little_endian::get<std::uint16_t>(head + place);
        };
        EXPECT_EQ(number(6), 0) << "flags: no encryption, no sizes behind the data";
        EXPECT_EQ(number(8), 0) << "stored";
        const auto size = little_endian::get<std::uint32_t>(head + 18);
        EXPECT_EQ(size, little_endian::get<std::uint32_t>(head + 22));
        names.emplace_back(reinterpret_cast<const char*>(head) + 30, number(26));
        at += 30U + number(26) + number(28);
        EXPECT_EQ(at % 64, 0U) << names.back();
        at += size;
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"pot.usda", "colour.jpg", "normals.jpg", "surface.png", "coat.jpg"}));
    const auto files = files_of(*usdz);
    EXPECT_EQ(files.size(), names.size());
    EXPECT_EQ(files.at("surface.png"), "\x89PNG surface");
    EXPECT_EQ(*usdz, *encode_usdz(pictured())) << "the same bytes every time";
}

TEST(Usdz, IsAMeshInMetresWithYUp) {
    const std::string scene = scene_of(pictured());
    for (const char* line :
         {"#usda 1.0\n", "    metersPerUnit = 1\n", "    upAxis = \"Y\"\n", "    defaultPrim = \"Pot\"\n",
          "float3[] extent = [(0, 0, 0), (0.1, 0.1, 0.1)]\n", "int[] faceVertexCounts = [3, 3, 3, 3]\n",
          "int[] faceVertexIndices = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]\n",
          "point3f[] points = [(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1)]\n",
          "texCoord2f[] primvars:st = [(0, 1), (1, 1), (0, 0), (0.25, 0.75)] (",
          "uniform token subdivisionScheme = \"none\"\n", "string name = \"Moon \\\"jar\\\"\"\n"})
        EXPECT_NE(scene.find(line), std::string::npos) << line;
}

TEST(Usdz, HasTheMaterialByPicturesOrByNumbers) {
    const std::string plain = scene_of(plain_content());
    EXPECT_NE(plain.find("color3f inputs:diffuseColor = (0.5, 0.25, 0.125)\n"), std::string::npos);
    EXPECT_NE(plain.find("float inputs:roughness = 0.75\n"), std::string::npos);
    EXPECT_EQ(plain.find("clearcoat"), std::string::npos);
    EXPECT_EQ(plain.find("UsdUVTexture"), std::string::npos);
    EXPECT_EQ(plain.find("primvars:st"), std::string::npos);
    const auto usdz = encode_usdz(pictured());
    auto files = files_of(*usdz);
    const std::string scene = files["pot.usda"];
    for (const char* line :
         {"color3f inputs:diffuseColor.connect = </Pot/Material/colour.outputs:rgb>\n",
          "normal3f inputs:normal.connect = </Pot/Material/normals.outputs:rgb>\n",
          "float inputs:occlusion.connect = </Pot/Material/surface.outputs:r>\n",
          "float inputs:roughness.connect = </Pot/Material/surface.outputs:g>\n",
          "float inputs:metallic.connect = </Pot/Material/surface.outputs:b>\n",
          "float inputs:clearcoat.connect = </Pot/Material/coat.outputs:r>\n",
          "float inputs:clearcoatRoughness = 0.1\n", "float4 inputs:scale = (0.5, 0.25, 0.125, 1)\n",
          "float4 inputs:scale = (1, 0.75, 0, 1)\n"})
        EXPECT_NE(scene.find(line), std::string::npos) << line;
    const std::regex asset("@([^@]*)@");
    int assets = 0;
    for (std::sregex_iterator found(scene.begin(), scene.end(), asset), end; found != end; ++found, ++assets)
        EXPECT_TRUE(files.contains((*found)[1])) << (*found)[1];
    EXPECT_EQ(assets, 4);
}

TEST(Usdz, SaysWhoseItIsInEachLanguageAndNothingElse) {
    GltfContent told = plain_content();
    told.about = {.title = {{"en", "Moon jar"}, {"ko", "달항아리"}},
                  .rights = {{"en", "CC BY 4.0"}},
                  .publisher = {{"en", "House of \"Clay\"\n"}},
                  .date = "2026-11-28"};
    const std::string scene = scene_of(told);
    const std::size_t begin = scene.find("customLayerData");
    EXPECT_EQ(scene.substr(begin, scene.find("    }\n", begin) - begin),
              "customLayerData = {\n"
              "        string \"creator\" = \"test 1\"\n"
              "        string \"copyright\" = \"House of \\\"Clay\\\" . CC BY 4.0\"\n"
              "        string \"title\" = \"Moon jar\"\n"
              "        string \"title-en\" = \"Moon jar\"\n"
              "        string \"title-ko\" = \"달항아리\"\n"
              "        string \"rights\" = \"CC BY 4.0\"\n"
              "        string \"rights-en\" = \"CC BY 4.0\"\n"
              "        string \"publisher\" = \"House of \\\"Clay\\\" \"\n"
              "        string \"publisher-en\" = \"House of \\\"Clay\\\" \"\n"
              "        string \"date\" = \"2026-11-28\"\n"
              "        double \"onggi-height_mm\" = 100\n"
              "        string \"onggi-glaze\" = \"celadon\"\n");
}

TEST(Usdz, RejectsWhatTheGlbRefusesToo) {
    GltfContent bad = plain_content();
    bad.mesh.indices[0] = 9;
    EXPECT_FALSE(encode_usdz(bad));
    bad = plain_content();
    bad.material.roughness = 2.0;
    EXPECT_FALSE(encode_usdz(bad));
    bad = pictured();
    bad.mesh.uvs.clear();
    ASSERT_FALSE(encode_usdz(bad));
    EXPECT_EQ(encode_usdz(bad).error().message,
              "mesh: expected places in the material's pictures, found none");
}

}  // namespace
}  // namespace onggi::asset
