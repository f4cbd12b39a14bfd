// Every studio pot exports as a sound solid with the clay volume of its ledger, its measures, and the size
// and surface of its stage.
#include "game/exporter/studio_export.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/exporter/pot_solid.h"
#include "tests/support/mesh_check.h"
#include "tests/support/studio_samples.h"
#include "tests/support/three_mf_read.h"

namespace onggi {
namespace {

using exporter::ExportKind;
using support::StudioSample;

constexpr double kMetresPerMm = 1e-3;

// Computed independently: each ring is an annulus of its radii and height.
double clay_mm3(const clay::StudioClay& pot) {
    double sum = 0.0;
    for (std::size_t i = 0; i < pot.outer_mm().size(); ++i) {
        sum += M_PI * (pot.outer_mm()[i] * pot.outer_mm()[i] - pot.inner_mm()[i] * pot.inner_mm()[i]) *
               pot.rings().height_mm[i];
    }
    return sum;
}

support::ExpectedPot expected_of(const StudioSample& pot) {
    const double metres = clay::shrunk_scale(pot.clay.lump().body, pot.stage) * kMetresPerMm;
    support::ExpectedPot expected;
    expected.volume_m3 = clay_mm3(pot.clay) * metres * metres * metres;
    expected.volume_tolerance = 1e-6;
    expected.height_m = pot.clay.height_mm() * metres;
    expected.max_radius_m =
        *std::max_element(pot.clay.outer_mm().begin(), pot.clay.outer_mm().end()) * metres;
    expected.off_axis_m = pot.off_axis_mm * metres;
    expected.euler = pot.euler;
    expected.parts = pot.parts;
    if (!pot.calm) {
        expected.min_normal_agreement = -1.0;  // wild hands leave folds
        expected.radius_tolerance_m = 0.6 * kMetresPerMm;
    }
    return expected;
}

const std::vector<StudioSample>& samples() {
    static const std::vector<StudioSample> all = support::all_studio_samples();
    return all;
}

std::vector<std::byte> bytes_of(const StudioSample& pot, ExportKind kind) {
    const auto bytes = exporter::encode_pot(exporter::pot_file(pot.clay, pot.stage), kind);
    EXPECT_TRUE(bytes) << pot.name << ": " << (bytes ? "" : bytes.error().message);
    return bytes ? *bytes : std::vector<std::byte>{};
}

support::GlbFile glb_of(const StudioSample& pot) {
    const auto file = support::read_glb(bytes_of(pot, ExportKind::kGlb));
    EXPECT_TRUE(file) << pot.name << ": " << (file ? "" : file.error().message);
    return file ? *file : support::GlbFile{};
}

TEST(StudioExport, IsASoundSolidOfTheLedgersVolumeToAMillionth) {
    for (const StudioSample& pot : samples()) {
        ASSERT_EQ(pot.clay.ledger_error_mm3(), 0.0) << pot.name;
        const support::GlbFile file = glb_of(pot);
        EXPECT_EQ(support::find_faults(file.mesh, expected_of(pot)), std::vector<std::string>{}) << pot.name;
        EXPECT_LE(file.mesh.indices.size() / 3, exporter::kMaxTriangles) << pot.name;
    }
}

TEST(StudioExport, IsTheSolidOfTheStlAs3mf) {
    for (const StudioSample& pot : samples()) {
        const auto file = support::read_3mf(bytes_of(pot, ExportKind::k3mf));
        ASSERT_TRUE(file) << pot.name << ": " << file.error().message;
        const auto stl = support::read_stl(bytes_of(pot, ExportKind::kStl));
        ASSERT_TRUE(stl);
        EXPECT_TRUE(file->is_manifold && file->is_millimetres) << pot.name;
        EXPECT_EQ(file->objects, 1) << pot.name;
        EXPECT_EQ(file->items, 1) << pot.name;
        EXPECT_EQ(file->mesh.indices.size(), stl->indices.size()) << pot.name;
        const double volume_m3 = support::signed_volume_m3(*stl);
        EXPECT_NEAR(support::signed_volume_m3(file->mesh), volume_m3, 1e-6 * volume_m3) << pot.name;
        EXPECT_EQ(file->words.at("Application").rfind("Onggi ", 0), 0U);
        EXPECT_EQ(
            file->words.at("Title"),
            fmt::format("Onggi pot, {}, {:.1f} mm high", exporter::pot_name(pot.clay.lump().body, pot.stage),
                        pot.clay.height_mm() * clay::shrunk_scale(pot.clay.lump().body, pot.stage)));
        EXPECT_EQ(file->words.at("Title").find("glaze "), std::string::npos);
        const clay::PotMeasures measures =
            clay::measure_pot(pot.clay.rings(), pot.clay.lump().body, pot.stage);
        const double thinnest_mm = measures.thinnest_wall_mm;
        const double printed = std::min(1.0, 180.0 / std::max(measures.height_mm, measures.widest_mm));
        const bool is_thin = thinnest_mm > 0.0 && printed * thinnest_mm < 2.0;
        EXPECT_EQ(file->words.contains("Description"), is_thin) << pot.name << ": " << thinnest_mm << " mm";
    }
}

TEST(PrintingNote, IsWrittenOnlyForWallsThatPrintThinAndNamesASufficientSize) {
    EXPECT_EQ(exporter::printing_note(2.0, 180.0, 120.0), "");
    EXPECT_EQ(exporter::printing_note(0.0, 100.0, 100.0), "") << "nothing is hollow";
    EXPECT_EQ(
        exporter::printing_note(1.5, 100.0, 120.0),
        "Thinnest wall 1.5 mm: below 2 mm prints break. At 134 % and above all walls are thick enough.");
    EXPECT_EQ(exporter::printing_note(3.0, 200.0, 240.0), "") << "2.25 mm at 75 %";
    EXPECT_EQ(exporter::printing_note(3.0, 360.0, 240.0),
              "Thinnest wall 3.0 mm, 1.5 mm if the pot is scaled to 50 % for a printer of 180 mm: below 2 mm "
              "prints break. At 67 % and above all walls are thick enough.");
}

TEST(StudioExport, IsASoundSolidAsStl) {
    for (const StudioSample& pot : samples()) {
        const auto mesh = support::read_stl(bytes_of(pot, ExportKind::kStl));
        ASSERT_TRUE(mesh) << pot.name << ": " << mesh.error().message;
        support::ExpectedPot expected = expected_of(pot);
        expected.min_normal_agreement = 0.99999;
        EXPECT_EQ(support::find_faults(*mesh, expected), std::vector<std::string>{}) << pot.name;
    }
}

TEST(StudioExport, IsTheSameFileTwice) {
    for (const StudioSample& pot : samples())
        EXPECT_EQ(bytes_of(pot, ExportKind::kGlb), bytes_of(pot, ExportKind::kGlb)) << pot.name;
}

// The face's radius at a height, interpolated between ring centres; -1 next to rings of another kind.
double radius_at(const clay::studio::Rings& rings, const std::vector<double>& column, double y_mm) {
    int low = rings.ring_at(y_mm);
    if (rings.centre_mm(low) > y_mm) --low;
    if (low < 0 || low + 1 >= rings.count || rings.is_hollow(low) != rings.is_hollow(low + 1)) return -1.0;
    const double a = rings.centre_mm(low);
    const double part = (y_mm - a) / (rings.centre_mm(low + 1) - a);
    return column[static_cast<std::size_t>(low)] +
           part * (column[static_cast<std::size_t>(low) + 1] - column[static_cast<std::size_t>(low)]);
}

TEST(StudioExport, StaysWithinTwentyMicrometresOfBothWalls) {
    std::size_t outside = 0;
    std::size_t inside = 0;
    for (const StudioSample& pot : samples()) {
        if (!pot.calm) continue;
        const clay::studio::Rings& rings = pot.clay.rings();
        const double scale = clay::shrunk_scale(pot.clay.lump().body, pot.stage);
        const support::GlbFile file = glb_of(pot);
        double worst = 0.0;
        for (std::size_t i = 0; i < file.mesh.positions_m.size(); ++i) {
            const dvec3 p = file.mesh.positions_m[i] / (kMetresPerMm * scale);
            const dvec3& normal = file.mesh.normals[i];
            if (std::fabs(normal.y) > 0.999 || !(p.y > 0.0 && p.y < pot.clay.height_mm())) continue;
            const bool is_inside = normal.x * p.x + normal.z * p.z < 0.0;
            const double face = radius_at(rings, is_inside ? rings.inner_mm : rings.outer_mm, p.y);
            if (face < 0.5) continue;
            const auto ring = static_cast<std::size_t>(rings.ring_at(p.y));
            const dvec2 from_centre(p.x - static_cast<double>(rings.centre_x_mm[ring]),
                                    -p.z - static_cast<double>(rings.centre_z_mm[ring]));
            worst = std::max(worst, std::fabs(glm::length(from_centre) - face));
            ++(is_inside ? inside : outside);
        }
        EXPECT_LT(worst, 0.02 + 4e-4 * 90.0) << pot.name;  // corners lie outside the circle (pot_solid.h)
    }
    EXPECT_GT(outside, 10000U);
    EXPECT_GT(inside, 10000U);
}

TEST(StudioExport, OfCalmPotsIsOfOneOfTheTwoFinestSettings) {
    for (const StudioSample& pot : samples()) {
        const auto solid = exporter::build_pot_solid(exporter::rings_of(pot.clay.rings()));
        ASSERT_TRUE(solid) << pot.name;
        EXPECT_LE(solid->mesh.triangle_count(), exporter::kMaxTriangles) << pot.name;
        if (!pot.calm) continue;
        EXPECT_GE(solid->corners, 96) << pot.name;
        EXPECT_LE(solid->tolerance_mm, 0.016) << pot.name;
        EXPECT_NEAR(solid->across_scale, 1.0003, 4e-4) << pot.name;
    }
}

TEST(StudioExport, KeepsADentWhereTheFingerWas) {
    const auto& all = samples();
    const auto dented =
        std::find_if(all.begin(), all.end(), [](const auto& pot) { return pot.name == "studio_dented"; });
    ASSERT_NE(dented, all.end());
    const support::GlbFile file = glb_of(*dented);
    // The outer wall, 69 to 71 mm high: nearest the axis at +X, where the finger was; round on the far side.
    double least = 1e9;
    double least_angle = 0.0;
    double far_mean = 0.0;
    int far = 0;
    for (std::size_t i = 0; i < file.mesh.positions_m.size(); ++i) {
        const dvec3 p = file.mesh.positions_m[i] / kMetresPerMm;
        const dvec3& normal = file.mesh.normals[i];
        if (!(p.y > 68.0 && p.y < 72.0) || normal.x * p.x + normal.z * p.z < 0.0) continue;
        const double radius = std::hypot(p.x, p.z);
        if (radius < least) {
            least = radius;
            least_angle = std::atan2(-p.z, p.x);
        }
        if (p.x < -30.0) {
            far_mean += radius;
            ++far;
        }
    }
    ASSERT_GT(far, 10);
    EXPECT_NEAR(least_angle, 0.0, 0.1);
    EXPECT_GT(far_mean / far - least, 2.0);
    EXPECT_NEAR(far_mean / far, 45.0, 1.0);
}

TEST(StudioExport, PutsOffCentreClayOnTheSideWhereItIs) {
    clay::StudioClay pot({.mass_g = 500.0});
    pot.set_wall(40.0, 5.0, 10.0, 50.0, 200);
    pot.set_centre({1.0, 3.0});
    const auto solid = exporter::build_pot_solid(exporter::rings_of(pot.rings()));
    ASSERT_TRUE(solid);
    dvec3 low(1e9);
    dvec3 high(-1e9);
    for (const vec3& p : solid->mesh.positions_m) {
        low = glm::min(low, dvec3(p));
        high = glm::max(high, dvec3(p));
    }
    // The clay's second direction is -Z.
    EXPECT_NEAR(0.5 * (low.x + high.x), 0.001, 1e-6);
    EXPECT_NEAR(0.5 * (low.z + high.z), -0.003, 1e-6);
}

TEST(StudioExport, TellsItsMeasuresAndItsLedger) {
    for (const StudioSample& pot : samples()) {
        const nlohmann::json json = glb_of(pot).json;
        const nlohmann::json& extras = json.at("asset").at("extras");
        const double scale = clay::shrunk_scale(pot.clay.lump().body, pot.stage);
        EXPECT_NEAR(extras.at("height_mm").get<double>(), pot.clay.height_mm() * scale, 1e-9) << pot.name;
        EXPECT_NEAR(extras.at("volume_mm3").get<double>(), clay_mm3(pot.clay) * scale * scale * scale,
                    1e-6 * clay_mm3(pot.clay))
            << pot.name;
        EXPECT_NEAR(extras.at("fired_height_mm").get<double>(),
                    pot.clay.height_mm() * (1.0 - clay::linear_shrinkage(pot.clay.lump().body)), 1e-9)
            << pot.name;
        EXPECT_EQ(extras.at("ledger_error_mm3"), 0.0) << pot.name;
        EXPECT_EQ(extras.at("ledger_lump_mm3").get<double>(),
                  extras.at("ledger_on_wheel_mm3").get<double>() +
                      extras.at("ledger_trimmings_mm3").get<double>() +
                      extras.at("ledger_slip_mm3").get<double>())
            << pot.name;
        EXPECT_EQ(extras.at("stage"), exporter::name_of(pot.stage)) << pot.name;
    }
}

TEST(StudioExport, TellsTheWallEveryFiveMillimetresOfACylinder) {
    clay::StudioClay pot({.mass_g = 500.0});
    pot.set_wall(45.0, 6.5, 12.0, 112.0, 1000);
    const auto extras = exporter::pot_extras(pot, clay::Firing::kWet);
    const auto find = [&](std::string_view name) {
        return std::find_if(extras.begin(), extras.end(),
                            [&](const auto& extra) { return extra.first == name; })
            ->second;
    };
    const auto heights = std::get<std::vector<double>>(find("wall_y_mm"));
    const auto walls = std::get<std::vector<double>>(find("wall_mm"));
    ASSERT_EQ(heights.size(), 20U);  // 15 to 110
    ASSERT_EQ(walls.size(), 20U);
    EXPECT_EQ(heights.front(), 15.0);
    EXPECT_EQ(heights.back(), 110.0);
    for (const double wall : walls)
        EXPECT_DOUBLE_EQ(wall, 6.5);
    EXPECT_NEAR(std::get<double>(find("capacity_ml")), 465.66, 0.5);
    EXPECT_NEAR(std::get<double>(find("mass_g")), pot.volume_mm3() * 1.9e-3, 1e-9);
    EXPECT_DOUBLE_EQ(std::get<double>(find("mouth_mm")), 90.0);
    EXPECT_EQ(std::get<std::string>(find("body")), "stoneware");
}

// Corners at one height, about their own middle: the pot may stand beside the axis.
double diameter_mm_at(const support::SolidMesh& mesh, double y_m) {
    dvec3 middle(0.0);
    std::vector<dvec3> corners;
    for (const dvec3& at : mesh.positions_m)
        if (std::abs(at.y - y_m) < 1e-6 && std::hypot(at.x, at.z) > 2e-3) corners.push_back(at);
    for (const dvec3& at : corners)
        middle += at / static_cast<double>(corners.size());
    double radius_m = 0.0;
    for (const dvec3& at : corners)
        radius_m = std::max(radius_m, std::hypot(at.x - middle.x, at.z - middle.z));
    return 2e3 * radius_m;
}

TEST(StudioExport, TellsTheDimensionsThatItsMeshHas) {
    int measured = 0;
    for (const StudioSample& pot : samples()) {
        if (!pot.calm) continue;
        const support::GlbFile file = glb_of(pot);
        const auto said = [&](const char* name) {
            return file.json.at("asset").at("extras").at(name).get<double>();
        };
        constexpr double kMostOffMm = 0.1;
        const double height_m = file.stated_max_m.y;
        EXPECT_NEAR(said("height_mm"), 1e3 * height_m, kMostOffMm) << pot.name;
        EXPECT_NEAR(said("mouth_mm"), diameter_mm_at(file.mesh, height_m), kMostOffMm) << pot.name;
        EXPECT_NEAR(said("foot_mm"), diameter_mm_at(file.mesh, 0.0), kMostOffMm) << pot.name;
        double widest_mm = 0.0;
        for (const dvec3& at : file.mesh.positions_m)
            widest_mm = std::max(widest_mm, diameter_mm_at(file.mesh, at.y));
        EXPECT_NEAR(said("max_diameter_mm"), widest_mm, kMostOffMm) << pot.name;
        ++measured;
    }
    EXPECT_GE(measured, 4);
}

TEST(StudioExport, RefusesClayThatIsNoPot) {
    clay::StudioClay flat({.mass_g = 500.0});
    flat.set_wall(45.0, 5.0, 0.5, 0.8, 8);
    const auto refused = exporter::pot_file(flat, clay::Firing::kWet);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(refused.error().message.find("expected a height of 1"), std::string::npos);
}

}  // namespace
}  // namespace onggi
