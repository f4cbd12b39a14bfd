// Every exported pot is a sound solid of the size and volume of its clay.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "game/exporter/export.h"
#include "tests/support/mesh_check.h"
#include "tests/support/pot_samples.h"

namespace onggi {
namespace {

using exporter::ExportKind;
using support::PotSample;

constexpr double kMetresPerMm = 1e-3;
constexpr std::size_t kTriangleBudget = 50000;

// The radius of the reference outline: linear between the centres of elements.
double radius_at(const PotSample& pot, double y_mm) {
    const double count = static_cast<double>(pot.radii_mm.size());
    const double at = std::clamp(y_mm / pot.height_mm * count - 0.5, 0.0, count - 1.0);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, pot.radii_mm.size() - 1);
    const double fraction = at - static_cast<double>(below);
    return (1.0 - fraction) * double{pot.radii_mm[below]} + fraction * double{pot.radii_mm[above]};
}

double max_radius_mm(const PotSample& pot) {
    return double{*std::max_element(pot.radii_mm.begin(), pot.radii_mm.end())};
}

// Computed independently of the exporter.
double clay_mm3(const PotSample& pot) {
    double sum = 0.0;
    for (const float r : pot.radii_mm)
        sum += M_PI * double{r} * double{r};
    return sum * pot.height_mm / static_cast<double>(pot.radii_mm.size());
}

support::ExpectedPot expected_of(const PotSample& pot) {
    support::ExpectedPot expected;
    expected.volume_m3 = clay_mm3(pot) * std::pow(kMetresPerMm, 3);
    expected.height_m = pot.height_mm * kMetresPerMm;
    expected.max_radius_m = max_radius_mm(pot) * kMetresPerMm;
    // Artificial roughness may be smoothed to fit the triangle budget, but the volume must stay.
    if (!pot.hand_made) expected.radius_tolerance_m = expected.max_radius_m;
    return expected;
}

class ExportedPot : public testing::TestWithParam<PotSample> {
  protected:
    [[nodiscard]] std::vector<std::byte> bytes(ExportKind kind) const {
        const Result<std::vector<std::byte>> exported =
            exporter::encode_pot(exporter::pot_file(GetParam().rings()), kind);
        EXPECT_TRUE(exported) << (exported ? "" : exported.error().message);
        return exported ? *exported : std::vector<std::byte>{};
    }
    [[nodiscard]] support::GlbFile glb() const {
        const Result<support::GlbFile> file = support::read_glb(bytes(ExportKind::kGlb));
        EXPECT_TRUE(file) << (file ? "" : file.error().message);
        return file ? *file : support::GlbFile{};
    }
};

TEST_P(ExportedPot, IsASoundSolidAsGlb) {
    const support::GlbFile file = glb();
    EXPECT_EQ(support::find_faults(file.mesh, expected_of(GetParam())), std::vector<std::string>{});
    EXPECT_LE(file.mesh.indices.size() / 3, kTriangleBudget);
    EXPECT_EQ(file.index_bytes, 2U);
}

TEST_P(ExportedPot, HasTheClaysVolumeToAMillionth) {
    const double expected = clay_mm3(GetParam()) * 1e-9;
    EXPECT_NEAR(support::signed_volume_m3(glb().mesh), expected, 1e-6 * expected);
}

TEST_P(ExportedPot, StatesItsBoundsExactly) {
    const support::GlbFile file = glb();
    dvec3 low(std::numeric_limits<double>::max());
    dvec3 high(std::numeric_limits<double>::lowest());
    for (const dvec3& position : file.mesh.positions_m) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    EXPECT_EQ(file.stated_min_m, low);
    EXPECT_EQ(file.stated_max_m, high);
}

TEST_P(ExportedPot, NamesItsGeneratorAndItsMeasures) {
    const nlohmann::json json = glb().json;
    EXPECT_EQ(json.at("asset").at("version"), "2.0");
    EXPECT_EQ(json["asset"].at("generator"), "Onggi " ONGGI_VERSION);
    const nlohmann::json& extras = json["asset"].at("extras");
    EXPECT_DOUBLE_EQ(extras.at("height_mm").get<double>(), GetParam().height_mm);
    EXPECT_DOUBLE_EQ(extras.at("max_diameter_mm").get<double>(), 2.0 * max_radius_mm(GetParam()));
    EXPECT_NEAR(extras.at("volume_mm3").get<double>(), clay_mm3(GetParam()), 1e-9 * clay_mm3(GetParam()));
    const nlohmann::json& clay = json.at("materials").at(0).at("pbrMetallicRoughness");
    EXPECT_EQ(clay.at("baseColorFactor"), nlohmann::json({0.36, 0.29, 0.215, 1.0}));
    EXPECT_EQ(clay.at("metallicFactor"), 0.0);
    EXPECT_FALSE(json.contains("extensionsUsed"));
}

TEST_P(ExportedPot, IsASoundSolidAsStl) {
    const Result<support::SolidMesh> mesh = support::read_stl(bytes(ExportKind::kStl));
    ASSERT_TRUE(mesh) << mesh.error().message;
    support::ExpectedPot expected = expected_of(GetParam());
    expected.min_normal_agreement = 0.999999;  // STL's normals are the faces' own
    EXPECT_EQ(support::find_faults(*mesh, expected), std::vector<std::string>{});
    EXPECT_EQ(mesh->indices.size(), glb().mesh.indices.size());
}

TEST_P(ExportedPot, IsTheSameFileTwice) {
    EXPECT_EQ(bytes(ExportKind::kGlb), bytes(ExportKind::kGlb));
    EXPECT_EQ(bytes(ExportKind::kStl), bytes(ExportKind::kStl));
}

// The wall's outline in the file: the vertices at z = 0 on the +X side, from the base up.
std::vector<dvec2> outline_mm(const support::SolidMesh& mesh) {
    std::vector<dvec2> outline;
    for (const dvec3& position : mesh.positions_m) {
        const dvec2 corner(position.x / kMetresPerMm, position.y / kMetresPerMm);
        if (position.z == 0.0 && position.x > 0.0) outline.push_back(corner);
    }
    std::stable_sort(outline.begin(), outline.end(),
                     [](const dvec2& a, const dvec2& b) { return a.y < b.y; });
    return outline;
}

// Those that need not be smoothed to fit the triangle budget.
class ExportedHandMadePot : public ExportedPot {};

TEST_P(ExportedHandMadePot, StaysWithinTwentyMicrometresOfTheWall) {
    const PotSample& pot = GetParam();
    constexpr double kToleranceMm = 0.02;
    const std::vector<dvec2> outline = outline_mm(glb().mesh);
    const double element_mm = pot.height_mm / static_cast<double>(pot.radii_mm.size());
    std::size_t piece = 0;
    for (std::size_t i = 0; i < pot.radii_mm.size(); ++i) {
        const double y_mm = (static_cast<double>(i) + 0.5) * element_mm;
        while (piece + 2 < outline.size() && outline[piece + 1].y < y_mm)
            ++piece;
        const dvec2 a = outline[piece];
        const dvec2 b = outline[piece + 1];
        const double along = b.y > a.y ? (y_mm - a.y) / (b.y - a.y) : 0.0;
        const double found_mm = a.x + along * (b.x - a.x);
        ASSERT_NEAR(found_mm, radius_at(pot, y_mm), kToleranceMm + 1e-4) << "element " << i;
    }
}

std::vector<PotSample> hand_made_samples() {
    std::vector<PotSample> pots = support::all_pot_samples();
    std::erase_if(pots, [](const PotSample& pot) { return !pot.hand_made; });
    return pots;
}

constexpr auto kNameOf = [](const auto& sample) { return sample.param.name; };

INSTANTIATE_TEST_SUITE_P(Samples, ExportedPot, testing::ValuesIn(support::all_pot_samples()), kNameOf);
INSTANTIATE_TEST_SUITE_P(Samples, ExportedHandMadePot, testing::ValuesIn(hand_made_samples()), kNameOf);

}  // namespace
}  // namespace onggi
