// The check of exported pots must find every fault: each is planted in a sound pot.
#include <gtest/gtest.h>

#include <functional>

#include "game/exporter/export.h"
#include "tests/support/mesh_check.h"
#include "tests/support/pot_samples.h"

namespace onggi {
namespace {

using support::SolidMesh;

class MeshCheck : public testing::Test {
  protected:
    MeshCheck() : pot_(support::vase(2000)) {
        const auto bytes = exporter::encode_pot(exporter::pot_file(pot_.rings()), exporter::ExportKind::kGlb);
        if (bytes) glb_ = *bytes;
        if (const auto file = support::read_glb(glb_)) mesh_ = file->mesh;
        double max_radius_mm = 0.0;
        for (const float radius : pot_.radii_mm)
            max_radius_mm = std::max(max_radius_mm, double{radius});
        expected_ = {.volume_m3 = pot_.rings().volume_mm3 * 1e-9,
                     .height_m = pot_.height_mm * 1e-3,
                     .max_radius_m = max_radius_mm * 1e-3};
    }

    // The kinds of the faults found: the text before the colons.
    [[nodiscard]] std::vector<std::string> kinds() const {
        std::vector<std::string> words;
        for (const std::string& fault : support::find_faults(mesh_, expected_)) {
            words.push_back(fault.substr(0, fault.find(':')));
        }
        return words;
    }

    support::PotSample pot_;
    std::vector<std::byte> glb_;
    SolidMesh mesh_;
    support::ExpectedPot expected_;
};

using Kinds = std::vector<std::string>;

TEST_F(MeshCheck, FindsNoFaultInASoundPot) {
    ASSERT_GT(mesh_.indices.size(), 1000U);
    EXPECT_EQ(kinds(), Kinds{});
}

TEST_F(MeshCheck, CatchesAPotTurnedInsideOut) {
    for (std::size_t i = 0; i < mesh_.indices.size(); i += 3)
        std::swap(mesh_.indices[i], mesh_.indices[i + 1]);
    EXPECT_EQ(kinds(), (Kinds{"outward", "normals"}));
}

TEST_F(MeshCheck, CatchesAPotTurnedInsideOutWithItsNormals) {
    for (std::size_t i = 0; i < mesh_.indices.size(); i += 3)
        std::swap(mesh_.indices[i], mesh_.indices[i + 1]);
    for (dvec3& normal : mesh_.normals)
        normal = -normal;
    EXPECT_EQ(kinds(), Kinds{"outward"});
}

TEST_F(MeshCheck, CatchesASingleFlippedTriangle) {
    std::swap(mesh_.indices[3000], mesh_.indices[3001]);
    const Kinds found = kinds();
    EXPECT_EQ(found.front(), "closed");
    EXPECT_EQ(found.back(), "normals");
}

TEST_F(MeshCheck, CatchesAHole) {
    mesh_.indices.erase(mesh_.indices.begin() + 3000, mesh_.indices.begin() + 3003);
    EXPECT_EQ(kinds().front(), "closed");
}

TEST_F(MeshCheck, CatchesAnOpenTop) {
    // The last fan is the top's cap.
    const std::size_t cap = 128 * 3;
    mesh_.indices.resize(mesh_.indices.size() - cap);
    const Kinds found = kinds();
    EXPECT_NE(std::find(found.begin(), found.end(), "closed"), found.end());
    EXPECT_NE(std::find(found.begin(), found.end(), "Euler"), found.end());
}

TEST_F(MeshCheck, CatchesASeamThatGapesByOneBit) {
    mesh_.positions_m[500].x = std::nextafter(static_cast<float>(mesh_.positions_m[500].x), 1.0F);
    // The vertex is shared, so the mesh stays closed; give one of its triangles a copy of its own.
    for (std::size_t i = 0; i < mesh_.indices.size(); ++i) {
        if (mesh_.indices[i] != 500U) continue;
        mesh_.positions_m.push_back(mesh_.positions_m[500]);
        mesh_.positions_m.back().x = std::nextafter(static_cast<float>(mesh_.positions_m[500].x), 1.0F);
        mesh_.normals.push_back(mesh_.normals[500]);
        mesh_.indices[i] = static_cast<std::uint32_t>(mesh_.positions_m.size() - 1);
        break;
    }
    EXPECT_EQ(kinds().front(), "closed");
}

TEST_F(MeshCheck, CatchesAPotOffTheWheelHead) {
    for (dvec3& position : mesh_.positions_m)
        position.y += 0.001;
    EXPECT_EQ(kinds(), Kinds{"base"});
}

TEST_F(MeshCheck, CatchesAPotOffTheAxis) {
    for (dvec3& position : mesh_.positions_m)
        position.x += 0.001;
    EXPECT_EQ(kinds(), Kinds{"axis"});
}

TEST_F(MeshCheck, CatchesAPotScaledByOnePercent) {
    for (dvec3& position : mesh_.positions_m)
        position *= 1.01;
    EXPECT_EQ(kinds(), (Kinds{"volume", "height"}));
}

TEST_F(MeshCheck, CatchesMillimetresTakenForMetres) {
    for (dvec3& position : mesh_.positions_m)
        position *= 1000.0;
    EXPECT_EQ(kinds(), (Kinds{"volume", "height"}));
}

TEST_F(MeshCheck, CatchesAVertexThatNoTriangleUses) {
    mesh_.positions_m.emplace_back(0.01, 0.01, 0.01);
    mesh_.normals.emplace_back(0.0, 1.0, 0.0);
    const Kinds found = kinds();
    EXPECT_EQ(found.front(), "unreferenced");
}

TEST_F(MeshCheck, CatchesATriangleWithoutArea) {
    mesh_.indices.insert(mesh_.indices.end(), {7, 7, 8});
    const Kinds found = kinds();
    EXPECT_EQ(found.front(), "degenerate");
}

TEST_F(MeshCheck, CatchesANormalThatIsNoUnitVector) {
    mesh_.normals[10] *= 1.001;
    EXPECT_EQ(kinds(), Kinds{"normals"});
}

TEST_F(MeshCheck, CatchesANormalThatPointsElsewhere) {
    mesh_.normals[10] = dvec3(0.0, 1.0, 0.0);  // of the base, which faces down
    EXPECT_EQ(kinds(), Kinds{"normals"});
}

TEST_F(MeshCheck, CatchesASecondPart) {
    SolidMesh other = mesh_;
    for (std::uint32_t& index : other.indices)
        index += static_cast<std::uint32_t>(mesh_.positions_m.size());
    for (dvec3& position : other.positions_m)
        position = 0.5 * position + dvec3(0.0, 0.01, 0.0);
    mesh_.positions_m.insert(mesh_.positions_m.end(), other.positions_m.begin(), other.positions_m.end());
    mesh_.normals.insert(mesh_.normals.end(), other.normals.begin(), other.normals.end());
    mesh_.indices.insert(mesh_.indices.end(), other.indices.begin(), other.indices.end());
    EXPECT_EQ(kinds(), (Kinds{"Euler", "parts", "volume"}));
}

TEST_F(MeshCheck, ReaderRejectsDamagedFiles) {
    const auto refuses = [this](const std::function<void(std::vector<std::byte>&)>& damage) {
        std::vector<std::byte> bytes = glb_;
        damage(bytes);
        return !support::read_glb(bytes);
    };
    EXPECT_FALSE(refuses([](auto&) {}));
    EXPECT_TRUE(refuses([](auto& bytes) { bytes.clear(); }));
    EXPECT_TRUE(refuses([](auto& bytes) { bytes.pop_back(); }));
    EXPECT_TRUE(refuses([](auto& bytes) { bytes.push_back(std::byte{0}); }));
    EXPECT_TRUE(refuses([](auto& bytes) { bytes[0] = std::byte{'G'}; }));
    EXPECT_TRUE(refuses([](auto& bytes) { bytes[4] = std::byte{1}; }));
    EXPECT_TRUE(refuses([](auto& bytes) { bytes[20] = std::byte{'x'}; }));
}

}  // namespace
}  // namespace onggi
