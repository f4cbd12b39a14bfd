#include "engine/asset/stl.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "tests/support/mesh_check.h"
#include "tests/unit/asset/sample_mesh.h"

namespace onggi::asset {
namespace {

std::vector<std::byte> written(const Mesh& mesh, std::string_view title = "pot") {
    const Result<std::vector<std::byte>> bytes = encode_stl(mesh, title);
    EXPECT_TRUE(bytes) << (bytes ? "" : bytes.error().message);
    return bytes ? *bytes : std::vector<std::byte>{};
}

float float_at(const std::vector<std::byte>& bytes, std::size_t offset) {
    float number = 0.0F;
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

TEST(Stl, StandsOnZInMillimetres) {
    Mesh mesh = tetrahedron();
    mesh.indices = {1, 2, 3};  // the slanted face: (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1) m
    const std::vector<std::byte> bytes = written(mesh);
    ASSERT_EQ(bytes.size(), 84U + 50U);
    const float expected[] = {100.0F, 0.0F, 0.0F, 0.0F, 0.0F, 100.0F, 0.0F, -100.0F, 0.0F};
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_FLOAT_EQ(float_at(bytes, 84 + 12 + 4 * i), expected[i]) << i;
    const float third = 1.0F / std::sqrt(3.0F);
    EXPECT_NEAR(float_at(bytes, 84), third, 1e-6);
    EXPECT_NEAR(float_at(bytes, 88), -third, 1e-6);
    EXPECT_NEAR(float_at(bytes, 92), third, 1e-6);
}

TEST(Stl, KeepsTheVolumeAndItsSign) {
    const Result<support::SolidMesh> mesh = support::read_stl(written(tetrahedron()));
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_NEAR(support::signed_volume_m3(*mesh), 0.001 / 6.0, 1e-9);
}

TEST(Stl, HoldsNoNegativeZero) {
    Mesh mesh = tetrahedron();
    mesh.positions_m[0] = vec3(-0.0F, -0.0F, 0.0F);  // becomes (-0, -0, -0) unless care is taken
    EXPECT_TRUE(support::read_stl(written(mesh)));   // the reader refuses negative zeros
}

TEST(Stl, CannotBeTakenForItsTextForm) {
    const std::vector<std::byte> bytes = written(tetrahedron(), "solid as a rock");
    EXPECT_NE(std::memcmp(bytes.data(), "solid", 5), 0);
}

TEST(Stl, CutsALongTitleAndKeepsItPrintable) {
    const std::string title = "caf\xC3\xA9\n" + std::string(200, 'x');
    const std::vector<std::byte> bytes = written(tetrahedron(), title);
    EXPECT_TRUE(support::read_stl(bytes));
    for (std::size_t i = 0; i < 80; ++i) {
        const auto c = std::to_integer<unsigned char>(bytes[i]);
        EXPECT_TRUE(c >= ' ' && c <= '~') << i;
    }
}

TEST(Stl, RejectsATriangleWithoutArea) {
    Mesh mesh = tetrahedron();
    mesh.indices[4] = mesh.indices[3];
    const Result<std::vector<std::byte>> bytes = encode_stl(mesh, "pot");
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().message, "mesh: triangle 1: expected an area above zero");
}

TEST(Stl, RejectsAnInvalidMesh) {
    EXPECT_FALSE(encode_stl({}, "pot"));
    Mesh mesh = tetrahedron();
    mesh.indices[0] = 99;
    EXPECT_FALSE(encode_stl(mesh, "pot"));
}

}  // namespace
}  // namespace onggi::asset
