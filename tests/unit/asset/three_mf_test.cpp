#include "engine/asset/three_mf.h"

#include <gtest/gtest.h>

#include "tests/support/three_mf_read.h"
#include "tests/unit/asset/sample_mesh.h"

namespace onggi::asset {
namespace {

const ThreeMfWords kWords{.title = "a pot", .description = "walls", .application = "Onggi 0"};

std::vector<std::byte> in_3mf(const Mesh& mesh, const ThreeMfWords& words = kWords,
                              const Image* picture = nullptr) {
    auto bytes = encode_3mf(mesh, words, picture);
    EXPECT_TRUE(bytes) << (bytes ? "" : bytes.error().message);
    return bytes ? *bytes : std::vector<std::byte>{};
}

support::ThreeMfFile read_back(const std::vector<std::byte>& bytes) {
    auto file = support::read_3mf(bytes);
    EXPECT_TRUE(file) << (file ? "" : file.error().message);
    return file ? *file : support::ThreeMfFile{};
}

TEST(ThreeMf, IsOneClosedSolidOfMillimetresOnTheBackgroundOnce) {
    const support::ThreeMfFile file = read_back(in_3mf(tetrahedron()));
    EXPECT_TRUE(file.is_millimetres);
    EXPECT_TRUE(file.is_manifold);
    EXPECT_EQ(file.objects, 1);
    EXPECT_EQ(file.items, 1);
    EXPECT_EQ(file.mesh.indices.size(), 12U);
    EXPECT_NEAR(support::signed_volume_m3(file.mesh), 0.001 / 6.0, 1e-12);
    EXPECT_TRUE(file.thumbnail.empty());
}

TEST(ThreeMf, StandsOnZ) {
    const auto parts = support::zip_parts(in_3mf(tetrahedron()));
    const std::string& model = parts.at("3D/3dmodel.model");
    EXPECT_NE(model.find("unit=\"millimeter\""), std::string::npos);
    // (0, 0.1, 0) m, up, and (0, 0, 0.1) m, towards us.
    EXPECT_NE(model.find("<vertex x=\"0\" y=\"0\" z=\"100.000000\" />"), std::string::npos) << model;
    EXPECT_NE(model.find("<vertex x=\"0\" y=\"-100.000000\" z=\"0\" />"), std::string::npos) << model;
    EXPECT_TRUE(parts.contains("[Content_Types].xml"));
    EXPECT_TRUE(parts.contains("_rels/.rels"));
}

TEST(ThreeMf, JoinsVerticesThatStandAtOnePlace) {
    Mesh twice = tetrahedron();
    const std::size_t count = twice.positions_m.size();
    for (std::size_t i = 0; i < count; ++i) {
        twice.positions_m.push_back(twice.positions_m[i] * 1.0F);
        twice.normals.push_back(twice.normals[i]);
    }
    twice.positions_m.back().x = -0.0F;
    for (std::size_t i = 0; i < twice.indices.size(); i += 2)
        twice.indices[i] += static_cast<std::uint32_t>(count);
    const support::ThreeMfFile file = read_back(in_3mf(twice));
    EXPECT_EQ(file.mesh.positions_m.size(), 4U);
    EXPECT_TRUE(file.is_manifold);
}

// In the file's own text, because lib3mf takes back also what is not escaped
// (findings/lib3mf-escapes-the-name-and-not-the-metadata.sh).
std::string model_with(const ThreeMfWords& words) {
    return support::zip_parts(in_3mf(tetrahedron(), words)).at("3D/3dmodel.model");
}

TEST(ThreeMf, KeepsAnyText) {
    const std::string model = model_with({.title = "a <pot> & \"bowl\"",
                                          .description = "\xed\x95\xad\xec\x95\x84\xeb\xa6\xac\n1",
                                          .application = ""});
    EXPECT_NE(model.find(">a &lt;pot&gt; &amp; &quot;bowl&quot;<"), std::string::npos) << model;
    EXPECT_NE(model.find("name=\"a &lt;pot&gt; &amp; &quot;bowl&quot;\""), std::string::npos) << model;
    EXPECT_NE(model.find(">\xed\x95\xad\xec\x95\x84\xeb\xa6\xac 1<"), std::string::npos) << model;
    EXPECT_EQ(model.find("Application"), std::string::npos) << model;
    EXPECT_NE(
        model_with({.title = "caf\xe9", .description = "", .application = ""}).find(">caf\xef\xbf\xbd<"),
        std::string::npos);
}

TEST(ThreeMf, SaysWhoseItIs) {
    const std::string model = model_with({.title = "a pot",
                                          .description = "",
                                          .application = "Onggi 0",
                                          .copyright = "House of Clay",
                                          .licence_terms = "CC BY 4.0",
                                          .creation_date = "2026-11-28"});
    for (const char* said : {"name=\"Copyright\"", ">House of Clay<", "name=\"LicenseTerms\"", ">CC BY 4.0<",
                             "name=\"CreationDate\"", ">2026-11-28<"})
        EXPECT_NE(model.find(said), std::string::npos) << said;
    EXPECT_EQ(model_with(kWords).find("LicenseTerms"), std::string::npos);
}

TEST(ThreeMf, ShowsThePictureSmall) {
    Image picture{.width = 600, .height = 300, .rgba = {}};
    for (int i = 0; i < 600 * 300; ++i)
        picture.rgba.insert(picture.rgba.end(),
                            {static_cast<std::uint8_t>(i % 600 < 300 ? 200 : 20), 90, 30, 255});
    const support::ThreeMfFile file = read_back(in_3mf(tetrahedron(), kWords, &picture));
    const auto shown = decode_png(file.thumbnail, "thumbnail");
    ASSERT_TRUE(shown) << shown.error().message;
    EXPECT_EQ(shown->width, 200);
    EXPECT_EQ(shown->height, 100);
    EXPECT_EQ(shown->rgba[0], 200);
    EXPECT_EQ(shown->rgba[4 * 199], 20);
    const Image wrong{.width = 2, .height = 2, .rgba = {0}};
    EXPECT_FALSE(encode_3mf(tetrahedron(), kWords, &wrong));
}

TEST(ThreeMf, IsTheSameBytesEveryTime) {
    EXPECT_EQ(in_3mf(tetrahedron()), in_3mf(tetrahedron()));
}

TEST(ThreeMf, RejectsAnInvalidMesh) {
    EXPECT_FALSE(encode_3mf({}, kWords));
    Mesh mesh = tetrahedron();
    mesh.indices[0] = 99;
    EXPECT_FALSE(encode_3mf(mesh, kWords));
}

}  // namespace
}  // namespace onggi::asset
